namespace Gjk.Core.Tests.Solvers;

/// <summary>A traced query answers as the plain one does, bit for bit, and what it tells is true.</summary>
public class TraceTests
{
    /// <summary>Of the pair's scale: what rounding may add to a bound worked out from rounded vertices.</summary>
    private const double Rounding = 1e-13;

    public static TheoryData<string> Families => [.. CaseFamily.Names];

    public static TheoryData<string> Kinds => [.. Generators.AllKinds, .. Generators.LaterKinds, "bigHull"];

    [Theory]
    [MemberData(nameof(Families))]
    public void TheHardCasesAreAnsweredBitForBit(string family)
    {
        foreach (HardCase c in CaseFamily.Load(family).Cases) Check(c.Pair);
    }

    [Theory]
    [MemberData(nameof(Kinds))]
    public void EveryKindIsAnsweredBitForBit(string kind)
    {
        for (int i = 0; i < 200; i++) Check(Generators.Pair((ulong)i, [kind, "hull", "sphere"], spread: 1.3));
    }

    [Fact]
    public void ExtendedPrecisionIsTold()
    {
        int extended = 0;
        foreach (HardCase c
            in CaseFamily.Load("degenerate").Cases.Concat(CaseFamily.Load("parallel").Cases).Concat(
                CaseFamily.Load("touch").Cases))
        {
            (_, Recorder trace) = Run(c.Pair);
            int first = trace.Supports.FindIndex(s => s.IsExtended);
            if (first < 0) continue;
            extended++;
            Assert.All(trace.Supports.Skip(first), s => Assert.True(s.IsExtended));
        }

        Assert.InRange(extended, 1, 500);
    }

    [Fact]
    public void SpheresAreToldAsOneRoundAndInvalidInputTellsNothing()
    {
        var spheres = new Recorder();
        DistanceResult apart = ConvexQuery.Explain(
            ConvexShape.Sphere(1), RigidPose.Identity, ConvexShape.Sphere(1), new RigidPose(new(3, 0, 0)), ref spheres);
        Assert.Equal((GjkStatus.Separated, 1f, 1), (apart.Status, apart.Distance, apart.Iterations));
        Assert.Equal(
            (new Double3(-3, 0, 0), 3.0), (Assert.Single(spheres.Supports).Vertex, spheres.Supports[0].LowerBound));
        Assert.Equal((1, 3.0), (Assert.Single(spheres.Simplices).Count, spheres.Simplices[0].UpperBound));

        var invalid = new Recorder();
        Assert.Equal(
            GjkStatus.InvalidInput,
            ConvexQuery.Explain(ConvexShape.Sphere(1), default, default(ConvexShape), default, ref invalid).Status);
        Assert.Empty(invalid.Supports);
    }

    [Fact]
    public void ATraceThatIsOffIsNotCalled()
    {
        var off = default(Off);
        for (int i = 0; i < 100; i++)
        {
            TestPair p = Generators.Pair((ulong)i, Generators.AllKinds);
            Same(p, p.Distance(), ConvexQuery.Explain(p.A.Shape, p.PoseA, p.B.Shape, p.PoseB, ref off));
        }
    }

    [Fact]
    public void ATraceThatOnlyCountsAllocatesNothing()
    {
        TestPair[] pairs = [.. Enumerable.Range(0, 100).Select(i => Generators.Pair((ulong)i, Generators.AllKinds))];
        var counter = default(Counter);
        Run();
        int once = counter.Calls, runs = 1;
        Assert.Equal(0, Allocation.Least(() =>
        {
            Run();
            runs++;
        }));
        Assert.Equal(runs * once, counter.Calls);
        Assert.True(once > 100);

        void Run()
        {
            foreach (TestPair p in pairs) ConvexQuery.Explain(p.A.Shape, p.PoseA, p.B.Shape, p.PoseB, ref counter);
        }
    }

    [Fact]
    public void IndicesAreChecked()
    {
        (_, Recorder trace) = Run(Generators.Pair(1, ["box"], spread: 2));
        TracedSimplex simplex = trace.Simplices[^1];
        Assert.Throws<ArgumentOutOfRangeException>("index", () => simplex.Vertex(simplex.Count));
        Assert.Throws<ArgumentOutOfRangeException>("index", () => simplex.Vertex(-1));
        Assert.Throws<ArgumentOutOfRangeException>("index", () => simplex.Weight(simplex.Count));
    }

    private static (DistanceResult Result, Recorder Trace) Run(TestPair p)
    {
        var recorder = new Recorder();
        return (ConvexQuery.Explain(p.A.Shape, p.PoseA, p.B.Shape, p.PoseB, ref recorder), recorder);
    }

    private static void Check(TestPair p)
    {
        (DistanceResult r, Recorder trace) = Run(p);
        Same(p, p.Distance(), r);
        Assert.True(
            r.Iterations == trace.Supports.Count, $"{p}: {r.Iterations} iterations, {trace.Supports.Count} told");
        double slack = Rounding * (p.Scale + r.Distance), margins = p.A.Shape.Margin + p.B.Shape.Margin;
        foreach (TracedSupport s in trace.Supports)
        {
            Assert.True(
                (s.PointOnA - s.PointOnB - s.Vertex).Length <= slack + Rounding * s.PointOnA.Length,
                $"{p}: a vertex is not its points' difference");
            Assert.True(
                s.LowerBound - margins <= r.Distance * (1 + 1e-6) + slack,
                $"{p}: a plane proves {s.LowerBound - margins:R}, the distance is {r.Distance:R}");
        }

        double before = double.PositiveInfinity;
        for (int i = 0; i < trace.Simplices.Count; i++)
        {
            TracedSimplex s = trace.Simplices[i];
            if (i > 0 && s.IsExtended != trace.Simplices[i - 1].IsExtended) before = double.PositiveInfinity;
            Assert.InRange(s.Count, 1, 4);
            Double3 sum = default;
            double weights = 0;
            for (int k = 0; k < s.Count; k++)
            {
                Assert.True(trace.Supports.Exists(t => t.Vertex == s.Vertex(k)), $"{p}: a vertex that no support gave");
                Assert.True(s.Weight(k) >= 0);
                sum += s.Vertex(k) * s.Weight(k);
                weights += s.Weight(k);
            }

            Assert.Equal(1, weights, 1e-12);
            Assert.True((sum - s.Nearest).Length <= slack, $"{p}: the nearest point is not the weighted sum");
            Assert.True(
                r.IsOverlapping || s.UpperBound - margins >= r.Distance * (1 - 1e-6) - slack,
                $"{p}: |v| less the margins is {s.UpperBound - margins:R}, the distance is {r.Distance:R}");
            Assert.True(s.UpperBound <= before + slack, $"{p}: |v| rose from {before:R} to {s.UpperBound:R}");
            before = s.UpperBound;
        }
    }

    /// <summary>Field by field, bit by bit.</summary>
    private static void Same(TestPair p, DistanceResult plain, DistanceResult traced) =>
        Assert.True(ResultBits.AreSame(plain, traced), p.ToString());

    private readonly struct Recorder : IGjkTrace
    {
        public readonly List<TracedSupport> Supports = [];
        public readonly List<TracedSimplex> Simplices = [];

        public Recorder()
        {
        }

        public bool IsOn => true;

        public void OnSupport(in TracedSupport support) => Supports.Add(support);

        public void OnReduced(in TracedSimplex simplex) => Simplices.Add(simplex);
    }

    private struct Counter : IGjkTrace
    {
        public int Calls;

        public readonly bool IsOn => true;

        public void OnSupport(in TracedSupport support) => Calls++;

        public void OnReduced(in TracedSimplex simplex) => Calls += simplex.Count > 0 ? 1 : 0;
    }

    private readonly struct Off : IGjkTrace
    {
        public bool IsOn => false;

        public void OnSupport(in TracedSupport support) => throw new InvalidOperationException("It was off.");

        public void OnReduced(in TracedSimplex simplex) => throw new InvalidOperationException("It was off.");
    }
}
