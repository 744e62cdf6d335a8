using Gjk.Core.Tests.Support.Rays;

namespace Gjk.Core.Tests.Queries.Rays;

/// <summary>Bodies thinner than rounding at their size: in the axes in which they are round, the line begins far away.
/// Judged by a reference of 640 digits, with no excuse for a short chord.</summary>
public class RayThinTests
{
    private static readonly Vector3[] Thin =
        [new(1, 1e-6f, 1), new(1, 1e-11f, 1), new(1, 1e-16f, 1), new(1e-13f, 1, 1e-13f), new(1, 1e-30f, 1)];

    [Theory]
    [InlineData("box")]
    [InlineData("cylinder")]
    [InlineData("cone")]
    [InlineData("ellipsoid")]
    [InlineData("capsule")]
    public void ABodyIsMetWhereItIs(string kind) => Each(kind, Thin, (rng, thin) => RayShapes.Make(rng, kind, thin));

    [Theory]
    [InlineData("sphere")]
    [InlineData("box")]
    [InlineData("cylinder")]
    [InlineData("cone")]
    [InlineData("ellipsoid")]
    [InlineData("capsule")]
    [InlineData("hull")]
    public void ABodyThatIsFlattenedIsMetWhereItIs(string kind) => Each(
        kind, [.. Thin.Take(3), new(1e-9f, 1, 1), new(1, 1e-12f, 1e-5f)], (rng, thin) =>
            RayShapes.Scaled(RayShapes.Make(rng, kind, Vector3.One), thin * rng.Float(0.5, 2)));

    /// <summary>Through its centre a flat hull cuts nothing out of a line that is across it.</summary>
    [Fact]
    public void AFlatHullIsLeftAtItsCentre()
    {
        ConvexShape hull = ConvexShape.Mesh([new(1, 0, 0), new(0, 0, 0.78f), new(-0.6f, 0, 0), new(0, 0, -0.48f)]);
        foreach (float y in new[] { 0, 0.5f, 4 })
        {
            Vector3 above = (Vector3)hull.Center + new Vector3(0, y, 0);
            RayCastResult r = ConvexQuery.RayExit(hull, RigidPose.Identity, above, -Vector3.UnitY);
            Assert.Equal((CastStatus.Hit, y), (r.Status, r.Distance));
            Assert.Equal(-Vector3.UnitY, r.Normal);
        }
    }

    /// <summary>Seen from the edge, where the rounding of the foot turns the normal: from some two hundred sizes
    /// away.</summary>
    [Theory]
    [InlineData(1e-4f)]
    [InlineData(3e-4f)]
    public void APlateIsMetAtItsEdge(float thin)
    {
        int hits = 0;
        for (int i = 0; i < Budget.Few(3000); i++)
        {
            var rng = new Rng((ulong)i);
            RayShape shape = RayShapes.Make(rng, "ellipsoid", new Vector3(1, thin, 1));
            RigidPose pose = Generators.Pose(rng, rng.Vector(-1, 1));
            double angle = rng.Range(0, 2 * Math.PI);
            var turn = new RotationD(pose.Rotation);
            Double3 along = turn.Rotate(new Double3(Math.Cos(angle), 0, Math.Sin(angle)));
            Double3 aim = turn.Rotate(new Double3(0, rng.Range(-0.3, 0.3) * thin, 0)) + pose.Position;
            Vector3 direction = (Vector3)along, origin = (Vector3)(aim - along * rng.Range(100, 200));
            TrueHit truth = shape.Cast(pose, origin, direction, double.PositiveInfinity);
            if (truth.Status != CastStatus.Hit || truth.Exit - truth.Distance < 0.1) continue;
            hits++;
            Check($"seed {i}", shape, pose, origin, direction, truth);
        }

        Assert.True(hits > 100, $"{hits} hits");
    }

    private static void Each(string kind, Vector3[] sizes, Func<Rng, Vector3, RayShape> make)
    {
        int hits = 0, asked = 0, count = Budget.Few(60);
        for (int i = 0; i < count * sizes.Length; i++)
        {
            var rng = new Rng((ulong)i);
            RayShape shape = make(rng, sizes[i % sizes.Length]);
            RigidPose pose = Generators.Pose(rng, rng.Vector(-1, 1));
            shape.Shape.Support(rng.UnitVector(), out Double3 far);
            Double3 aim = shape.Shape.Center + far * rng.Range(-0.9, 0.9);
            Vector3 at = pose.TransformPoint((Vector3)aim) + rng.UnitVector() * rng.Float(0, 0.8);
            Vector3 direction = rng.UnitVector(), origin = at - direction * rng.LogFloat(1, 1e4);
            TrueHit truth = shape.Cast(pose, origin, direction, double.PositiveInfinity);
            if (!IsClear(shape, pose, origin, direction, truth)) continue;
            asked++;
            if (truth.Status == CastStatus.Hit) hits++;
            Check($"seed {i}", shape, pose, origin, direction, truth);
        }

        Assert.True(asked > 0.5 * count * sizes.Length && hits > 0.05 * asked, $"{kind}: {hits} of {asked}");
    }

    /// <summary>Whether rays beside it meet the same; a needle is hit by chance only, and never so.</summary>
    private static bool IsClear(
        RayShape shape, RigidPose pose, Vector3 origin, Vector3 direction, TrueHit truth)
    {
        float step = 1e-5f + origin.Length() * 1e-6f;
        return new[] { Vector3.UnitX, Vector3.UnitY, Vector3.UnitZ }.All(b =>
            shape.Cast(pose, origin + b * step, direction, double.PositiveInfinity).Status == truth.Status
            && shape.Cast(pose, origin - b * step, direction, double.PositiveInfinity).Status == truth.Status);
    }

    private static void Check(
        string name, RayShape shape, in RigidPose pose, Vector3 origin, Vector3 direction, in TrueHit truth)
    {
        RayCastResult r = ConvexQuery.RayCast(shape.Shape, pose, origin, direction);
        string text = $"{name}: {shape.Text}, {TestShape.T(pose)} from {origin} along {direction}: {r}, truly {truth}";
        Assert.True(r.Status == truth.Status, text);
        if (truth.Status != CastStatus.Hit) return;
        Assert.True(Math.Abs(r.Distance - truth.Distance) <= 1e-7 * Math.Max(shape.Scale, truth.Distance), text);
        if (truth.IsNormalUnique) Assert.True(((Double3)r.Normal - truth.Normal).Length <= 1e-6, text);
    }
}
