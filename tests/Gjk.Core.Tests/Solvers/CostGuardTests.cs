namespace Gjk.Core.Tests.Solvers;

/// <summary>The cost of queries in support calls on each shape, which no machine's load or speed can change. The bounds
/// are the counts at the time of writing: a change that costs more than the slack is a step or a termination that got
/// worse, and a gain should be kept by lowering the number.</summary>
public class CostGuardTests
{
    /// <summary>How far a sum may exceed its bound, as a share: what another order of equal vertices may
    /// cost.</summary>
    private const double Slack = 0.05;

    private const int RandomPairs = 2000;

    [Theory]
    [InlineData("parallel", 2130)]
    [InlineData("align", 2541)]
    [InlineData("touch", 3776)]
    [InlineData("deep", 1574)]
    [InlineData("aspect", 2260)]
    [InlineData("large", 1770)]
    [InlineData("degenerate", 2601)]
    [InlineData("dense", 3580)]
    public void DistanceStaysInBoundsOnTheHardFamilies(string family, int bound) =>
        AssertCost(family, bound, CaseFamily.Load(family).Cases.Sum(c => c.Pair.Distance().Iterations));

    [Theory]
    [InlineData("cubes", 588)]
    [InlineData("spheres", 546)]
    public void DistanceStaysInBoundsOnTheReportScenes(string scene, int bound) =>
        AssertCost(scene, bound, ScenePairs(scene).Sum(p => p.Distance().Iterations));

    [Theory]
    [InlineData("box", 9077)]
    [InlineData("hull", 9346)]
    [InlineData("bigHull", 9573)]
    [InlineData("capsule", 6875)]
    [InlineData("cylinder", 16199)]
    [InlineData("ellipsoid", 21602)]
    public void DistanceStaysInBoundsOnRandomPairs(string kind, int bound) =>
        AssertCost(kind, bound, Random(kind).Sum(p => p.Distance().Iterations));

    [Theory]
    [InlineData("parallel", 1125)]
    [InlineData("align", 2217)]
    [InlineData("touch", 3808)]
    [InlineData("deep", 2364)]
    [InlineData("aspect", 1575)]
    [InlineData("large", 883)]
    [InlineData("degenerate", 2506)]
    [InlineData("dense", 2422)]
    public void OverlapsStaysInBoundsOnTheHardFamilies(string family, int bound) =>
        AssertCost(family, bound, OverlapCalls(CaseFamily.Load(family).Cases.Select(c => c.Pair)));

    [Theory]
    [InlineData("cubes", 20)]
    [InlineData("spheres", 20)]
    public void OverlapsStaysInBoundsOnTheReportScenes(string scene, int bound) =>
        AssertCost(scene, bound, OverlapCalls(ScenePairs(scene)));

    [Theory]
    [InlineData("box", 7280)]
    [InlineData("hull", 6152)]
    [InlineData("bigHull", 6960)]
    public void OverlapsStaysInBoundsOnRandomPairs(string kind, int bound) =>
        AssertCost(kind, bound, OverlapCalls(Random(kind)));

    /// <summary>A pair of separated polytopes that has not moved is proved by one look along the old normal.</summary>
    [Theory]
    [InlineData("cubes")]
    [InlineData("spheres")]
    [InlineData("box")]
    [InlineData("hull")]
    [InlineData("bigHull")]
    [InlineData("capsule")]
    public void AWarmQueryOfAPairAtRestTakesOneSupportCall(string set)
    {
        IEnumerable<TestPair> pairs = set is "cubes" or "spheres" ? ScenePairs(set) : Random(set);
        int separated = 0;
        foreach (TestPair p in pairs)
        {
            var warm = default(WarmStart);
            DistanceResult first = ConvexQuery.Distance(p.A.Shape, p.PoseA, p.B.Shape, p.PoseB, ref warm);
            DistanceResult again = ConvexQuery.Distance(p.A.Shape, p.PoseA, p.B.Shape, p.PoseB, ref warm);
            if (first.Status != GjkStatus.Separated) continue;
            separated++;
            Assert.True(
                again.Iterations <= 1,
                $"{p}: {again.Iterations} support calls from a warm start, {first.Iterations} from a cold one");
        }

        Assert.True(separated > 100, $"{set}: only {separated} pairs are separated");
    }

    /// <summary>What the other tests take a count from: <see cref="DistanceResult.Iterations"/> is how often each shape
    /// was asked.</summary>
    [Fact]
    public void IterationsAreSupportCalls()
    {
        foreach (TestPair p in ScenePairs("cubes").Concat(Random("hull")))
        {
            int[] callsA = [0], callsB = [0];
            DistanceResult r = ConvexQuery.Distance(
                new SupportCounter(p.A.Shape, callsA), p.PoseA, new SupportCounter(p.B.Shape, callsB), p.PoseB);
            Assert.True(
                r.Iterations == callsA[0] && r.Iterations == callsB[0],
                $"{p}: {r.Iterations} iterations, {callsA[0]} and {callsB[0]} support calls");
        }
    }

    /// <summary>Shapes whose balls are apart are not searched for a depth.</summary>
    [Theory]
    [InlineData("cubes")]
    [InlineData("spheres")]
    public void TheSignedDistanceOfPairsFarApartCostsADistance(string scene)
    {
        int apart = 0;
        foreach (TestPair p in ScenePairs(scene))
        {
            double radii = p.A.Shape.BoundingRadius + p.B.Shape.BoundingRadius;
            if (Vector3.Distance(p.PoseA.Position, p.PoseB.Position) < 1.001 * radii) continue;
            apart++;
            int[] callsA = [0], callsB = [0];
            DistanceResult r = ConvexQuery.SignedDistance(
                new SupportCounter(p.A.Shape, callsA), p.PoseA, new SupportCounter(p.B.Shape, callsB), p.PoseB);
            Assert.True(
                r.Iterations == callsA[0] && r.Iterations == callsB[0],
                $"{p}: {r.Iterations} iterations, {callsA[0]} and {callsB[0]} support calls");
        }

        Assert.True(apart > 100, $"{scene}: only {apart} pairs are apart");
    }

    private static TestPair[] Random(string kind) =>
        [.. Enumerable.Range(0, RandomPairs).Select(i => Generators.Pair((ulong)i, [kind]))];

    private static IEnumerable<TestPair> ScenePairs(string name)
    {
        BuiltInScene scene = name == "cubes" ? BuiltInScenes.Cubes() : BuiltInScenes.Spheres();
        Vector3[] vertices = [.. scene.Vertices];
        TestShape shape = TestShape.Mesh(name, new ConvexHull(vertices), vertices);
        for (int a = 0; a < scene.Poses.Count; a++)
            for (int b = a + 1; b < scene.Poses.Count; b++)
                yield return new TestPair($"{name} {a},{b}", shape, scene.Poses[a], shape, scene.Poses[b]);
    }

    private static int OverlapCalls(IEnumerable<TestPair> pairs)
    {
        int[] calls = [0], ignored = [0];
        foreach (TestPair p in pairs)
            ConvexQuery.Overlaps(
                new SupportCounter(p.A.Shape, calls), p.PoseA, new SupportCounter(p.B.Shape, ignored), p.PoseB);
        return calls[0];
    }

    private static void AssertCost(string name, int bound, int calls)
    {
        Assert.True(calls > 0, $"{name}: nothing was asked");
        Assert.True(
            calls <= bound * (1 + Slack), $"{name}: {calls} support calls, the bound is {bound} and {Slack:P0}");
    }
}
