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
        var random = new Rng(seed);
        TriangleMesh ring = Surfaces.Torus(Budget.Whole(18), 4).Build();
        TriangleMesh ball = Surfaces.Ball(Budget.Whole(12), 3, (_, _) => 0.4).Build();
        var offset = new Vector3(far, -far, far / 2);
        int hits = 0;
        for (int i = 0; i < 6; i++)
        {
            // The quick tier asks every other one, the same ones for half of the seeds.
            if (!Budget.IsLong && i % 2 != (int)seed % 2) continue;

            // Slow turns and fast ones, aimed at the other body, past it, and from inside of its reach.
            float turns = i < 4 ? 1 : 12;
            Vector3 from = random.Vector(1);
            from *= (i == 5 ? 0.9f : 3) / from.Length();
            RigidPose poseA = new(random.Rotation(), offset), poseB = new(random.Rotation(), offset + from);
            var motionA = new RigidMotion(poseA, random.Vector(0.3), turns * random.Vector(1));
            var motionB = new RigidMotion(
                poseB, -1.4f * from + random.Vector(i % 2 == 0 ? 0.2 : 2), turns * random.Vector(1));
            CastHit found = ConcaveQuery.TimeOfImpact(
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
        CastHit found = ConcaveQuery.TimeOfImpact(
            AnyShape.Surface(ring), turning, AnyShape.Surface(ring), other, _scratch, 0, maxFraction);
        Assert.Equal(float.IsFinite(maxFraction) ? CastStatus.Miss : CastStatus.IterationLimit, found.Status);
    }

    /// <summary>Bodies that turn are advanced with no more work than a loop of warm distances takes: 32 looks at two
    /// parts count as one distance.</summary>
    [Theory]
    [InlineData(0.2f)]
    [InlineData(0.02f)]
    [InlineData(0.002f)]
    public void WheelsThatPassCostNoMoreThanTwiceALoopOfDistances(float gap)
    {
        const float turn = 2 * MathF.PI;
        var wheel = AnyShape.Surface(Surfaces.Torus(24, 9).Build());
        var motionA = new RigidMotion(RigidPose.Identity, Vector3.Zero, new Vector3(0, turn, 0));
        var motionB = new RigidMotion(
            new RigidPose(Quaternion.Identity, new Vector3(2.7f + gap, 0, 0)), Vector3.Zero, new Vector3(0, -turn, 0));
        Assert.Equal(
            CastStatus.Miss, ConcaveQuery.TimeOfImpact(wheel, motionA, wheel, motionB, _scratch).Status);
        AssertNoMoreThanTwiceALoopOfDistances(wheel, motionA, wheel, motionB, 1);
    }

    /// <summary>A step of theirs that comes down on another is met long after the whole bodies are near.</summary>
    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    [InlineData(float.PositiveInfinity)]
    public void BodiesWithAStepThatMeetCostNoMoreThanTwiceALoopOfDistances(float tolerance)
    {
        var body = AnyShape.Solid(Stepped());
        var from = new RigidPose(
            new Quaternion(0.6843205f, -0.6262224f, -0.35133255f, -0.12695047f),
            new Vector3(-2.2890162f, 0.072764985f, 1.7462846f));
        var motionA = new RigidMotion(
            from, new Vector3(0.52010655f, 0.2474097f, -0.8174825f), new Vector3(1, 0.3f, 0.2f));
        var motionB = new RigidMotion(
            new RigidPose(new Quaternion(0.6979811f, -0.19459322f, -0.65721565f, 0.20742093f), Vector3.Zero), default);
        CastHit hit = ConcaveQuery.TimeOfImpact(body, motionA, body, motionB, _scratch, tolerance);
        Assert.Equal(CastStatus.Hit, hit.Status);
        AssertNoMoreThanTwiceALoopOfDistances(body, motionA, body, motionB, hit.Fraction);
    }

    /// <summary>A cube of side 2 without a quarter, 1.2 thick.</summary>
    private static TriangleMesh Stepped()
    {
        Vector2[] around = [new(-1, -1), new(1, -1), new(1, 0), new(0, 0), new(0, 1), new(-1, 1)];
        var corners = new List<Vector3>();
        foreach (float z in new[] { 0.6f, -0.6f })
            foreach (Vector2 corner in around) corners.Add(new Vector3(corner, z));
        var indices = new List<int>();
        for (int i = 0; i < 6; i++)
        {
            int j = (i + 1) % 6;
            if (i is > 0 and < 5) indices.AddRange([0, i, j, 6, 6 + j, 6 + i]);
            indices.AddRange([i, 6 + i, 6 + j, i, 6 + j, j]);
        }

        return new TriangleMesh(corners, indices);
    }

    /// <summary>Checks the last search of the scratch.</summary>
    private void AssertNoMoreThanTwiceALoopOfDistances(
        in AnyShape a, in RigidMotion motionA, in AnyShape b, in RigidMotion motionB, float end)
    {
        ref PartCastSearch search = ref _scratch.CastSearch;
        double speed = search.Speed, fraction = 0;
        int work = search.Steps + search.QueryCount / 32, distances = 0;
        string spent = $"{search.Steps} steps, {search.QueryCount} parts";
        PartWarmStart nearest = default;
        for (; fraction < end && distances < 4000; distances++)
        {
            RigidPose poseA = PartAdvancement.PoseAt(motionA, fraction);
            RigidPose poseB = PartAdvancement.PoseAt(motionB, fraction);
            float apart = ConcaveQuery.Distance(a, poseA, b, poseB, ref nearest, _scratch).Distance;
            if (!(apart > 1e-5f)) break;
            fraction += apart / speed;
        }

        Assert.True(work >= 1 && work <= 2 * distances, $"{spent}, {distances} distances");
    }

    [Fact]
    public void AnyToleranceButNaNIsATolerance()
    {
        var corners = new Vector3[] { new(0, 0, 0), new(1, 0, 0), new(0, 1, 0) };
        Assert.True(TriangleMesh.TryCreate(corners, [0, 1, 2], out TriangleMesh? mesh, out _));
        ConvexShape triangle = mesh.GetShape(0), ball = ConvexShape.Sphere(0.1f);
        var still = new RigidMotion(RigidPose.Identity, Vector3.Zero, new Vector3(0, 0, 1));
        var above = new RigidPose(Quaternion.Identity, new Vector3(0.2f, 0.2f, 2));
        var moving = new RigidMotion(above, new Vector3(0, 0, -3));
        foreach (float tolerance in new[] { float.PositiveInfinity, float.NegativeInfinity, float.NaN, 0.1f })
        {
            CastHit found = ConcaveQuery.TimeOfImpact(
                AnyShape.Surface(mesh), still, AnyShape.Of(ball), moving, _scratch, tolerance);
            CastResult one = ConvexQuery.TimeOfImpact(triangle, still, ball, moving, tolerance);
            Assert.Equal((one.Status, one.Fraction), (found.Status, found.Fraction));
            Assert.Equal(float.IsNaN(tolerance), found.Status == CastStatus.InvalidInput);
        }
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
