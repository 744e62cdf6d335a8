using Gjk.Core.Tests.Support.Rays;

namespace Gjk.Core.Tests.Queries.Rays;

/// <summary>Rays that begin on a surface or within rounding of it: what exact geometry says of the line decides, not
/// how deep a search for a depth believes the origin to be.</summary>
public class RayStartTests
{
    private static readonly RigidPose Here = RigidPose.Identity;

    /// <summary>Beside the rim of a cap the line goes in by no more than the rim is near; a point that is cast,
    /// too.</summary>
    [Theory]
    [InlineData(20)]
    [InlineData(21)]
    [InlineData(22)]
    [InlineData(23)]
    [InlineData(24)]
    public void FromACapBesideItsRim(int power)
    {
        float beside = 1 - 1f / (1 << power);
        Check(ConvexShape.Cylinder(1, 1), 1);
        Check(ConvexShape.Cone(1, 1), -1);
        Check(ConvexShape.Cylinder(1, 1).Rounded(0.5f), 1.5f);
        Check(ConvexShape.Cylinder(2, 1).Scaled(new Vector3(0.5f, 1, 0.5f)), -1);

        void Check(in ConvexShape shape, float y)
        {
            Vector3 origin = new(0, y, beside), into = new(0, -Math.Sign(y), 0);
            RayCastResult ray = ConvexQuery.RayCast(shape, Here, origin, into);
            CastResult cast = ConvexQuery.Cast(
                shape, Here, default, ConvexShape.Point(), new RigidPose(origin), into);
            CastResult swapped = ConvexQuery.Cast(
                new PointShape(), new RigidPose(origin), into, shape, Here, default).Swapped;
            Assert.Equal((CastStatus.Hit, 0f, -into), (ray.Status, ray.Distance, ray.Normal));
            foreach (CastResult r in new[] { cast, swapped })
                Assert.Equal((CastStatus.Hit, 0f, -into), (r.Status, r.Fraction, r.Normal));
            Assert.Equal(CastStatus.Miss, ConvexQuery.RayCast(shape, Here, origin, -into).Status);
            Assert.Equal(CastStatus.Miss, ConvexQuery.RayCast(shape, Here, origin, Vector3.UnitX).Status);
        }
    }

    /// <summary>Flat round bodies from beside their surface: whether a ray hits, where and with which normal, is what
    /// 640 digits say; only the origins that these put inside may be touching.</summary>
    [Theory]
    [InlineData("cylinder")]
    [InlineData("cone")]
    [InlineData("ellipsoid")]
    [InlineData("capsule")]
    public void BesideAFlatBody(string kind)
    {
        int hits = 0, misses = 0;
        for (int i = 0; i < Budget.Count(400); i++)
        {
            var rng = new Rng((ulong)i);
            var thin = new Vector3(1, rng.LogFloat(1e-7, 1e-3), rng.Float(0.5, 1));
            RayShape shape = RayShapes.Scaled(RayShapes.Make(rng, kind, Vector3.One), thin);
            RigidPose pose = i % 2 == 0 ? Here : Generators.Pose(rng, default);
            Vector3 along = Vector3.Transform(new(rng.Float(-1, 1), 0, rng.Float(-1, 1)), pose.Rotation);
            Vector3 aim = pose.TransformPoint(new Vector3(rng.Float(-0.5, 0.5), 0, rng.Float(-0.3, 0.3)));
            Vector3 direction = along + rng.UnitVector() * rng.LogFloat(1e-7, 1e-2);
            TrueHit found = shape.Cast(pose, aim - direction * 8, direction, double.PositiveInfinity);
            if (found.Status != CastStatus.Hit) continue;
            double way = found.Distance - rng.LogFloat(1e-10, 1e-3);
            Double3 unit = (Double3)direction * (1 / ((Double3)direction).Length);
            var origin = (Vector3)(unit * way + (aim - direction * 8));
            TrueHit truth = shape.Cast(pose, origin, direction, double.PositiveInfinity);
            RayCastResult r = ConvexQuery.RayCast(shape.Shape, pose, origin, direction);
            string text = $"seed {i}: {shape.Text}, {TestShape.T(pose)} {origin} along {direction}: {r}, truly {truth}";
            if (truth.Status == CastStatus.Miss)
            {
                misses++;
                Assert.True(r.Status == CastStatus.Miss, text);
            }
            else if (truth.Status == CastStatus.Hit && truth.Exit - truth.Distance > 1e-3)
            {
                hits++;
                Assert.True(r.Status == CastStatus.Hit, text);
                Assert.True(Math.Abs(r.Distance - truth.Distance) <= 1e-7 * shape.Scale, text);
                if (truth.IsNormalUnique) Assert.True(((Double3)r.Normal - truth.Normal).Length <= 1e-6, text);
            }
        }

        Assert.True(hits > 30, $"{hits} hits, {misses} misses");
    }

    /// <summary>A touching origin hits at 0 where the surface is a hundredth of a millionth ahead; three times that is
    /// a way.</summary>
    [Theory]
    [InlineData(4e-8, true)]
    [InlineData(1.2e-7, false)]
    public void ASurfaceHardlyAheadIsAtTheStart(double ahead, bool isAtStart)
    {
        const float thin = 1f / 1024, step = 1f / (1 << 30) / 8;
        ConvexShape plate = ConvexShape.Cylinder(1, thin);
        Vector3 origin = new(0, thin + step, 0), direction = new(1, (float)(-step / ahead), 0);
        RayCastResult r = ConvexQuery.RayCast(plate, Here, origin, direction);
        Assert.True(ConvexQuery.Contains(plate, Here, origin));
        Assert.Equal((CastStatus.Hit, Vector3.UnitY), (r.Status, r.Normal));
        Assert.True(isAtStart ? r.Distance == 0 : Math.Abs(r.Distance - ahead) < 1e-9, r.ToString());
    }

    /// <summary>Where the origin touches, even a ray that ends there has the normal of one that goes on.</summary>
    [Fact]
    public void AReachOfNothingChangesNoNormal()
    {
        QueryRecord pair = QueryRecord.Parse(
            "gjk1 point 0 @ 0 0 0 1 -3.99999989E-09 8.99999986E-09 -1.99999994E-09 ~ 0 0 0.899999976 0 0 0 ellipsoid "
            + "0.99999999115220817 1.000000003262187 0.99999995952652654 @ 0.00999999978 -0.00200000009 0.620000005 "
            + "-0.785700023 0.611437917 0.278247148 0.740757823");
        Vector3 way = pair.MotionA.Velocity;
        foreach (float most in (float[])[0, -1, 1e-9f, float.PositiveInfinity])
        {
            CastResult cast = ConvexQuery.Cast(pair.A, pair.PoseA, way, pair.B, pair.PoseB, Vector3.Zero, most);
            CastResult whole = ConvexQuery.Cast(pair.A, pair.PoseA, way, pair.B, pair.PoseB, Vector3.Zero, 1);
            Assert.Equal((whole.Status, whole.Point, whole.Normal), (cast.Status, cast.Point, cast.Normal));
            RayCastResult ray = ConvexQuery.RayCast(pair.B, pair.PoseB, pair.PoseA.Position, way, most);
            RayCastResult far = ConvexQuery.RayCast(pair.B, pair.PoseB, pair.PoseA.Position, way);
            Assert.Equal((far.Status, far.Point, far.Normal), (ray.Status, ray.Point, ray.Normal));
        }
    }
}
