namespace Gjk.Core.Tests.Solvers;

/// <summary>A traced search for a depth answers as <c>SignedDistance</c> does, bit for bit. Each told surface is
/// closed, and the bounds enclose the depth.</summary>
public class PolytopeTraceTests
{
    /// <summary>Of the pair's scale: what rounding may add to a length.</summary>
    private const double Rounding = 1e-13;

    public static TheoryData<string> Families => [.. CaseFamily.DepthNames, .. CaseFamily.Names];

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
        int told = 0;
        for (int i = 0; i < Budget.Count(100); i++)
            told += Check(Generators.Pair(91_000 + (ulong)i, [kind, "hull", "box"], spread: 0.7));
        Assert.True(told > 0);
    }

    [Theory]
    [InlineData(1e-30f)]
    [InlineData(1e30f)]
    public void LengthsAreWorldUnitsAtAnySize(float factor)
    {
        for (int i = 0; i < 50; i++)
            Check(Generators.Pair(92_000 + (ulong)i, ["hull", "box", "capsule"], spread: 0.5).Resized(factor));
    }

    [Fact]
    public void BoxesAreToldThoughTheirAnswerNeedsNoSupports()
    {
        ConvexShape box = ConvexShape.Box(new(1, 2, 3));
        var trace = new Recorder();
        DistanceResult r = ConvexQuery.ExplainDepth(
            box, RigidPose.Identity, box, new RigidPose(new(1.5f, 0, 0)), ref trace);
        Assert.Equal((-0.5f, 0), (r.Distance, r.Iterations));
        Step last = trace.Steps[^1];
        Assert.Equal((PolytopeOutcome.BoundsMet, 0.5, 0.5), (last.Outcome, last.Below, last.Above));
    }

    /// <summary>The surface is told to its end; what was found without one afterwards is not.</summary>
    [Fact]
    public void ASearchWithoutRoomSaysSoOnce()
    {
        ConvexShape ball = ConvexShape.Ellipsoid(new(1, 0.999f, 0.998f));
        var trace = new Recorder();
        DistanceResult r = ConvexQuery.ExplainDepth(ball, RigidPose.Identity, ball, RigidPose.Identity, ref trace);
        Step end = Assert.Single(trace.Steps, s => s.Outcome != PolytopeOutcome.Grows);
        Assert.Equal((PolytopeOutcome.OutOfRoom, 0), (end.Outcome, end.FaceCount));
        Assert.InRange(-r.Distance, (float)end.Below, (float)end.Above);
    }

    [Fact]
    public void NothingIsToldWhereNothingIsSearched()
    {
        var trace = new Recorder();
        ConvexShape sphere = ConvexShape.Sphere(1), capsule = ConvexShape.Capsule(1, 1);
        ConvexQuery.ExplainDepth(sphere, RigidPose.Identity, sphere, new RigidPose(new(1, 0, 0)), ref trace);
        ConvexQuery.ExplainDepth(capsule, RigidPose.Identity, capsule, new RigidPose(new(1, 0, 0)), ref trace);
        ConvexQuery.ExplainDepth(sphere, default, default(ConvexShape), default, ref trace);
        Assert.Empty(trace.Steps);
    }

    [Fact]
    public void ATraceThatIsOffIsNotCalled()
    {
        var off = default(Off);
        for (int i = 0; i < 100; i++)
        {
            TestPair p = Generators.Pair((ulong)i, Generators.AllKinds, spread: 0.6);
            DistanceResult r = ConvexQuery.ExplainDepth(p.A.Shape, p.PoseA, p.B.Shape, p.PoseB, ref off);
            Assert.True(ResultBits.AreSame(p.SignedDistance(), r), p.ToString());
        }
    }

    [Fact]
    public void ATraceThatOnlyCountsAllocatesNothing()
    {
        TestPair[] pairs =
            [.. Enumerable.Range(0, 100).Select(i => Generators.Pair((ulong)i, Generators.AllKinds, spread: 0.6))];
        var counter = default(Counter);
        Run();
        int once = counter.Calls;
        int runs = 1;
        Assert.Equal(0, Allocation.Least(() =>
        {
            Run();
            runs++;
        }));
        Assert.Equal(runs * once, counter.Calls);
        Assert.True(once > 100);

        void Run()
        {
            foreach (TestPair p in pairs) ConvexQuery.ExplainDepth(p.A.Shape, p.PoseA, p.B.Shape, p.PoseB, ref counter);
        }
    }

    [Fact]
    public void NumbersAreChecked()
    {
        var asker = default(WrongNumbers);
        ConvexShape box = ConvexShape.Box(new(1));
        ConvexQuery.ExplainDepth(box, RigidPose.Identity, box, new RigidPose(new(1, 0, 0)), ref asker);
        ConvexShape flat = ConvexShape.Segment(default, new(1, 0, 0));
        ConvexQuery.ExplainDepth(flat, RigidPose.Identity, flat, RigidPose.Identity, ref asker);
        Assert.True(asker.Surfaces > 0 && asker.Others > 0);
    }

    /// <summary>Returns how many steps were told.</summary>
    private static int Check(TestPair p)
    {
        var trace = new Recorder();
        DistanceResult r = ConvexQuery.ExplainDepth(p.A.Shape, p.PoseA, p.B.Shape, p.PoseB, ref trace);
        Assert.True(ResultBits.AreSame(p.SignedDistance(), r), p.ToString());
        double above = double.PositiveInfinity;
        double slack = Rounding * (p.Scale + p.PoseA.Position.Length() + p.PoseB.Position.Length());
        bool isNew = true;
        foreach (Step step in trace.Steps)
        {
            if (isNew) above = double.PositiveInfinity;
            Assert.True(step.Problem is null, $"{step.Problem}: {p}");
            Assert.True(step.Above <= above, $"the upper bound rose to {step.Above:R}: {p}");
            above = step.Above;
            isNew = step.Outcome != PolytopeOutcome.Grows;
        }

        if (trace.Steps.Count == 0) return 0;
        Step last = trace.Steps[^1];
        Assert.NotEqual(PolytopeOutcome.Grows, last.Outcome);
        double margins = p.A.Shape.Margin + p.B.Shape.Margin, depth = -r.Distance - margins;
        slack += (p.IsPolytope ? 1.2e-7 : 1e-6) * (Math.Abs(r.Distance) + margins + (p.IsPolytope ? 0 : p.Scale));
        Assert.True(
            (last.Below <= 0 || last.Below - slack <= depth) && depth <= last.Above + slack,
            $"depth {depth:R} is not between {last.Below:R} and {last.Above:R}: {p}");
        return trace.Steps.Count;
    }

    /// <summary>What is kept of a step.</summary>
    private sealed record Step(
        PolytopeOutcome Outcome, int FaceCount, int Room, double Below, double Above, string? Problem);

    private readonly struct Recorder : IPolytopeTrace
    {
        public readonly List<Step> Steps = [];

        public Recorder()
        {
        }

        public bool IsOn => true;

        public void OnStep(in PolytopeStep step) =>
            Steps.Add(
                new Step(step.Outcome, step.FaceCount, step.Room, step.Below, step.Above, ProblemOf(step)));

        private static string? ProblemOf(in PolytopeStep step)
        {
            if (step.FaceCount == 0) return step.LowestFace < 0 && step.NextFace(-1) < 0 ? null : "a face of nothing";
            var edges = new Dictionary<(int, int), int>();
            int faces = 0;
            double lowest = step.Face(step.LowestFace).Height;
            for (int i = step.NextFace(-1); i >= 0; i = step.NextFace(i), faces++)
            {
                TracedFace face = step.Face(i);
                foreach ((int from, int to) in new[] { (face.A, face.B), (face.B, face.C), (face.C, face.A) })
                {
                    edges[(from, to)] = edges.GetValueOrDefault((from, to)) + 1;
                    edges[(to, from)] = edges.GetValueOrDefault((to, from)) - 1;
                    if (from >= step.VertexCount - 1) return "a corner that is not on the surface";
                    double offset = Double3.Dot(face.Normal, step.Vertex(from)), size = step.Vertex(from).Length;
                    if (!(offset >= face.Height - 1e-14 * size)) return "a corner below its face";
                }

                if (!(Math.Abs(face.Normal.Length - 1) < 1e-12)) return "a normal that is no unit";
                if (face.Height < lowest - Math.Abs(lowest) / (1L << 43)) return "a face lower than the lowest";
            }

            if (edges.Values.Any(twice => twice != 0)) return "an edge without a twin";
            if (faces != step.FaceCount || faces < 4) return $"{faces} faces, {step.FaceCount} are told";
            if (!(step.Below >= lowest)) return "a lower bound below the lowest height";
            TracedSupport s = step.Support;
            if (s.Vertex != step.Vertex(step.VertexCount - 1)) return "a support that is not the last vertex";
            if (s.Normal != -step.Face(step.LowestFace).Normal) return "a support in another direction";
            double reach = s.PointOnA.Length + s.PointOnB.Length;
            return (s.PointOnA - s.PointOnB - s.Vertex).Length <= 1e-13 * reach
                ? null
                : "a vertex that is not its points' difference";
        }
    }

    private struct Counter : IPolytopeTrace
    {
        public int Calls;

        public readonly bool IsOn => true;

        public void OnStep(in PolytopeStep step) => Calls++;
    }

    private readonly struct Off : IPolytopeTrace
    {
        public bool IsOn => false;

        public void OnStep(in PolytopeStep step) => throw new InvalidOperationException("It was off.");
    }

    private struct WrongNumbers : IPolytopeTrace
    {
        public int Surfaces, Others;

        public readonly bool IsOn => true;

        public void OnStep(in PolytopeStep step)
        {
            if (step.FaceCount > 0) Surfaces++;
            else Others++;
            Assert.Equal(-1, step.NextFace(int.MaxValue));
            for (int i = -1; i < 2; i++)
            {
                int face = i < 0 ? -1 : i == 0 && step.FaceCount > 0 ? 4096 : int.MaxValue;
                int vertex = i < 0 ? -1 : step.VertexCount + i;
                Assert.Equal("face", Refused(step, face, isFace: true));
                Assert.Equal("index", Refused(step, vertex, isFace: false));
            }
        }

        private static string? Refused(in PolytopeStep step, int number, bool isFace)
        {
            try
            {
                _ = isFace ? step.Face(number).Height : step.Vertex(number).X;
                return null;
            }
            catch (ArgumentOutOfRangeException refusal)
            {
                return refusal.ParamName;
            }
        }
    }
}
