namespace Gjk.Core.Tests.Queries;

/// <summary>A bounding radius only rejects pairs early: however generous it is, the answers are those of a tight
/// one.</summary>
public class GenerousRadiusTests
{
    public static TheoryData<double> Radii => [10, 1e4, 1e9, 1e12];

    [Theory]
    [MemberData(nameof(Radii))]
    public void ACastDoesNotDependOnTheBoundingRadius(double radius)
    {
        int hits = 0;
        for (ulong seed = 0; seed < 400; seed++)
        {
            var rng = new Rng(seed);
            (Octahedron tight, Octahedron generous) = Twins(seed, radius);
            RigidPose poseA = new(rng.Rotation(), Vector3.Zero), poseB = new(rng.Rotation(), rng.UnitVector() * 5);
            var other = new BoxShape(new Vector3(0.5f, 0.25f, 1));
            Vector3 motion = -2 * poseB.Position + rng.UnitVector();
            CastResult expected = ConvexQuery.Cast(tight, poseA, default, other, poseB, motion);
            CastResult found = ConvexQuery.Cast(generous, poseA, default, other, poseB, motion);
            Assert.True(expected.Status == found.Status, $"seed {seed}: {expected} {found}");
            if (!expected.IsHit) continue;
            hits++;
            Assert.True(Math.Abs(expected.Fraction - found.Fraction) <= 1e-7, $"seed {seed}: {expected} {found}");
            Assert.True((expected.Normal - found.Normal).Length() <= 1e-4, $"seed {seed}: {expected} {found}");
        }

        Assert.InRange(hits, 100, 400);
    }

    [Theory]
    [MemberData(nameof(Radii))]
    public void ARayDoesNotDependOnTheBoundingRadius(double radius)
    {
        int hits = 0;
        for (ulong seed = 0; seed < 400; seed++)
        {
            var rng = new Rng(seed);
            (Octahedron tight, Octahedron generous) = Twins(seed, radius);
            RigidPose pose = new(rng.Rotation(), Vector3.Zero);
            Vector3 origin = rng.UnitVector() * (seed % 3 == 0 ? 1e5f : 5);
            Vector3 toward = rng.UnitVector() - origin;
            RayCastResult expected = ConvexQuery.RayCast(tight, pose, origin, toward, float.PositiveInfinity);
            RayCastResult found = ConvexQuery.RayCast(generous, pose, origin, toward, float.PositiveInfinity);
            Assert.True(expected.Status == found.Status, $"seed {seed}: {expected} {found}");
            if (!expected.IsHit) continue;
            hits++;
            Assert.True((expected.Point - found.Point).Length() <= 1e-6f, $"seed {seed}: {expected} {found}");
            Assert.True((expected.Normal - found.Normal).Length() <= 1e-4, $"seed {seed}: {expected} {found}");
        }

        Assert.InRange(hits, 100, 400);
    }

    /// <summary>Shapes that overlap, then are drawn apart or pushed in: what a cast passes, it passes for every
    /// radius.</summary>
    [Theory]
    [MemberData(nameof(Radii))]
    public void APassedContactDoesNotDependOnTheBoundingRadius(double radius)
    {
        var options = CastOptions.OnlyDeeper(0.05f);
        for (ulong seed = 0; seed < 400; seed++)
        {
            var rng = new Rng(seed);
            (Octahedron tight, Octahedron generous) = Twins(seed, radius);
            RigidPose poseA = new(rng.Rotation(), Vector3.Zero), poseB = new(rng.Rotation(), rng.UnitVector() * 5);
            var other = new BoxShape(new Vector3(0.5f, 0.25f, 1));
            Vector3 motion = -2 * poseB.Position + 2 * rng.UnitVector();
            CastResult expected = ConvexQuery.Cast(tight, poseA, default, other, poseB, motion, 1, options);
            CastResult found = ConvexQuery.Cast(generous, poseA, default, other, poseB, motion, 1, options);
            Assert.True(expected.Status == found.Status, $"seed {seed}: {expected} {found}");
            if (!expected.IsHit) continue;
            Assert.True(Math.Abs(expected.Fraction - found.Fraction) <= 1e-7, $"seed {seed}: {expected} {found}");
        }
    }

    /// <summary>The same shape with the least bounding radius, and with that one.</summary>
    private static (Octahedron Tight, Octahedron Generous) Twins(ulong seed, double radius)
    {
        double margin = seed % 2 == 0 ? 0.25 : 0;
        return (new Octahedron(1 + margin, margin), new Octahedron(radius, margin));
    }

    /// <summary>Six corners at 1 along the axes, and a margin.</summary>
    private readonly struct Octahedron(double radius, double margin) : ISupportMap
    {
        public Double3 Center => default;

        public double Margin => margin;

        public double BoundingRadius => radius;

        public int Support(in Double3 d, out Double3 point)
        {
            double x = Math.Abs(d.X), y = Math.Abs(d.Y), z = Math.Abs(d.Z);
            int axis = x >= y && x >= z ? 0 : y >= z ? 1 : 2;
            int id = 2 * axis + ((axis == 0 ? d.X : axis == 1 ? d.Y : d.Z) < 0 ? 1 : 0);
            TryGetVertex(id, out point);
            return id;
        }

        public void GetFace(in Double3 direction, ref FaceCorners corners)
        {
        }

        public bool TryGetVertex(int id, out Double3 point)
        {
            double sign = (id & 1) == 0 ? 1 : -1;
            point = new Double3(id >> 1 == 0 ? sign : 0, id >> 1 == 1 ? sign : 0, id >> 1 == 2 ? sign : 0);
            return (uint)id < 6u;
        }
    }
}
