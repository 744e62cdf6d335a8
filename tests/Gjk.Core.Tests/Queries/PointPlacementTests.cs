namespace Gjk.Core.Tests.Queries;

/// <summary>Each shape's point is its local point in the world, to float rounding of what is that shape's own; and the
/// two are the distance apart along the normal. For sizes up to 1e7 times apart, either way round.</summary>
public class PointPlacementTests
{
    private const double FloatUnit = 1.0 / (1 << 24);

    /// <summary>Units of float rounding: the local point's, the world point's, and what is left of the solver's
    /// rounding where B is almost a thousand times smaller than A.</summary>
    private const double MostUnits = 4;

    private static readonly string[] Kinds = [.. Generators.AllKinds, "bigHull"];

    [Theory]
    [InlineData(1e-7, 1e-3)]
    [InlineData(1e-3, 1e-1)]
    [InlineData(1e-1, 1e1)]
    [InlineData(1e1, 1e3)]
    [InlineData(1e3, 1e7)]
    [InlineData(2e5, 1e6)]
    public void ThePointsAgreeWithTheLocalPoints(double least, double most)
    {
        for (int i = 0; i < Budget.Count(3000); i++)
        {
            var rng = new Rng((ulong)i);
            TestPair pair = Make(rng, rng.LogFloat(least, most), $"seed {i}, ratio {least} to {most}");
            Check(pair, pair.Distance());
            Check(pair, pair.SignedDistance());
        }
    }

    /// <summary>B's world origin is within B, so that its points are small numbers; and the same for A.</summary>
    private static TestPair Make(Rng rng, float ratio, string name)
    {
        TestShape a = Generators.Shape(rng, Kinds[rng.Below(Kinds.Length)]).Scaled(new Vector3(ratio));
        TestShape b = Generators.Shape(rng, Kinds[rng.Below(Kinds.Length)]);
        (TestShape large, TestShape small) = a.Reach > b.Reach ? (a, b) : (b, a);
        Quaternion turn = rng.Rotation();
        Vector3 direction = rng.UnitVector();
        Double3 place = rng.Below(4) switch
        {
            0 => (Double3)direction * (large.Reach * rng.LogFloat(1, 1e4)),
            1 => (Double3)direction * (large.Reach * rng.Float(0, 1)),
            _ => OnSurface(rng, large.Shape, turn, direction)
                + (Double3)direction * (small.Reach * rng.Range(-2, 1.5)),
        };
        RigidPose near = Generators.Pose(rng, rng.Vector(-1, 1) * (float)small.Reach);
        RigidPose far = new(turn, (Vector3)(near.Position - place));
        return large == a ? new TestPair(name, a, far, b, near) : new TestPair(name, a, near, b, far);
    }

    /// <summary>A point between two of the furthest in directions that are nearly the same.</summary>
    private static Double3 OnSurface(Rng rng, in ConvexShape shape, Quaternion turn, Vector3 direction)
    {
        var body = new Body<ConvexShape>(shape, new RigidPose(turn, default));
        shape.Support(body.InverseRotate(direction), out Double3 p);
        shape.Support(body.InverseRotate(direction + rng.UnitVector() * 0.01f), out Double3 q);
        return body.Rotate(shape.Center + p + (q - p) * rng.Unit()) + (Double3)direction * shape.Margin;
    }

    private static void Check(TestPair pair, in DistanceResult r)
    {
        if (r.Status is not (GjkStatus.Separated or GjkStatus.Overlapping or GjkStatus.IterationLimit)) return;
        AssertNear(pair, r, new Body<ConvexShape>(pair.A.Shape, pair.PoseA), r.LocalPointA, r.PointA);
        AssertNear(pair, r, new Body<ConvexShape>(pair.B.Shape, pair.PoseB), r.LocalPointB, r.PointB);
        Double3 reached = (Double3)r.PointA + (Double3)r.Normal * r.Distance;
        double unit = FloatUnit * (Largest(r.PointA) + Largest(r.PointB) + Math.Abs(r.Distance));
        double off = (reached - r.PointB).Length;
        Assert.True(off <= MostUnits * unit, $"PointA + Normal * Distance is {off / unit:G3} units off: {r}\n{pair}");
    }

    private static void AssertNear(
        TestPair pair, in DistanceResult r, Body<ConvexShape> body, Vector3 local, Vector3 world)
    {
        double unit = FloatUnit * (body.Radius + Largest(local) + Largest(body.Pose.Position));
        double off = (body.ToWorld(local) - world).Length;
        Assert.True(off <= MostUnits * unit, $"{world} is {off / unit:G3} units beside {local}: {r}\n{pair}");
    }

    private static double Largest(Vector3 v) => Math.Max(Math.Max(Math.Abs(v.X), Math.Abs(v.Y)), Math.Abs(v.Z));
}
