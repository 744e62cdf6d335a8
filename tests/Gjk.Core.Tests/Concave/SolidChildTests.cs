namespace Gjk.Core.Tests.Concave;

/// <summary>A compound with solids among its children answers as these do, asked one by one.</summary>
public class SolidChildTests
{
    private const int Seeds = 250;

    /// <summary>World units: a few roundings of the places of leaves, which are composed as floats here.</summary>
    private const float Rounding = 4e-6f;

    private static readonly RigidPose s_here = RigidPose.Identity;

    private readonly ConcaveScratch _scratch = new();

    /// <summary>What each pair of leaves says.</summary>
    private static List<T> OfLeaves<T>(
        SolidChildren a, RigidPose poseA, List<(AnyShape Shape, RigidPose Pose)> leaves, RigidPose poseB,
        Func<AnyShape, RigidPose, AnyShape, RigidPose, T> ask)
    {
        List<T> answers = [];
        foreach ((AnyShape shape, RigidPose own) in a.Leaves)
        {
            foreach ((AnyShape other, RigidPose place) in leaves)
                answers.Add(ask(shape, SolidChildren.Within(poseA, own), other, SolidChildren.Within(poseB, place)));
        }

        return answers;
    }

    [Fact]
    public void DistancesAreTheLeastOfTheLeaves()
    {
        int overlaps = 0, holds = 0;
        for (int seed = 0; seed < Seeds; seed++)
        {
            (SolidChildren a, RigidPose poseA, AnyShape b, RigidPose poseB, var leaves) = SolidChildren.Setup(seed);
            List<PairDistance> all = OfLeaves(
                a, poseA, leaves, poseB, (p, poseP, q, poseQ) => ConcaveQuery.Distance(p, poseP, q, poseQ, _scratch));
            float expected = all.Min(one => one.Distance);
            PairDistance found = ConcaveQuery.Distance(a.Shape, poseA, b, poseB, _scratch);
            PairDistance back = ConcaveQuery.Distance(b, poseB, a.Shape, poseA, _scratch);
            Assert.True(Math.Abs(expected - found.Distance) <= Rounding, $"seed {seed}: {expected}, not {found}");
            Assert.Equal(found.Distance, back.Distance, Rounding);
            Assert.Equal(found.IsOverlapping, ConcaveQuery.Overlaps(a.Shape, poseA, b, poseB, _scratch));
            if (!found.IsOverlapping) continue;
            overlaps++;
            a.Compound.GetChild(found.PartA, out _);
            List<PairDistance> pairs = [];
            Assert.True(ConcaveQuery.FindPairsWithin(a.Shape, poseA, b, poseB, 0, _scratch, pairs));
            if (pairs.Count == 0) holds++;
        }

        Assert.InRange(overlaps, Seeds / 4, Seeds * 3 / 4);
        Assert.InRange(holds, Seeds / 60, Seeds / 2);
    }

    [Fact]
    public void CastsAreTheFirstOfTheLeavesAndAtTheStartTheDeepest()
    {
        int starts = 0, hits = 0, ties = 0;
        for (int seed = 0; seed < Seeds; seed++)
        {
            (SolidChildren a, RigidPose poseA, AnyShape b, RigidPose poseB, var leaves) = SolidChildren.Setup(seed);
            Vector3 way = 2 * (poseA.Position - poseB.Position) + new Vector3(0.1f, 0, 0);
            List<CastHit> all = OfLeaves(
                a, poseA, leaves, poseB,
                (p, poseP, q, poseQ) => ConcaveQuery.Cast(p, poseP, default, q, poseQ, way, _scratch));
            CastHit found = ConcaveQuery.Cast(a.Shape, poseA, default, b, poseB, way, _scratch);
            List<CastHit> started = all.FindAll(one => one.Status == CastStatus.OverlappingAtStart);
            string text = $"seed {seed}: {found}, leaves {string.Join("; ", all)}";
            if (started.Count > 0)
            {
                starts++;
                Assert.True(found.Status == CastStatus.OverlappingAtStart, text);
                float deepest = started.Max(one => one.Result.Depth);
                // Which triangles of a solid are equally near, as at an edge, is decided by a rounding.
                if (Math.Abs(deepest - found.Result.Depth) > Rounding) ties++;
                Assert.True(Math.Abs(deepest - found.Result.Depth) <= 0.1f * deepest, text);
            }
            else
            {
                float first = all.Where(one => one.IsHit).Select(one => one.Fraction).DefaultIfEmpty(1).Min();
                Assert.True(Math.Abs(first - found.Fraction) <= 20 * Rounding, text);
                if (found.IsHit) hits++;
            }

            List<CastHit> list = [];
            Assert.True(ConcaveQuery.CastAll(a.Shape, poseA, default, b, poseB, way, _scratch, list), text);
            Assert.Equal(found.IsHit, list.Count > 0);
            if (found.IsHit) Assert.Equal(found.Result.Depth, list[0].Result.Depth);
            var still = new RigidMotion(poseA, Vector3.Zero);
            CastHit impact = ConcaveQuery.TimeOfImpact(a.Shape, still, b, new RigidMotion(poseB, way), _scratch);
            Assert.Equal(found.Status, impact.Status);
            Assert.Equal(found.Fraction, impact.Fraction, 1e-3f);
            Assert.Equal(found.Result.Depth, impact.Result.Depth);
        }

        Assert.InRange(ties, 0, Seeds / 100);
        Assert.InRange(starts, Seeds / 4, Seeds * 3 / 4);
        Assert.InRange(hits, Seeds / 5, Seeds);
    }

    [Theory]
    [InlineData(RaySides.Both)]
    [InlineData(RaySides.FrontOnly)]
    [InlineData(RaySides.Hollow)]
    [InlineData(RaySides.FrontOnly | RaySides.Hollow)]
    public void RaysAndPointsAskEachLeaf(RaySides sides)
    {
        int starts = 0;
        for (int seed = 0; seed < Seeds; seed++)
        {
            (SolidChildren a, RigidPose poseA, _, RigidPose poseB, _) = SolidChildren.Setup(seed);
            Vector3 origin = poseB.Position, way = poseA.Position - origin + new Vector3(0.1f, 0.2f, 0);
            List<(AnyShape, RigidPose)> point = [(AnyShape.Of(ConvexShape.Point()), s_here)];
            List<RayHit> all = OfLeaves(
                a, poseA, point, poseB, (p, pose, _, _) => ConcaveQuery.RayCast(
                    p, pose, origin, way, _scratch, sides: sides));
            RayHit found = ConcaveQuery.RayCast(a.Shape, poseA, origin, way, _scratch, sides: sides);
            string text = $"seed {seed}: {found}, leaves {string.Join("; ", all)}";
            bool isStart = all.Exists(one => one.Status == CastStatus.OverlappingAtStart);
            Assert.True(isStart == (found.Status == CastStatus.OverlappingAtStart), text);
            if (isStart)
            {
                float deepest = all.Where(one => one.Status == CastStatus.OverlappingAtStart).Max(o => o.Result.Depth);
                starts++;
                Assert.True(Math.Abs(deepest - found.Result.Depth) <= Rounding, text);
            }
            else
            {
                float nearest = all.Where(one => one.IsHit).Select(one => one.Distance).DefaultIfEmpty(9).Min();
                Assert.True(Math.Abs(nearest - (found.IsHit ? found.Distance : 9)) <= 10 * Rounding, text);
            }

            bool isIn = OfLeaves(
                a, poseA, point, poseB, (p, pose, _, _) => ConcaveQuery.Contains(p, pose, origin, _scratch))
                .Contains(true);
            Assert.Equal(isIn, ConcaveQuery.Contains(a.Shape, poseA, origin, _scratch));
        }

        Assert.True(starts > Seeds / 20 || sides.HasFlag(RaySides.Hollow));
    }

    /// <summary>Between crossings the union holds the middle, or not, in turn.</summary>
    [Fact]
    public void ARayCrossesTheUnionOfSolidsInTurn()
    {
        int crossed = 0;
        for (int seed = 0; seed < Seeds; seed++)
        {
            var random = new Rng((ulong)seed);
            SolidChildren a = SolidChildren.Any(random, 1, isAllSolid: true);
            RigidPose pose = ConcaveShapes.Pose(random, 1);
            Vector3 origin = random.Vector(2), way = Vector3.Normalize(pose.Position - origin);
            List<RayHit> hits = [];
            Assert.True(ConcaveQuery.RayCrossings(a.Shape, pose, origin, way, _scratch, hits));
            bool isIn = ConcaveQuery.Contains(a.Shape, pose, origin, _scratch);
            float from = 0;
            foreach (RayHit hit in hits)
            {
                if (hit.Distance - from > 1e-3f)
                {
                    Vector3 middle = origin + way * (0.5f * (from + hit.Distance));
                    Assert.True(isIn == ConcaveQuery.Contains(a.Shape, pose, middle, _scratch), $"seed {seed}");
                }

                Assert.Equal(isIn, Vector3.Dot(hit.Result.Normal, way) > 0);
                (isIn, from) = (!isIn, hit.Distance);
            }

            Assert.False(isIn);
            crossed += hits.Count;
        }

        Assert.InRange(crossed, Seeds / 2, 10 * Seeds);
        var mixed = new CompoundShape([
            new(AnyShape.Solid(ConcaveShapes.Box(Vector3.One)), s_here), new(ConvexShape.Sphere(1), s_here)]);
        Assert.False(ConcaveQuery.RayCrossings(
            AnyShape.Of(mixed), s_here, Vector3.Zero, Vector3.UnitX, _scratch, []));
    }

    [Fact]
    public void ALoneSolidInACompoundIsTheSolid()
    {
        for (int seed = 0; seed < Seeds; seed++)
        {
            var random = new Rng((ulong)seed);
            TriangleMesh mesh = Solids.Named(random.OneIn(2) ? "gear" : "rock", seed);
            RigidPose own = ConcaveShapes.Pose(random, 1), at = new(random.Vector(0.3) + own.Position);
            AnyShape solid = AnyShape.Solid(mesh);
            AnyShape one = AnyShape.Of(new CompoundShape([new CompoundPart(solid, own)]));
            PairDistance expected = ConcaveQuery.SignedDistance(solid, own, at.Position, _scratch);
            PairDistance found = ConcaveQuery.SignedDistance(one, s_here, at.Position, _scratch);
            Assert.Equal(expected.Distance, found.Distance, Rounding);
            AnyShape ball = AnyShape.Of(ConvexShape.Sphere(0.05f));
            CastHit way = ConcaveQuery.Cast(solid, own, default, ball, at, Vector3.UnitX, _scratch);
            CastHit same = ConcaveQuery.Cast(one, s_here, default, ball, at, Vector3.UnitX, _scratch);
            Assert.Equal((way.Status, way.PartB), (same.Status, same.PartB));
            Assert.Equal(way.Result.Depth, same.Result.Depth, Rounding);
        }
    }

    [Fact]
    public void MassesAreTheSum()
    {
        for (int seed = 0; seed < Seeds / 8; seed++)
        {
            var random = new Rng((ulong)seed);
            SolidChildren a = SolidChildren.Any(random, 2, isAllSolid: true);
            double mass = a.Leaves.Sum(leaf => leaf.Shape.GetMassProperties(3).Mass);
            Double3 moment = default;
            foreach ((AnyShape shape, RigidPose pose) in a.Leaves)
            {
                MassProperties leaf = shape.GetMassProperties(3);
                moment += (Double3)pose.TransformPoint((Vector3)leaf.Center) * leaf.Mass;
            }

            MassProperties found = a.Compound.GetMassProperties(3);
            Assert.Equal(1, found.Mass / mass, 1e-5);
            Assert.True(((Double3)found.Center - moment * (1 / mass)).Length < 1e-5, $"seed {seed}");
        }

        TriangleMesh box = ConcaveShapes.Box(new Vector3(1, 2, 3));
        var turned = new RigidPose(Quaternion.Normalize(new Quaternion(0.1f, 0.2f, 0.3f, 0.9f)), new Vector3(5, 6, 7));
        var pair = new CompoundShape([
            new(AnyShape.Solid(box), turned), new(ConvexShape.Box(new Vector3(1, 2, 3)), turned)]);
        var alone = new CompoundShape([new(AnyShape.Solid(box), turned)]);
        Assert.Equal(96, pair.Scaled(new Vector3(-1, 1, 1)).GetMassProperties().Mass, 1e-9);
        Assert.Equal(6 * 48, alone.Scaled(new Vector3(1, -2, 3)).GetMassProperties().Mass, 1e-9);
        Assert.Throws<ArgumentOutOfRangeException>("density", () => alone.GetMassProperties(-1));
    }
}
