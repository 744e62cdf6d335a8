namespace Gjk.Core.Tests.Queries;

/// <summary>Casts of curved cores that have an answer in closed form.</summary>
public class CurvedCastTests
{
    /// <summary>Two standing cylinders that move across their axes are two circles: fraction and normal are those of a
    /// line against a circle, down to grazes of a ten thousandth of the radius.</summary>
    [Fact]
    public void StandingCylindersAreCircles()
    {
        for (int i = 0; i < Budget.Count(400); i++)
        {
            var rng = new Rng((ulong)i);
            float r = rng.Float(0.1, 2), q = rng.Float(0.1, 2), depth = MathF.Pow(10, -rng.Float(0, 4));
            double radii = (double)r + q;
            float side = (float)(radii * (1 - depth));
            var cylinder = new CylinderShape(q, rng.Float(0.5, 2));
            CastResult c = ConvexQuery.Cast(
                new CylinderShape(r, 1), RigidPose.Identity, default, cylinder,
                new RigidPose(new Vector3(-20, rng.Float(-1, 1), side)), new Vector3(40, 0, 0));
            double x = -Math.Sqrt(radii * radii - (double)side * side);
            string what = $"seed {i}: {r:R} {q:R} {side:R}: {c}";
            Assert.True(c.Status == CastStatus.Hit, what);
            Assert.True(Math.Abs(c.Fraction * 40.0 - 20 - x) <= 1e-7 * (20 + x), what);
            Assert.True(((Double3)c.Normal - new Double3(x, 0, side) * (1 / radii)).Length <= 1e-6, what);
            Double3 onAxis = (Double3)c.Point - new Double3(0, c.Point.Y, 0);
            Assert.True(Math.Abs(onAxis.Length - r) <= 1e-6, what);
        }
    }

    /// <summary>A rounded curved core against a point: the same body, larger, where that has a closed form.</summary>
    [Fact]
    public void ARoundedCylinderOnItsSideIsALargerOne()
    {
        for (int i = 0; i < Budget.Count(400); i++)
        {
            var rng = new Rng((ulong)(5000 + i));
            float r = rng.Float(0.1, 2), margin = rng.Float(0.02, 0.5), depth = MathF.Pow(10, -rng.Float(0, 4));
            double radii = (double)r + margin;
            float side = (float)(radii * (1 - depth));
            CastResult c = ConvexQuery.Cast(
                ConvexShape.Cylinder(r, 2).Rounded(margin), RigidPose.Identity, default, ConvexShape.Sphere(0.25f),
                new RigidPose(rng.Rotation(), new Vector3(-20, rng.Float(-1, 1), side)), new Vector3(40, 0, 0));
            radii += 0.25;
            double x = -Math.Sqrt(radii * radii - (double)side * side);
            string what = $"seed {i}: {r:R} {margin:R} {side:R}: {c}";
            Assert.True(c.Status == CastStatus.Hit, what);
            Assert.True(Math.Abs(c.Fraction * 40.0 - 20 - x) <= 1e-7 * (20 + x), what);
            Assert.True(((Double3)c.Normal - new Double3(x, 0, side) * (1 / radii)).Length <= 1e-6, what);
        }
    }

    /// <summary>In exact contact the distance's two bounds may disagree; either way the motion goes in.</summary>
    [Fact]
    public void AStartInContactIsHitAtZero()
    {
        var capsule = ConvexShape.Capsule(0.5f, 0.25f);
        var ball = ConvexShape.Ellipsoid(new Vector3(0.25f));
        var at = new RigidPose(new Vector3(-0.75f, 0.25f, 0));
        CastResult r = ConvexQuery.Cast(capsule, at, default, ball, RigidPose.Identity, new Vector3(-1, 0, 0));
        Assert.Equal((CastStatus.Hit, 0f), (r.Status, r.Fraction));
        Assert.Equal(-0.25f, r.Point.X, 1e-5f);
    }

    /// <summary>The rim of a rounded cylinder is a ring, whose normal turns quickly.</summary>
    [Fact]
    public void AThinMarginAroundARimHasTheRingsNormal()
    {
        for (int i = 0; i < Budget.Count(300); i++)
        {
            var rng = new Rng((ulong)(9000 + i));
            float margin = rng.Float(0.01, 0.1), aside = rng.Float(-0.9, 0.9) * margin;
            CastResult c = ConvexQuery.Cast(
                ConvexShape.Cylinder(2, 1).Rounded(margin), RigidPose.Identity, default, ConvexShape.Sphere(0.02f),
                new RigidPose(new Vector3(2 + aside, 9, 0)), new Vector3(0, -10, 0));
            double radii = (double)margin + 0.02f, out0 = (double)(2 + aside) - 2;
            double up = out0 > 0 ? Math.Sqrt(radii * radii - out0 * out0) : radii;
            var normal = new Double3(Math.Max(out0, 0), up, 0);
            string what = $"seed {i}: {margin:R} {aside:R}: {c}";
            Assert.True(Math.Abs(c.Fraction * 10.0 - (9 - 1 - up)) <= 1e-6, what);
            Assert.True(((Double3)c.Normal - normal * (1 / radii)).Length <= 1e-6, what);
        }
    }
}
