namespace Gjk.Core.Tests.Concave;

/// <summary>Bodies that turn are moved on where no parts can touch; the answer is that of all pairs of parts.</summary>
public sealed class PartAdvancementTests
{
    private readonly ConcaveScratch _scratch = new();

    [Theory]
    [InlineData(0, 0, 0)]
    [InlineData(1, 0, 0)]
    [InlineData(2, 0, 0)]
    [InlineData(3, 0, 0)]
    [InlineData(4, 1e3f, 0)]
    [InlineData(5, 1e5f, 0)]
    [InlineData(6, 0, 0.05f)]
    [InlineData(7, 0, 0)]
    public void ItIsTheFirstOfAllPairs(ulong seed, float far, float tolerance)
    {
        var random = new FuzzRandom(seed);
        TriangleMesh ring = Surfaces.Torus(12, 7).Build(), ball = Surfaces.Ball(8, 6, (_, _) => 0.4).Build();
        var offset = new Vector3(far, -far, far / 2);
        int hits = 0;
        for (int i = 0; i < 6; i++)
        {
            // Slow turns and fast ones, aimed at the other body, past it, and from inside of its reach.
            float turns = i < 4 ? 1 : 12;
            Vector3 from = random.Vector(1);
            from *= (i == 5 ? 0.9f : 3) / from.Length();
            RigidPose poseA = new(Rotations.Even(random), offset), poseB = new(Rotations.Even(random), offset + from);
            var motionA = new RigidMotion(poseA, random.Vector(0.3), turns * random.Vector(1));
            var motionB = new RigidMotion(
                poseB, -1.4f * from + random.Vector(i % 2 == 0 ? 0.2 : 2), turns * random.Vector(1));
            PartCast found = ConcaveQuery.TimeOfImpact(
                AnyShape.Surface(ring), motionA, AnyShape.Surface(ball), motionB, _scratch, tolerance);
            CastResult least = Least(ring, motionA, ball, motionB, tolerance);
            Assert.True(found.IsHit == least.IsHit, $"{i}: {found}, but {least}");
            if (least.IsHit) Assert.True(found.Fraction == least.Fraction, $"{i}: {found}, but {least}");
            if (least.IsHit) hits++;
        }

        Assert.InRange(hits, 1, 6);
    }

    [Theory]
    [InlineData(2)]
    [InlineData(float.PositiveInfinity)]
    public void ATurnBesideAnotherBodyEnds(float maxFraction)
    {
        TriangleMesh ring = Surfaces.Torus(12, 7).Build();
        var turning = new RigidMotion(RigidPose.Identity, Vector3.Zero, new Vector3(0.5f, 3, 0.1f));
        var other = new RigidMotion(new RigidPose(Quaternion.Identity, new Vector3(2.75f, 0, 0)), Vector3.Zero);
        PartCast found = ConcaveQuery.TimeOfImpact(
            AnyShape.Surface(ring), turning, AnyShape.Surface(ring), other, _scratch, 0, maxFraction);
        Assert.Equal(float.IsFinite(maxFraction) ? CastStatus.Miss : CastStatus.IterationLimit, found.Status);
    }

    private static CastResult Least(
        TriangleMesh a, in RigidMotion motionA, TriangleMesh b, in RigidMotion motionB, float tolerance)
    {
        CastResult least = default;
        for (int i = 0; i < a.TriangleCount; i++)
        {
            for (int j = 0; j < b.TriangleCount; j++)
            {
                CastResult one = ConvexQuery.TimeOfImpact(a.GetShape(i), motionA, b.GetShape(j), motionB, tolerance);
                if (one.IsHit && (!least.IsHit || one.Fraction < least.Fraction)) least = one;
            }
        }

        return least;
    }
}
