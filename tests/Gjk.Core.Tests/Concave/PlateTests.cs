namespace Gjk.Core.Tests.Concave;

/// <summary>Parallel plates have as many nearest pairs as triangles; planes drop them without a query of
/// each.</summary>
public class PlateTests
{
    [Theory]
    [InlineData(0f)]
    [InlineData(1e-14f)]
    [InlineData(1e-9f)]
    [InlineData(1e-7f)]
    [InlineData(1e-6f)]
    [InlineData(1e-5f)]
    [InlineData(0.1f)]
    public void PlatesHaveTheLeastDistanceOfAllTheirParts(float gap)
    {
        var plate = AnyShape.Surface(ConcaveShapes.Grid(8));
        var scratch = new ConcaveScratch();
        for (int i = 0; i < 12; i++)
        {
            var rng = new Rng((ulong)i);
            Quaternion turn = i == 0 ? Quaternion.Identity : Quaternion.Normalize(rng.Rotation());
            var poseA = new RigidPose(turn, i < 6 ? Vector3.Zero : rng.Vector(-3, 3));
            Vector3 slide = i % 3 == 0 ? Vector3.Zero : new Vector3(rng.Float(-0.4, 0.4), 0, rng.Float(-0.4, 0.4));
            var poseB = new RigidPose(turn, poseA.Position + Vector3.Transform(slide + new Vector3(0, gap, 0), turn));
            float least = float.PositiveInfinity;
            bool overlaps = false;
            foreach (ConvexShape a in ConcaveShapes.Parts(plate))
            {
                foreach (ConvexShape b in ConcaveShapes.Parts(plate))
                {
                    DistanceResult d = ConvexQuery.Distance(a, poseA, b, poseB);
                    least = Math.Min(least, d.Distance);
                    overlaps |= d.IsOverlapping;
                }
            }

            PairDistance found = ConcaveQuery.Distance(plate, poseA, plate, poseB, scratch);
            Assert.Equal((least, overlaps), (found.Distance, found.IsOverlapping));
            Assert.True(found.Result.LowerBound <= least, $"{found.Result.LowerBound:R} above {least:R}");
            Assert.Equal(overlaps, ConcaveQuery.Overlaps(plate, poseA, plate, poseB, scratch));
            foreach (float most in new[] { least * 0.5f, least, least * 2 })
            {
                PairDistance within = ConcaveQuery.Distance(plate, poseA, plate, poseB, scratch, most);
                Assert.Equal(least <= most, within.Status != GjkStatus.BeyondMaxDistance);
                if (least <= most) Assert.Equal(least, within.Distance);
            }
        }
    }

    [Theory]
    [InlineData(0f)]
    [InlineData(1e-9f)]
    [InlineData(1e-7f)]
    [InlineData(1e-5f)]
    public void PlatesThatSlideMeetWhereTheirPartsDo(float gap)
    {
        var plate = AnyShape.Surface(ConcaveShapes.Grid(6));
        var scratch = new ConcaveScratch();
        for (int i = 0; i < 9; i++)
        {
            var rng = new Rng((ulong)i);
            Quaternion turn = i < 3 ? Quaternion.Identity : Quaternion.Normalize(rng.Rotation());
            float fall = i % 3 == 0 ? 0 : i % 3 == 1 ? -2 * gap : gap;
            Vector3 up = new(0, gap, 0), way = new(rng.Float(-1, 1), fall, rng.Float(-1, 1));
            RigidPose poseA = new(turn, Vector3.Zero), poseB = new(turn, Vector3.Transform(up, turn));
            way = Vector3.Transform(way, turn);
            float least = float.PositiveInfinity;
            foreach (ConvexShape a in ConcaveShapes.Parts(plate))
            {
                foreach (ConvexShape b in ConcaveShapes.Parts(plate))
                {
                    CastResult one = ConvexQuery.Cast(a, poseA, Vector3.Zero, b, poseB, way);
                    if (one.IsHit) least = Math.Min(least, one.Fraction);
                }
            }

            CastHit found = ConcaveQuery.Cast(plate, poseA, Vector3.Zero, plate, poseB, way, scratch);
            Assert.Equal(least, found.IsHit ? found.Fraction : float.PositiveInfinity);
        }
    }

    [Theory]
    [InlineData(1, 1e-7f)]
    [InlineData(1, 1e-9f)]
    [InlineData(1, 1e-12f)]
    [InlineData(60, 1e-7f)]
    [InlineData(60, 1e-8f)]
    [InlineData(60, -1e-9f)]
    [InlineData(600, 1e-7f)]
    public void APlateThatSlidesCloselyAsksFewParts(float size, float gap)
    {
        var plate = AnyShape.Surface(ConcaveShapes.Grid(60).Scaled(new Vector3(size)));
        var scratch = new ConcaveScratch();
        for (int i = 0; i < 3; i++)
        {
            Quaternion turn = Quaternion.CreateFromAxisAngle(Vector3.UnitY, 0.4f * i);
            var poseB = new RigidPose(turn, new Vector3(0.01f * size, gap, 0.02f * size));
            Vector3 way = new Vector3(0.5f, 0, 0.3f) * size;
            CastHit found = ConcaveQuery.Cast(
                plate, RigidPose.Identity, Vector3.Zero, plate, poseB, way, scratch);
            Assert.Equal(CastStatus.Miss, found.Status);
            Assert.InRange(scratch.CastSearch.QueryCount, 1, 64);
        }
    }

    [Theory]
    [InlineData(1e-7f)]
    [InlineData(1e-10f)]
    public void WavesThatSlideAlongThemselvesAskFewParts(float gap)
    {
        var waves = AnyShape.Surface(ConcaveShapes.Grid(20, (x, _) => 0.1f * MathF.Sin(9 * x)));
        var scratch = new ConcaveScratch();
        var poseB = new RigidPose(Quaternion.Identity, new Vector3(0, gap, 0.02f));
        CastHit found = ConcaveQuery.Cast(
            waves, RigidPose.Identity, Vector3.Zero, waves, poseB, Vector3.UnitZ, scratch);
        Assert.Equal(CastStatus.Miss, found.Status);
        Assert.InRange(scratch.CastSearch.QueryCount, 1, 64);
    }

    [Fact]
    public void APlateThatIsTiltedByAMillionthAsksFewParts()
    {
        var plate = AnyShape.Surface(ConcaveShapes.Grid(60));
        var scratch = new ConcaveScratch();
        var poseB = new RigidPose(Quaternion.Normalize(new Quaternion(5e-7f, 3e-7f, 0, 1)), Vector3.Zero);
        Assert.True(ConcaveQuery.Overlaps(plate, RigidPose.Identity, plate, poseB, scratch));
        Assert.InRange(scratch.Search.QueryCount, 1, 8);
    }

    [Fact]
    public void APointAmidABallAsksFewOfTheTrianglesThatAreEquallyNear()
    {
        TriangleMesh ball = Surfaces.Ball(40, 20, (_, _) => 1).Build();
        var scratch = new ConcaveScratch();
        PairDistance found = ConcaveQuery.SignedDistance(
            AnyShape.Surface(ball), RigidPose.Identity, Vector3.Zero, scratch);
        float least = float.PositiveInfinity;
        foreach (ConvexShape part in ConcaveShapes.Parts(AnyShape.Surface(ball)))
        {
            least = Math.Min(
                least,
                ConvexQuery.Distance(part, RigidPose.Identity, ConvexShape.Point(), RigidPose.Identity).Distance);
        }

        Assert.Equal(least, found.Distance);
        Assert.InRange(scratch.Search.QueryCount, 1, ball.TriangleCount / 4);
    }
}
