namespace Gjk.Core.Tests.Concave;

/// <summary>Every answer is, to the last bit, the least that single queries say of all pairs of parts.</summary>
public class BruteForceTests
{
    private const int Pairs = 60;
    private readonly ConcaveScratch _scratch = new();

    [Fact]
    public void TheDistanceIsTheLeastOfAllParts()
    {
        int overlaps = 0;
        for (int seed = 0; seed < Pairs; seed++)
        {
            var pair = new Pair(seed);
            List<DistanceResult> all = pair.All(
                (in ConvexShape a, in ConvexShape b) => ConvexQuery.Distance(a, pair.PoseA, b, pair.PoseB));
            DistanceResult least = all[0];
            foreach (DistanceResult one in all)
                if (one.Distance < least.Distance) least = one;
            PairDistance found = ConcaveQuery.Distance(pair.A, pair.PoseA, pair.B, pair.PoseB, _scratch);
            string name = $"seed {seed}: {found}, least {least}";
            Assert.True(found.Distance == least.Distance, name);
            Assert.True(found.Result.LowerBound <= least.Distance, name);
            int index = pair.Index(found.PartA, found.PartB);
            Assert.True(all[index].Distance == least.Distance && all[index].PointA == found.Result.PointA, name);
            bool isOverlap = ConcaveQuery.Overlaps(pair.A, pair.PoseA, pair.B, pair.PoseB, _scratch);
            Assert.True(isOverlap == least.IsOverlapping, name);
            if (isOverlap) overlaps++;
        }

        Assert.InRange(overlaps, Pairs / 5, Pairs * 4 / 5);
    }

    [Fact]
    public void ALimitKeepsWhatIsWithinIt()
    {
        for (int seed = 0; seed < Pairs; seed++)
        {
            var pair = new Pair(seed);
            PairDistance found = ConcaveQuery.Distance(pair.A, pair.PoseA, pair.B, pair.PoseB, _scratch);
            PairDistance within = ConcaveQuery.Distance(
                pair.A, pair.PoseA, pair.B, pair.PoseB, _scratch, found.Distance);
            Assert.True(found.Distance == within.Distance, $"seed {seed}");
            if (found.IsOverlapping) continue;
            PairDistance beyond = ConcaveQuery.Distance(
                pair.A, pair.PoseA, pair.B, pair.PoseB, _scratch, found.Distance * 0.999f);
            Assert.True(beyond.Status == GjkStatus.BeyondMaxDistance, $"seed {seed}: {beyond}");
            Assert.True(beyond.Result.LowerBound <= found.Distance, $"seed {seed}");
        }
    }

    [Fact]
    public void ThePairsWithinADistanceAreAllOfThem()
    {
        var pairs = new List<PairDistance>();
        for (int seed = 0; seed < Pairs; seed++)
        {
            var pair = new Pair(seed);
            float reach = ConcaveQuery.Distance(pair.A, pair.PoseA, pair.B, pair.PoseB, _scratch).Distance + 0.1f;
            List<DistanceResult> all = pair.All(
                (in ConvexShape a, in ConvexShape b) => ConvexQuery.Distance(a, pair.PoseA, b, pair.PoseB, reach));
            Assert.True(
                ConcaveQuery.FindPairsWithin(pair.A, pair.PoseA, pair.B, pair.PoseB, reach, _scratch, pairs));
            int next = 0;
            for (int i = 0; i < all.Count; i++)
            {
                if (all[i].Status == GjkStatus.BeyondMaxDistance) continue;
                Assert.True(next < pairs.Count, $"seed {seed}: {i} is missing");
                int index = pair.Index(pairs[next].PartA, pairs[next].PartB);
                Assert.True(index == i && pairs[next].Distance == all[i].Distance, $"seed {seed}: {i}");
                next++;
            }

            Assert.Equal(pairs.Count, next);
        }
    }

    [Fact]
    public void DepthsAreThoseOfTheOverlappingParts()
    {
        var pairs = new List<PairDistance>();
        for (int seed = 0; seed < Pairs; seed += 4)
        {
            var pair = new Pair(seed);
            List<DistanceResult> all = pair.All(
                (in ConvexShape a, in ConvexShape b) => ConvexQuery.SignedDistance(a, pair.PoseA, b, pair.PoseB));
            Assert.True(ConcaveQuery.FindDepths(pair.A, pair.PoseA, pair.B, pair.PoseB, _scratch, pairs));
            foreach (PairDistance one in pairs)
                Assert.True(all[pair.Index(one.PartA, one.PartB)].Distance == one.Distance, $"seed {seed}: {one}");
            Assert.Equal(all.FindAll(one => one.IsOverlapping).Count, pairs.Count);
        }
    }

    [Fact]
    public void TheFirstContactIsTheLeastOfAllParts()
    {
        int hits = 0;
        for (int seed = 0; seed < Pairs; seed++)
        {
            var pair = new Pair(seed);
            var random = new Rng((ulong)seed + 1000);
            Vector3 wayA = random.Vector(0.5), wayB = (pair.PoseA.Position - pair.PoseB.Position) * 1.5f;
            if (random.OneIn(10)) wayB = wayA;
            List<CastResult> all = pair.All(
                (in ConvexShape a, in ConvexShape b) => ConvexQuery.Cast(a, pair.PoseA, wayA, b, pair.PoseB, wayB));
            CastHit found = ConcaveQuery.Cast(pair.A, pair.PoseA, wayA, pair.B, pair.PoseB, wayB, _scratch);
            int least = -1;
            for (int i = 0; i < all.Count; i++)
            {
                if (!all[i].IsHit) continue;
                if (least < 0 || IsBefore(all[i], all[least])) least = i;
            }

            Assert.True(least >= 0 == found.IsHit, $"seed {seed}: {found}");
            if (least < 0) continue;
            hits++;
            Assert.True(
                found.Status == all[least].Status && found.Fraction == all[least].Fraction
                    && pair.Index(found.PartA, found.PartB) == least,
                $"seed {seed}: {found}, but {all[least]} of {least}");
        }

        Assert.InRange(hits, Pairs / 3, Pairs);
    }

    [Fact]
    public void TheFirstImpactIsTheLeastOfAllParts()
    {
        for (int seed = 0; seed < Pairs; seed += 5)
        {
            var pair = new Pair(seed);
            var random = new Rng((ulong)seed + 2000);
            var motionA = new RigidMotion(pair.PoseA, random.Vector(0.5), random.Vector(1));
            var motionB = new RigidMotion(
                pair.PoseB, (pair.PoseA.Position - pair.PoseB.Position) * 1.5f, random.Vector(1));
            List<CastResult> all = pair.All(
                (in ConvexShape a, in ConvexShape b) => ConvexQuery.TimeOfImpact(a, motionA, b, motionB));
            CastHit found = ConcaveQuery.TimeOfImpact(pair.A, motionA, pair.B, motionB, _scratch);
            float least = float.PositiveInfinity;
            foreach (CastResult one in all)
                if (one.IsHit && one.Fraction < least) least = one.Fraction;
            Assert.True(
                found.IsHit ? found.Fraction == least : float.IsPositiveInfinity(least),
                $"seed {seed}: {found}, but {least}");
        }
    }

    [Fact]
    public void ARayMeetsThePartsInTheirOrder()
    {
        var hits = new List<RayHit>();
        int met = 0;
        for (int seed = 0; seed < 3 * Pairs; seed++)
        {
            var pair = new Pair(seed);
            var random = new Rng((ulong)seed + 3000);
            Vector3 origin = random.Vector(3), direction = pair.PoseA.Position + random.Vector(0.6) - origin;
            List<ConvexShape> parts = ConcaveShapes.Parts(pair.A);
            int least = -1, count = 0;
            float distance = float.PositiveInfinity;
            for (int i = 0; i < parts.Count; i++)
            {
                RayCastResult one = ConvexQuery.RayCast(parts[i], pair.PoseA, origin, direction);
                if (!one.IsHit) continue;
                count++;
                if (one.Distance < distance) (least, distance) = (i, one.Distance);
            }

            RayHit found = ConcaveQuery.RayCast(pair.A, pair.PoseA, origin, direction, _scratch);
            Assert.True(least >= 0 == found.IsHit, $"seed {seed}: {found}");
            Assert.True(ConcaveQuery.RayCastAll(pair.A, pair.PoseA, origin, direction, _scratch, hits));
            Assert.Equal(count, hits.Count);
            if (least < 0) continue;
            met++;
            int part = pair.A.Kind == AnyShapeKind.Convex ? 0 : found.Part;
            Assert.True(found.Distance == distance && part == least, $"seed {seed}: {found}, but {least}");
            Assert.True(hits[0].Distance == distance && hits[0].Part == found.Part, $"seed {seed}: {hits[0]}");
        }

        Assert.InRange(met, Pairs / 2, 3 * Pairs);
    }

    [Fact]
    public void AWarmScratchAllocatesNothing()
    {
        var pair = new Pair(3);
        Assert.Equal(
            0,
            Allocation.Least(() =>
            {
                ConcaveQuery.Distance(pair.A, pair.PoseA, pair.B, pair.PoseB, _scratch);
                ConcaveQuery.Cast(
                    pair.A, pair.PoseA, Vector3.One, pair.B, pair.PoseB, -Vector3.One, _scratch);
                ConcaveQuery.RayCast(pair.A, pair.PoseA, Vector3.One, Vector3.UnitX, _scratch);
                ConcaveQuery.Contains(pair.A, pair.PoseA, Vector3.One, _scratch);
            }));
    }

    /// <summary>Parts that are met at once are compared by more than the fraction.</summary>
    [Fact]
    public void PartsThatAreMetAtOnceAllocateNothing()
    {
        var body = AnyShape.Of(ConvexShape.Box(new Vector3(0.5f)));
        RigidPose above = new(new Vector3(1.5f, 3, 1.5f));
        var turning = new RigidMotion(above, new Vector3(0, -4, 0), new Vector3(0, 1, 0));
        var still = new RigidMotion(RigidPose.Identity, Vector3.Zero);
        foreach (string name in new[] { "tiles", "plate" })
        {
            AnyShape floor = Floors.Named(name);
            long allocated = Allocation.Least(() =>
            {
                Assert.True(ConcaveQuery.Cast(
                    body, above, new Vector3(0, -4, 0), floor, RigidPose.Identity, Vector3.Zero, _scratch).IsHit);
                ConcaveQuery.TimeOfImpact(body, turning, floor, still, _scratch);
            });
            Assert.Equal(0, allocated);
        }
    }

    /// <summary>Of equals the first in the order of the parts stays.</summary>
    private static bool IsBefore(in CastResult one, in CastResult other) => one.Order.CompareTo(other.Order) < 0;

    /// <summary>Two shapes and their poses, from a seed.</summary>
    private sealed class Pair
    {
        public readonly AnyShape A, B;
        public readonly RigidPose PoseA, PoseB;
        private readonly List<ConvexShape> _partsA, _partsB;

        public Pair(int seed)
        {
            var random = new Rng((ulong)seed);
            A = seed % 6 == 5
                ? AnyShape.Of(ConcaveShapes.Nested(random, 2, []))
                : ConcaveShapes.Any(random);
            B = ConcaveShapes.Any(random);
            (PoseA, PoseB) = (ConcaveShapes.Pose(random, 0.7), ConcaveShapes.Pose(random, 0.7));
            (_partsA, _partsB) = (ConcaveShapes.Parts(A), ConcaveShapes.Parts(B));
        }

        public delegate T Question<T>(in ConvexShape a, in ConvexShape b);

        public List<T> All<T>(Question<T> ask)
        {
            var all = new List<T>(_partsA.Count * _partsB.Count);
            foreach (ConvexShape a in _partsA)
                foreach (ConvexShape b in _partsB) all.Add(ask(a, b));
            return all;
        }

        public int Index(int partA, int partB)
        {
            Assert.Equal(A.Kind == AnyShapeKind.Convex, partA < 0);
            Assert.Equal(B.Kind == AnyShapeKind.Convex, partB < 0);
            return System.Math.Max(partA, 0) * _partsB.Count + System.Math.Max(partB, 0);
        }
    }
}
