namespace Gjk.Core.Tests.Queries;

/// <summary>Depths of small bodies well inside a cylinder: out along its axis or across it.</summary>
public class CylinderDepthTests
{
    private const string Beside =
        "gjk1 cylinder 3.3367733955383301 0.31701585650444031 0 @ 0.337533593 -0.566648424 -0.206062719 0.722854614 0 "
        + "0 0 cylinder 0.21898871660232544 0.078312605619430542 0 @ -0.50339818 0.236902148 -0.689208448 0.464176029 "
        + "0.0109233307 0.00661444804 -0.0119604776";

    private const string Cone =
        "gjk1 cylinder 47.300514221191406 30.022415161132812 0 @ -0.86334759 0.498341441 -0.0193025097 -0.0769027919 0 "
        + "0 0 cone 0.43124881386756897 0.30825909972190857 0 @ -0.325341195 -0.542248666 0.566236258 0.528673887 "
        + "-0.000189975093 0.000606915622 0.000372738868";

    private const string Across =
        "gjk1 cylinder 2 9 0 @ 0.5 0.5 0.5 0.5 0 0 0 cone 0.1 0.05 0 @ 0.1 0.2 0.3 0.9273618495 0.9 0.4 0.7";

    private const string Turned =
        "gjk1 cylinder 1.6757532358169556 3.2785525321960449 0 @ 0.498648852 -0.755179465 -0.425159633 0.0171024241 0 "
        + "0 0 cylinder 0.047790911048650742 0.14144520461559296 0 @ 0.684264123 -0.175895944 -0.18102999 -0.684157491 "
        + "-0.157083228 0.0623832643 -0.0528160818";

    /// <summary>Few supports tell it, where the general search takes dozens.</summary>
    [Theory]
    [InlineData(Beside, 16)]
    [InlineData(Cone, 16)]
    [InlineData(Across, 40)]
    [InlineData(Turned, 48)]
    public void FewSupportsTellIt(string record, int most)
    {
        QueryRecord pair = QueryRecord.Parse(record);
        DistanceResult r = ConvexQuery.SignedDistance(pair.A, pair.PoseA, pair.B, pair.PoseB);
        Assert.True(r.IsOverlapping && r.Iterations <= most, $"{r} {r.Iterations}");
        Assert.True(r.LowerBound >= r.Distance * 1.000001f, $"{r} {r.LowerBound}");
    }

    /// <summary>No way out is shorter, in either order: of bodies near the end and the side, on the axis and beside it,
    /// far smaller than the cylinder and just small enough.</summary>
    [Fact]
    public void NoWayOutIsShorter()
    {
        int along = 0, across = 0, count = Budget.Count(300);
        for (ulong seed = 0; seed < (ulong)count; seed++)
        {
            var rng = new Rng(91_000 + seed);
            float radius = rng.LogFloat(0.2, 5), half = rng.LogFloat(0.2, 5);
            float size = Math.Min(radius, half) * rng.LogFloat(0.01, 0.7);
            TestShape inner = Body(rng, size), outer = TestShape.Cylinder(radius, half);
            float side = rng.Below(3) == 0 ? rng.LogFloat(1e-9, 1) : rng.Float(0, 1), angle = rng.Float(0, 6);
            var place = new Vector3(MathF.Cos(angle) * side * radius, rng.Float(-1, 1) * half, MathF.Sin(angle) * side);
            var pose = new RigidPose(rng.Rotation(), rng.Vector(-3, 3));
            var inside = new RigidPose(rng.Rotation(), pose.TransformPoint(place));
            var pair = new TestPair($"seed {seed}", outer, pose, inner, inside);
            DistanceResult r = pair.SignedDistance(), swapped = pair.Swapped.SignedDistance();
            if (!r.IsOverlapping) continue;
            double band = 1e-6 * pair.Scale, truth = CheapestWay.Of(pair, r.Normal, seed);
            Assert.True(-r.Distance <= truth + band, $"{r}, but a way costs {truth:R}: {pair}");
            Assert.True(Math.Abs(r.Distance - swapped.Distance) <= band, $"{r}, swapped {swapped}: {pair}");
            double lean = Math.Abs(Vector3.Dot(r.Normal, Vector3.Transform(Vector3.UnitY, pose.Rotation)));
            if (lean > 0.9999) along++;
            else if (lean < 0.0001) across++;
        }

        Assert.True(Math.Min(along, across) > count / 5, $"{along} {across}");
    }

    /// <summary>A rod that is not small enough, and leans by half a right angle, leaves over the rim.</summary>
    [Theory]
    [InlineData(1.02f)]
    [InlineData(1.2f)]
    [InlineData(1.5f)]
    public void ARodLeavesOverTheRim(float room)
    {
        var turn = Quaternion.CreateFromAxisAngle(Vector3.UnitZ, MathF.PI / 4);
        ConvexShape cylinder = ConvexShape.Cylinder(3 + room, 3 + room), rod = ConvexShape.Cylinder(0.01f, 1);
        DistanceResult r = ConvexQuery.SignedDistance(
            cylinder, RigidPose.Identity, rod, new RigidPose(turn, new Vector3(3, 3, 0)));
        Assert.Equal(room * MathF.Sqrt(2) + 0.01f, -r.Distance, 4);
        Assert.Equal(MathF.Sqrt(0.5f), r.Normal.Y, 3);
    }

    private static TestShape Body(Rng rng, float size)
    {
        float r = size * rng.Float(0.1, 1), h = size * rng.Float(0.1, 1);
        return rng.Below(4) switch
        {
            0 => TestShape.Cone(r, h),
            1 => TestShape.Cylinder(r, h),
            2 => TestShape.Capsule(0.7f * r, h),
            _ => TestShape.Ellipsoid(new Vector3(r, h, size * 0.5f)),
        };
    }
}
