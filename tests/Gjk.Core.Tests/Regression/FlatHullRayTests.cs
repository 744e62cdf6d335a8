using Gjk.Core.Tests.Support.Rays;

namespace Gjk.Core.Tests.Regression;

/// <summary>Hulls that are solids to exact predicates and flat but for rounding: a disc turned by 90 degrees in double,
/// a corner lifted by next to nothing. The planes of their facets are parallel but for rounding. A ray that was clipped
/// by them hit thin air, up to 4e5 sizes away from the hull, and missed its middle.</summary>
public class FlatHullRayTests
{
    private delegate Vector3 Corner(Rng rng, double x, double y, float lift);

    [Fact]
    public void ARayBesideALiftedCornerMisses()
    {
        ConvexShape hull = ConvexShape.Mesh([new(1, 0, 0), new(0, 1, 1e-17f), new(-1, 0, 0), new(0, -1, 0)]);
        var pose = new RigidPose(Quaternion.Normalize(new(0.2f, -0.3f, 0.1f, 0.9f)), Vector3.Zero);
        Vector3 origin = new(-1.0053257f, -1.5570241f, -0.1319573f);
        Vector3 along = new(0.54320824f, 0.31503785f, -0.13443482f);
        Assert.Equal(CastStatus.Miss, ConvexQuery.RayCast(hull, pose, origin, along).Status);
        CastResult cast = ConvexQuery.Cast(
            hull, pose, default, ConvexShape.Point(), new RigidPose(origin), along, 100);
        Assert.Equal(CastStatus.Miss, cast.Status);
    }

    [Fact]
    public void ATurnedDiscIsHitWhereItIs() => Each((_, x, y, _) =>
        new((float)x, (float)(y * Math.Cos(Math.PI / 2)), (float)(y * Math.Sin(Math.PI / 2))));

    [Fact]
    public void AnUnevenDiscIsHitWhereItIs() => Each((rng, x, y, lift) =>
        new((float)x, rng.Float(-1, 1) * lift, (float)y));

    [Fact]
    public void ANeedleIsHitWhereItIs() => Each(
        (rng, x, y, lift) => new((float)x, rng.Float(-1, 1) * lift, (float)y * lift), isNeedle: true);

    /// <summary>Polygons of some corners, in any pose, against exact arithmetic.</summary>
    /// <param name="make">A corner on the unit circle becomes one of the hull.</param>
    /// <param name="isNeedle">Whether nearly all rays miss.</param>
    private static void Each(Corner make, bool isNeedle = false)
    {
        int hits = 0, asked = 0, count = Budget.Count(150);
        for (int i = 0; i < count; i++)
        {
            var rng = new Rng((ulong)i);
            float lift = rng.LogFloat(1e-17, 1e-9);
            int corners = 4 + rng.Below(3);
            Vector3[] cloud =
            [
                .. Enumerable.Range(0, corners).Select(k => 2 * Math.PI * k / corners)
                    .Select(angle => make(rng, Math.Cos(angle), Math.Sin(angle), lift)),
            ];
            var hull = new ConvexHull(cloud);
            if (hull.Dimension < 3) continue;
            var body = new PolytopeReference([.. cloud.Select(c => (Double3)c)]);
            var shape = new RayShape($"seed {i}", ConvexShape.Mesh(hull), body, Vector3.One, 2);
            RigidPose pose = Generators.Pose(rng, rng.Vector(-1, 1));
            for (int k = 0; k < 4; k++)
            {
                Vector3 local = (cloud[0] * rng.Float(-1, 1) + cloud[1] * rng.Float(-1, 1)) * 1.2f;
                Vector3 direction = rng.UnitVector();
                Vector3 origin = pose.TransformPoint(local) - direction * rng.Float(1, 50);
                if (!IsClear(shape, pose, origin, direction, out TrueHit truth)) continue;
                asked++;
                if (truth.Status == CastStatus.Hit) hits++;
                Check(shape, pose, origin, direction, truth);
            }
        }

        Assert.InRange(hits, isNeedle ? 0 : 0.3 * asked, 0.7 * asked);
        Assert.True(asked > count, $"{asked} rays");
    }

    /// <summary>Whether rays beside it, by a millionth of the size, meet the same.</summary>
    private static bool IsClear(
        RayShape shape, RigidPose pose, Vector3 origin, Vector3 direction, out TrueHit truth)
    {
        TrueHit met = shape.Cast(pose, origin, direction, double.PositiveInfinity);
        truth = met;
        Vector3[] beside = [Vector3.UnitX, Vector3.UnitY, Vector3.UnitZ];
        return beside.Concat(beside.Select(b => -b)).All(b =>
        {
            TrueHit other = shape.Cast(pose, origin + b * 1e-5f, direction, double.PositiveInfinity);
            return other.Status == met.Status && !(Math.Abs(other.Distance - met.Distance) > 1e-3);
        });
    }

    private static void Check(
        RayShape shape, in RigidPose pose, Vector3 origin, Vector3 direction, in TrueHit truth)
    {
        RayCastResult ray = ConvexQuery.RayCast(shape.Shape, pose, origin, direction);
        CastResult cast = ConvexQuery.Cast(
            shape.Shape, pose, default, ConvexShape.Point(), new RigidPose(origin), direction, 100);
        string asked = $"{shape.Text}, {TestShape.T(pose)} from {origin} along {direction}";
        string text = $"{asked}: {ray}, {cast}, truly {truth}";
        Assert.True(ray.Status == truth.Status && cast.Status == truth.Status, text);
        if (truth.Status != CastStatus.Hit) return;
        double error = 1e-7 * Math.Max(2, truth.Distance);
        Assert.True(Math.Abs(ray.Distance - truth.Distance) <= error, text);
        Assert.True(Math.Abs(cast.Fraction * ((Double3)direction).Length - truth.Distance) <= error, text);
        Assert.True(!truth.IsNormalUnique || ((Double3)ray.Normal - truth.Normal).Length <= 1e-6, text);
    }
}
