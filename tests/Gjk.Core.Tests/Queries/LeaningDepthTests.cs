namespace Gjk.Core.Tests.Queries;

/// <summary>Bodies of revolution whose axes lean against each other by up to a fiftieth: the shortest way out lies in a
/// valley around the axis, whose floor rises by less than the lean. The general search has no room for it.</summary>
public class LeaningDepthTests
{
    private const string Spheroids =
        "gjk1 ellipsoid 1 2 1 @ 0 0 0 1 0 0 0 ellipsoid 1.5 0.7 1.5 @ 0.0001 0 0 1 0 0.2 0";

    private const string Leaning =
        "gjk1 ellipsoid 0.9608340859413147 1.9374927282333374 0.9608340859413147 @ 0 0 0 1 0 0 0 ellipsoid "
        + "0.9608340859413147 1.9374927282333374 0.9608340859413147 @ -0.00733488845 0.000467084436 0.00687694969 1 "
        + "5.83141702E-10 0.00657802308 2.29163563E-11";

    private const string Stuck =
        "gjk1 cylinder 0.95926713943481445 0.5270388126373291 0 @ 0 0 0 1 0 0 0 ellipsoid 1 2 1 @ -5.84579211E-05 "
        + "-3.74554538E-08 -6.3505955E-05 1 0 -0.277797103 0";

    [Theory]
    [InlineData(Spheroids)]
    [InlineData(Leaning)]
    [InlineData(Stuck)]
    public void WhatEndedAtTheLimitEnds(string record)
    {
        QueryRecord pair = QueryRecord.Parse(record);
        DistanceResult r = ConvexQuery.SignedDistance(pair.A, pair.PoseA, pair.B, pair.PoseB);
        Assert.True(r.IsOverlapping && r.Iterations < 4000, $"{r} {r.Iterations}");
    }

    /// <summary>Cold, warm and swapped, they have one answer, and no way out is shorter.</summary>
    [Theory]
    [InlineData(1e-6)]
    [InlineData(1e-5)]
    [InlineData(1e-4)]
    [InlineData(1e-3)]
    [InlineData(1e-2)]
    public void AllWaysToAskAgree(double lean)
    {
        for (ulong seed = 0; seed < (ulong)Budget.Count(40); seed++)
        {
            var rng = new Rng(78_000 + seed);
            TestShape a = Body(rng), b = rng.Below(3) == 0 ? a : Body(rng);
            Vector3 axis = rng.UnitVector();
            var turn = new Quaternion(axis.X * (float)lean / 2, 0, axis.Z * (float)lean / 2, 1);
            Vector3 aside = rng.Below(2) == 0 ? Vector3.Zero : rng.UnitVector() * rng.LogFloat(1e-9, lean);
            var pose = new RigidPose(turn, new Vector3(0, rng.Float(-0.3, 0.3), 0) + aside);
            var pair = new TestPair($"lean {lean}, seed {seed}", a, RigidPose.Identity, b, pose);
            WarmStart warm = default;
            var beside = new RigidPose(turn, pose.Position + (rng.UnitVector() * 1e-3f));
            ConvexQuery.SignedDistance(a.Shape, RigidPose.Identity, b.Shape, beside, ref warm);
            DistanceResult cold = pair.SignedDistance(), swapped = pair.Swapped.SignedDistance();
            DistanceResult again = ConvexQuery.SignedDistance(a.Shape, RigidPose.Identity, b.Shape, pose, ref warm);
            double band = 1e-6 * pair.Scale;
            Assert.True(cold.IsOverlapping && swapped.IsOverlapping && again.IsOverlapping, $"{cold}: {pair}");
            Assert.True(Math.Abs(cold.Distance - swapped.Distance) <= band, $"{cold}, swapped {swapped}: {pair}");
            Assert.True(Math.Abs(cold.Distance - again.Distance) <= band, $"{cold}, warm {again}: {pair}");
            double truth = CheapestWay.Of(pair, cold.Normal, seed);
            Assert.True(-cold.Distance <= truth + band, $"{cold}, but a way costs {truth:R}: {pair}");
        }
    }

    private static TestShape Body(Rng rng)
    {
        float r = rng.Float(0.4, 1.5), h = rng.Float(0.4, 1.5);
        return rng.Below(4) switch
        {
            0 => TestShape.Cone(r, h),
            1 => TestShape.Cylinder(r, h),
            2 => TestShape.Capsule(0.7f * r, h),
            _ => TestShape.Ellipsoid(new Vector3(r, h, r)),
        };
    }
}
