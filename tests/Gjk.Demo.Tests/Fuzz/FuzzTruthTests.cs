using Gjk.Exact.Fuzz;
using Gjk.Exact.Fuzz.Families;
using Gjk.Exact.Fuzz.Promises;

namespace Gjk.Demo.Tests.Fuzz;

/// <summary>Tests the truth that fuzz compares with: clouds instead of hulls, exact contacts, heights by formula, and
/// error bands that no generous radius widens.</summary>
public sealed class FuzzTruthTests
{
    private static readonly Vector3[] Corners = Clouds.Box(new Vector3(-0.5f));

    private static readonly RigidPose Right = new(new Vector3(2, 0.25f, 0.125f));

    /// <summary>A hull that lost a corner of its cloud. Both the supports and the true distance show it.</summary>
    [Fact]
    public void ALostCornerIsNoticed()
    {
        Vector3[] cloud = [.. Corners, new(0.75f, 0, 0)];
        var pair = new FuzzPair(
            FuzzShape.Of(ConvexShape.Mesh(Corners), cloud), RigidPose.Identity, ConvexShape.Mesh(Corners), Right);
        Assert.Contains(
            "lower than the highest point", SupportsReachTheCloud.Broken(pair), StringComparison.Ordinal);
        Assert.Contains("truly 0.75", TheExactAnswer.Broken(pair), StringComparison.Ordinal);
    }

    /// <summary>The reported line holds all points of a mesh and reproduces the same pair.</summary>
    [Fact]
    public void ThePairsLineKeepsTheCloud()
    {
        Vector3[] cloud = [.. Corners, Vector3.Zero, new(0.1f, 1e-30f, -0.2f)];
        var pair = new FuzzPair(
            FuzzShape.Mesh(cloud).Scaled(new Vector3(2, -3, 0.5f)), RigidPose.Identity, ConvexShape.Sphere(1), Right);
        Assert.StartsWith("gjk1 mesh 10 -0.5 -0.5 -0.5 ", pair.Text, StringComparison.Ordinal);
        Assert.True(FuzzPair.TryParse(pair.Text, out FuzzPair? again));
        Assert.Equal(pair.Text, again.Text);
        Assert.Equal(pair.BodyA.Vertices, again.BodyA.Vertices);
        Assert.True(QueryRecord.TryParse(pair.Text, out _, out string? reason), reason);
    }

    /// <summary>Rational rotations turn lattice points without rounding. Their quaternions are exact, or rounded to
    /// float.</summary>
    [Fact]
    public void IntegerRotationsAreExact()
    {
        int exact = 0;
        for (ulong seed = 0; seed < 500; seed++)
        {
            var random = new Rng(seed);
            IntegerRotation r = IntegerRotation.Any(random).Times(IntegerRotation.AboutY(random));
            Double3 v = r.Exactly(new Double3(3, -2, 5) * r.Norm);
            Assert.True(
                v.X == Math.Round(v.X) && v.Y == Math.Round(v.Y) && v.Z == Math.Round(v.Z),
                $"{r}: {v.X}, {v.Y}, {v.Z}");
            Assert.Equal(38.0 * r.Norm * r.Norm, v.LengthSquared);
            Quaternion q = r.ToQuaternion(random);
            _ = new RigidPose(q, Vector3.Zero);
            int[] ratios = [r.X, r.Y, r.Z, r.W];
            int most = Enumerable.Range(0, 4).MaxBy(i => Math.Abs(ratios[i]));
            if (Enumerable.Range(0, 4).All(i => (double)q[i] * ratios[most] == (double)q[most] * ratios[i])) exact++;
        }

        Assert.InRange(exact, 300, 500);
    }

    /// <summary>Bodies at rest with no gap really touch. They overlap, and they separate when one is lifted by a tiny
    /// amount.</summary>
    [Fact]
    public void RestingBodiesTouchExactly()
    {
        int touching = 0, known = 0;
        for (ulong seed = 0; seed < 400; seed++)
        {
            FuzzPair pair = RestFamilies.Resting(new Rng(seed));
            if (!pair.Truth.IsKnown) continue;
            known++;
            Double3 up = new PosedShape(ConvexShape.Point(), new RigidPose(pair.PoseA.Rotation, Vector3.Zero)).Rotate(
                new Double3(0, 1, 0));
            if (pair.Truth.Answer.Overlap && pair.Truth.PartsWith(up * (1e-14 * pair.Scale))) touching++;
        }

        Assert.True(known > 200 && touching > 60, $"{touching} of {known} touch");
    }

    /// <summary>Compares the formulas with the furthest of many points on the surface.</summary>
    [Theory]
    [InlineData("cylinder 0.5 2 0")]
    [InlineData("cone 0.5 2 0")]
    [InlineData("cone 0.5 2 0 * 3 -1 0.25")]
    [InlineData("ellipsoid 0.5 2 1.25")]
    [InlineData("taperedcapsule 0.5 0.25 1")]
    [InlineData("taperedcapsule 0.5 2 1 * 2 -2 2")]
    [InlineData("taperedcapsule 0.5 0.25 1 * 3 -1 0.25")]
    [InlineData("segment 0 1 0 0 -1 0 0.5 * 1 2 3")]
    public void CurvedHeightsAreThoseOfTheShape(string shape)
    {
        Assert.True(FuzzPair.TryParse($"gjk1 {shape} @ 0 0 0 1 0 0 0 point 0 @ 0 0 0 1 9 9 9", out FuzzPair? pair));
        Assert.True(pair.BodyA.IsCurved);
        foreach (Double3 d in Directions.Many)
        {
            double highest = double.NegativeInfinity;
            foreach (Double3 u in Directions.Many)
            {
                pair.A.Support(u, out Double3 point);
                highest = Math.Max(highest, Double3.Dot(d, point));
            }

            pair.A.Support(d, out Double3 furthest);
            Assert.Equal(Double3.Dot(d, furthest), pair.BodyA.CoreHeight(d), 1e-14);
            Assert.True(pair.BodyA.CoreHeight(d) >= highest - 1e-14);
        }
    }

    /// <summary>A cube that is stored two million times as long and scaled back is a cube. Its scale, noise and bands
    /// are those of the cube.</summary>
    [Fact]
    public void AnUnevenScaleWidensNoBand()
    {
        const float Long = 1 << 21;
        FuzzShape stretched = FuzzShape.Mesh([.. Corners.Select(p => p with { X = p.X * Long })]).Scaled(
            new Vector3(1 / Long, 1, 1));
        FuzzPair plain = new(FuzzShape.Mesh(Corners), RigidPose.Identity, FuzzShape.Mesh(Corners), Right);
        FuzzPair scaled = new(stretched, RigidPose.Identity, stretched, Right);
        Assert.Equal((1, plain.Noise, plain.Band(1)), (scaled.Scale, scaled.Noise, scaled.Band(1)));
        Assert.Equal(1, scaled.Truth.Answer.Distance);
    }
}
