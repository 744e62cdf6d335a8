namespace Gjk.Core.Tests.Queries;

/// <summary>Distances that a formula gives, in double and without the library.</summary>
public class ClosedFormTests
{
    private const int Count = 300;

    [Fact]
    public void SphereAgainstSphereIsItsFormula() => Each(1, rng =>
    {
        float ra = rng.Float(0, 1), rb = rng.Float(0, 1);
        RigidPose a = Generators.Pose(rng, rng.Vector(-2, 2)), b = Generators.Pose(rng, rng.Vector(-2, 2));
        double d = ((Double3)a.Position - b.Position).Length - ra - rb;
        return (ConvexQuery.Distance(new SphereShape(ra), a, new SphereShape(rb), b), d, 2);
    });

    [Fact]
    public void PointAgainstBoxIsItsFormula() => Each(2, rng =>
    {
        Vector3 h = rng.Vector(0, 1), p = rng.Vector(-2, 2);
        var box = new RigidPose(rng.Vector(-100, 100));
        var at = new RigidPose(Quaternion.Identity, box.Position + p);
        Double3 v = (Double3)at.Position - box.Position;
        double d = new Double3(Past(v.X, h.X), Past(v.Y, h.Y), Past(v.Z, h.Z)).Length;
        return (ConvexQuery.Distance(new PointShape(), at, new BoxShape(h), box), d, 2);
    });

    [Fact]
    public void BoxAgainstAlignedBoxIsItsFormula() => Each(3, rng =>
    {
        Vector3 h = rng.Vector(0, 1), k = rng.Vector(0, 1);
        RigidPose a = new(rng.Vector(-2, 2)), b = new(rng.Vector(-2, 2));
        Double3 v = (Double3)b.Position - a.Position;
        double d = new Double3(
            Past(v.X, (double)h.X + k.X), Past(v.Y, (double)h.Y + k.Y), Past(v.Z, (double)h.Z + k.Z)).Length;
        return (ConvexQuery.Distance(new BoxShape(h), a, new BoxShape(k), b), d, 2);
    });

    [Fact]
    public void SegmentAgainstSegmentIsItsFormula() => Each(4, rng =>
    {
        Vector3 p = rng.Vector(-1, 1), q = rng.Vector(-1, 1), r = rng.Vector(-1, 1), s = rng.Vector(-1, 1);
        DistanceResult found = ConvexQuery.Distance(
            new SegmentShape(p, q), RigidPose.Identity, new SegmentShape(r, s), RigidPose.Identity);
        return (found, SegmentDistance(p, q, r, s), 2);
    });

    [Fact]
    public void CapsuleAgainstCapsuleIsItsFormula() => Each(5, rng =>
    {
        float ra = rng.Float(0, 0.5), rb = rng.Float(0, 0.5), ha = rng.Float(0, 1), hb = rng.Float(0, 1);
        RigidPose a = Generators.Pose(rng, rng.Vector(-1.5, 1.5)), b = Generators.Pose(rng, rng.Vector(-1.5, 1.5));
        Double3 ya = Axis(a) * ha, yb = Axis(b) * hb;
        double d = SegmentDistance(ya + a.Position, -ya + a.Position, yb + b.Position, -yb + b.Position) - ra - rb;
        return (ConvexQuery.Distance(new CapsuleShape(ra, ha), a, new CapsuleShape(rb, hb), b), d, 2);
    });

    [Fact]
    public void PointAgainstCylinderIsItsFormula() => Curved(6, (rng, p) =>
    {
        float r = rng.Float(0.1, 1), h = rng.Float(0.1, 1);
        double radial = Past(Math.Sqrt((double)p.X * p.X + (double)p.Z * p.Z), r), axial = Past(p.Y, h);
        return (TestShape.Cylinder(r, h), Math.Sqrt(radial * radial + axial * axial));
    });

    [Fact]
    public void PointAgainstConeIsItsFormula() => Curved(7, (rng, p) =>
    {
        float r = rng.Float(0.1, 1), h = rng.Float(0.1, 1);
        double radial = Math.Sqrt((double)p.X * p.X + (double)p.Z * p.Z);

        // In the half plane of the point the cone is the triangle (0, h), (r, -h), (0, -h).
        bool inside = p.Y >= -h && radial <= r * (h - p.Y) / (2.0 * h);
        Double3 at = new(radial, p.Y, 0), apex = new(0, h, 0), rim = new(r, -(double)h, 0);
        Double3 foot = new(0, -(double)h, 0);
        double outside = Math.Min(SegmentDistance(at, at, apex, rim), SegmentDistance(at, at, rim, foot));
        return (TestShape.Cone(r, h), inside ? 0 : outside);
    });

    [Fact]
    public void SphereAgainstEllipsoidOnItsAxesIsItsFormula()
    {
        var radii = new Vector3(0.5f, 1, 2);
        foreach (Vector3 axis in new[] { Vector3.UnitX, Vector3.UnitY, Vector3.UnitZ })
        {
            var at = new RigidPose(axis * 3);
            DistanceResult r = ConvexQuery.Distance(
                new EllipsoidShape(radii), RigidPose.Identity, new SphereShape(0.25f), at);
            double d = 3 - Vector3.Dot(radii, axis) - 0.25;
            Assert.True(
                Math.Abs(r.Distance - d) <= Accuracy.CurvedBand(d, 4), $"axis {axis}: {r.Distance:R}, truly {d:R}");
        }
    }

    [Fact]
    public void TheReadmesTwoBoxes()
    {
        DistanceResult r = ConvexQuery.Distance(
            new BoxShape(new Vector3(0.5f)), RigidPose.Identity, new BoxShape(new Vector3(0.5f)), new RigidPose(
                new Vector3(3, 0.25f, 0)));
        Assert.Equal(GjkStatus.Separated, r.Status);
        Assert.Equal(2, r.Distance);
        Assert.Equal(Vector3.UnitX, r.Normal);
        Assert.Equal(0.5f, r.PointA.X);
        Assert.Equal(2.5f, r.PointB.X);
        Assert.Equal(r.PointA.Y, r.PointB.Y);
        Assert.InRange(r.PointA.Y, -0.25f, 0.5f);
    }

    private static double Past(double x, double half) => Math.Max(Math.Abs(x) - half, 0);

    private static Double3 Axis(in RigidPose pose) =>
        new Body<PointShape>(new PointShape(), pose).Rotate(new Double3(0, 1, 0));

    /// <summary>The least of: the ends' distances to the other segment, and the lines' distance where both feet are
    /// inside.</summary>
    private static double SegmentDistance(in Double3 p, in Double3 q, in Double3 r, in Double3 s)
    {
        Double3 e = q - p, f = s - r, w = p - r;
        double ends = Math.Min(
            Math.Min(ToSegment(p, r, s), ToSegment(q, r, s)), Math.Min(ToSegment(r, p, q), ToSegment(s, p, q)));
        Double3 n = Double3.Cross(e, f);
        double nn = n.LengthSquared;
        if (nn == 0) return ends;
        double t = Double3.Dot(Double3.Cross(f, w), n) / nn, u = Double3.Dot(Double3.Cross(e, w), n) / nn;
        bool inside = t >= 0 && t <= 1 && u >= 0 && u <= 1;
        return inside ? Math.Min(ends, Math.Abs(Double3.Dot(w, n)) / Math.Sqrt(nn)) : ends;
    }

    private static double ToSegment(in Double3 p, in Double3 a, in Double3 b)
    {
        Double3 e = b - a;
        double t = e.LengthSquared == 0 ? 0 : Math.Clamp(Double3.Dot(p - a, e) / e.LengthSquared, 0, 1);
        return (p - a - e * t).Length;
    }

    private static void Curved(ulong seed, Func<Rng, Vector3, (TestShape Shape, double Distance)> make)
    {
        for (ulong i = 0; i < (ulong)Budget.Count(Count); i++)
        {
            var rng = new Rng(seed * 1_000_000 + i);
            Vector3 p = rng.Vector(-2, 2);
            (TestShape shape, double d) = make(rng, p);
            DistanceResult r = ConvexQuery.Distance(
                shape.Shape, RigidPose.Identity, new PointShape(), new RigidPose(p));
            Assert.True(
                Math.Abs(r.Distance - d) <= Accuracy.CurvedBand(d, shape.LongestSide),
                $"seed {seed * 1_000_000 + i}: {r.Status} {r.Distance:R}, truly {d:R}: {shape}, {p}");
            Assert.True(d <= 1e-9 || !r.IsOverlapping, $"seed {seed * 1_000_000 + i}: overlap, truly {d:R}");
        }
    }

    private static void Each(ulong seed, Func<Rng, (DistanceResult Found, double Distance, double Scale)> make)
    {
        int apart = 0;
        for (ulong i = 0; i < (ulong)Budget.Count(Count); i++)
        {
            (DistanceResult r, double d, double scale) = make(new Rng(seed * 1_000_000 + i));
            double truth = Math.Max(d, 0);
            Assert.True(
                Math.Abs(r.Distance - truth) <= Accuracy.Band(truth, scale),
                $"seed {seed * 1_000_000 + i}: {r.Status} {r.Distance:R}, truly {truth:R}");
            Assert.True(
                Math.Abs(d) <= Accuracy.FlagScale || r.IsOverlapping == d <= 0,
                $"seed {seed * 1_000_000 + i}: {r.Status}, truly {d:R}");
            if (!r.IsOverlapping) apart++;
        }

        Assert.True(apart > Count / 10);
    }
}
