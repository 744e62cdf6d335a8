using Gjk.Core.Tests.Support.Rays;

namespace Gjk.Core.Tests.Queries.Rays;

/// <summary>Rays along faces that a quarter turn in floats leaves a rounding off level.</summary>
public class RayGrazeTests
{
    private static readonly Quaternion Quarter = new(0.70710677f, 0, 0, 0.70710677f);

    [Fact]
    public void AFlatBoxIsMetAtItsEdge()
    {
        ConvexShape flat = ConvexShape.Box(new Vector3(1, 2, 0));
        var pose = new RigidPose(Quarter, new Vector3(5, 0, 1));
        RayCastResult ray = ConvexQuery.RayCast(flat, pose, default, new Vector3(10, 0, 2));
        Assert.Equal(CastStatus.Hit, ray.Status);
        Assert.Equal(Math.Sqrt(16 + 0.64), ray.Distance, 1e-6f);
        CastResult cast = ConvexQuery.Cast(
            ConvexShape.Point(), RigidPose.Identity, default, flat, pose, new Vector3(-10, 0, -2));
        Assert.Equal((CastStatus.Hit, 0.4f), (cast.Status, cast.Fraction));
        CastResult along = ConvexQuery.Cast(
            ConvexShape.Box(new Vector3(1, 0.0007941765f, 1)), new RigidPose(Quarter, Vector3.Zero), default,
            ConvexShape.Point(), new RigidPose(new Vector3(-1, 1, -4.086669f)), new Vector3(0, 0, 8.171749f));
        Assert.Equal(CastStatus.Hit, along.Status);
        Assert.Equal(0.5f, along.Fraction, 1e-3f);
    }

    /// <summary>Along an end or a side, in its plane or a little tilted: the exact place and the normal of the surface
    /// that is met, be it the rim.</summary>
    [Theory]
    [InlineData("box")]
    [InlineData("cylinder")]
    [InlineData("cone")]
    public void ALineAlongAnEndIsExact(string kind)
    {
        int hits = 0, count = Budget.Count(kind == "box" ? 150 : 1000);
        for (int i = 0; i < count; i++)
        {
            var rng = new Rng((ulong)i);
            RayShape shape = RayShapes.Make(rng, kind, Vector3.One);
            RigidPose pose = new(rng.Below(2) == 0 ? Quarter : rng.Rotation(), rng.Vector(-1, 1));
            shape.Shape.Support(new Double3(0, -1, 0), out Double3 end);
            double angle = rng.Range(0, 2 * Math.PI), tilt = rng.Below(3) == 0 ? 0 : rng.LogFloat(1e-8, 1e-4);
            Double3 along = new(Math.Cos(angle), tilt, Math.Sin(angle));
            double height = end.Y - tilt * rng.Range(-0.5, 0.3) + rng.Range(-1e-6, 1e-6);
            Double3 aim = new Double3(0, height, 0) - along * rng.LogFloat(3, 300);
            Vector3 origin = pose.TransformPoint((Vector3)aim);
            var turn = new RotationD(pose.Rotation);
            Vector3 direction = Clean((Vector3)turn.Rotate(along));
            double slope = Math.Abs(turn.InverseRotate(direction).Y);
            double beside = turn.InverseRotate((Double3)origin - pose.Position).Y - end.Y;
            if (slope < 1e-15 ? Math.Abs(beside) < 1e-12 : slope < 1e-8) continue;
            hits += CheckExact($"seed {i}", shape, pose, origin, direction) ? 1 : 0;
        }

        Assert.InRange(hits, 0.2 * count, 0.8 * count);
    }

    /// <summary>Lines that touch a ball or a cylinder exactly, from two hundred radii away: a rounding of the foot
    /// would move the entry by the root of it.</summary>
    [Theory]
    [InlineData("sphere")]
    [InlineData("cylinder")]
    [InlineData("ellipsoid")]
    [InlineData("capsule")]
    public void ATangentIsMetWhereItTouches(string kind)
    {
        int hits = 0, count = Budget.Count(2000);
        ConvexShape shape = kind switch
        {
            "sphere" => ConvexShape.Sphere(1),
            "cylinder" => ConvexShape.Cylinder(1, 1),
            "ellipsoid" => ConvexShape.Ellipsoid(Vector3.One),
            _ => ConvexShape.Capsule(1, 1),
        };
        for (int i = 0; i < count; i++)
        {
            // (p, q, r) with p² + q² = r²: the line through (-q, p) / r along (p, q) touches the unit circle.
            var rng = new Rng((ulong)i);
            int m = 2 + rng.Below(30), n = 1 + rng.Below(m - 1);
            double p = m * m - n * n, q = 2 * m * n, r = m * m + n * n, away = rng.Range(1, 200);
            var origin = new Vector3((float)(-q / r - p / r * away), 0, (float)(p / r - q / r * away));
            double beside = (p * origin.Z - q * origin.X) / r;
            origin.Z *= (float)(1 / beside);
            origin.X *= (float)(1 / beside);
            if ((p * origin.Z - q * origin.X) / r is > 1 or < 1 - 1e-12) continue;
            RayCastResult ray = ConvexQuery.RayCast(shape, RigidPose.Identity, origin, new((float)p, 0, (float)q));
            if (!ray.IsHit) continue;
            hits++;
            double truth = -(p * origin.X + q * origin.Z) / r;
            Assert.True(Math.Abs(ray.Distance - truth) <= 1e-7 * Math.Max(2, truth), $"seed {i}: {ray}, truly {truth}");
        }

        Assert.True(hits > 10, $"{hits} hits");
    }

    /// <summary>The start is what Contains and the depth say, on faces, edges and corners.</summary>
    [Fact]
    public void AStartOnAFaceIsWhatContainsSays()
    {
        int starts = 0;
        for (int i = 0; i < Budget.Count(4000); i++)
        {
            var rng = new Rng((ulong)i);
            var half = new Vector3(1 + rng.Below(3), 1 + rng.Below(3), rng.Below(4)) / 2;
            ConvexShape shape = i % 2 == 0 ? ConvexShape.Box(half)
                : ConvexShape.Mesh([.. TestShape.Corners(half), new Vector3(0, 0, half.Z + 1)]);
            var pose = new RigidPose(Quarter, Half(rng, 6));
            Vector3 origin = Half(rng, 6), direction = Half(rng, 4);
            if (direction == Vector3.Zero) continue;
            RayCastResult r = ConvexQuery.RayCast(shape, pose, origin, direction);
            bool isIn = ConvexQuery.Contains(shape, pose, origin);
            float depth = -ConvexQuery.SignedDistance(shape, pose, origin).Distance;
            Assert.True((depth > 0) == (r.Status == CastStatus.OverlappingAtStart), $"seed {i}: {depth:R}, {r}");
            Assert.True(!isIn || r.Status == CastStatus.Miss || r.Distance == 0, $"seed {i}: {r}");
            if (isIn) starts++;
            if (r.Status != CastStatus.Hit) continue;
            float before = r.Distance - 1e-3f;
            Vector3 outside = origin + Vector3.Normalize(direction) * before;
            bool isEarly = before > 0 && ConvexQuery.SignedDistance(shape, pose, outside).Distance < -1e-6f;
            Assert.False(isEarly, $"seed {i}: {r}");
        }

        Assert.InRange(starts, 40, 3000);
    }

    /// <summary>Without what rounding leaves of a 0.</summary>
    private static Vector3 Clean(Vector3 v) => new(
        Math.Abs(v.X) < 1e-12 ? 0 : v.X, Math.Abs(v.Y) < 1e-12 ? 0 : v.Y, Math.Abs(v.Z) < 1e-12 ? 0 : v.Z);

    private static Vector3 Half(Rng rng, int most) =>
        new Vector3(rng.Below(2 * most + 1) - most, rng.Below(2 * most + 1) - most, rng.Below(2 * most + 1) - most) / 2;

    private static bool CheckExact(string name, RayShape shape, in RigidPose pose, Vector3 origin, Vector3 direction)
    {
        RayCastResult r = ConvexQuery.RayCast(shape.Shape, pose, origin, direction);
        TrueHit t = shape.Cast(pose, origin, direction, double.PositiveInfinity);
        string text = $"{name}: {shape.Text}, {TestShape.T(pose)} from {origin} along {direction}: {r}, truly {t}";
        Assert.True(r.Status == t.Status, text);
        if (r.Status != CastStatus.Hit) return false;
        Assert.True(Math.Abs(r.Distance - t.Distance) <= 1e-7 * Math.Max(shape.Scale, t.Distance), text);
        if (t.IsNormalUnique) Assert.True(((Double3)r.Normal - t.Normal).Length <= 1e-6, text);
        return true;
    }
}
