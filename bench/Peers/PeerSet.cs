using Gjk.Bench.Benchmarks;
using Gjk.Bench.Table;

namespace Gjk.Bench.Peers;

/// <summary>What an engine needed for a set, and how many of its answers were wrong.</summary>
internal readonly record struct PeerFigure(double Nanoseconds, int Wrong);

/// <summary>One set of pairs and one question about them.</summary>
/// <param name="Name">The set's.</param>
/// <param name="Verb">The question.</param>
internal abstract record PeerSet(string Name, PeerVerb Verb)
{
    /// <summary>Ratio to the larger of size and distance. An engine is wrong if its distance or depth is further off,
    /// or its flag differs although the shapes are further apart, or deeper in each other, than that.</summary>
    private const double Tolerance = 1e-5;

    public abstract int PairCount { get; }

    /// <summary>The pairs in the form that the engines read.</summary>
    public abstract void Write(string file);

    /// <summary>The library's loop.</summary>
    public abstract TimedLoop Library();

    /// <summary>How many of an engine's answers differ from the library's, which are proved.</summary>
    public int Wrong(IReadOnlyList<(bool Overlap, double Value)> answers) =>
        Enumerable.Range(0, PairCount).Count(i => IsWrong(answers[i], Truth(i, out double size), size));

    /// <summary>All sets, in groups that have the same pairs.</summary>
    public static IEnumerable<Func<PeerSet[]>> All() => ConvexPeerSet.Groups().Concat(ConcavePeerSet.Groups());

    /// <summary>A pair's signed distance, and its size.</summary>
    protected abstract double Truth(int pair, out double size);

    private bool IsWrong((bool Overlap, double Value) answer, double signed, double size)
    {
        double most = Tolerance * Math.Max(size, Math.Abs(signed));
        if (answer.Overlap != signed <= 0 && Math.Abs(signed) > most) return true;
        if (Verb == PeerVerb.Boolean) return false;
        double truth = Verb == PeerVerb.Depth ? -signed : Math.Max(signed, 0);
        return !(Math.Abs(answer.Value - truth) <= most);
    }
}

/// <summary>Convex pairs: the report's scenes and random ones for distances and booleans, the depths' own.</summary>
internal sealed record ConvexPeerSet(string Name, PeerVerb Verb, BenchScene Scene) : PeerSet(Name, Verb)
{
    public override int PairCount => Scene.Pairs.Length;

    public override void Write(string file) => PairFile.Write(file, Scene);

    public override TimedLoop Library() => new(PairCount, Verb switch
    {
        PeerVerb.Distance => () => SceneQueries.Distance(Scene),
        PeerVerb.Boolean => () => SceneQueries.Overlaps(Scene),
        _ => () => SceneQueries.Depth(Scene),
    });

    public static IEnumerable<Func<PeerSet[]>> Groups()
    {
        foreach (string name in ReportScenes.Names) yield return () => Of(name, ReportScenes.Create(name));
        foreach (string name in RandomPairs.Names) yield return () => Of(name, RandomPairs.Create(name));
        foreach (string name in DepthPairs.Names)
            yield return () => [new ConvexPeerSet(name, PeerVerb.Depth, DepthPairs.Create(name))];
    }

    protected override double Truth(int pair, out double size)
    {
        BenchScene.Pair p = Scene.Pairs[pair];
        ref ConvexShape a = ref Scene.Shapes[p.A], b = ref Scene.Shapes[p.B];
        size = Math.Max(Motion.Size(a), Motion.Size(b));
        return ConvexQuery.SignedDistance(a, Scene.Poses[p.A], b, Scene.Poses[p.B]).Distance;
    }

    private static PeerSet[] Of(string name, BenchScene scene) =>
        [new ConvexPeerSet(name, PeerVerb.Distance, scene), new ConvexPeerSet(name, PeerVerb.Boolean, scene)];
}

/// <summary>Two shapes, one a surface at least, in several poses.</summary>
internal sealed record ConcavePeerSet(string Name, PeerVerb Verb, ConcaveScene Scene) : PeerSet(Name, Verb)
{
    public override int PairCount => Scene.Poses.Length;

    public override void Write(string file) => PairFile.Write(file, Scene);

    public override TimedLoop Library() =>
        new(PairCount, Verb == PeerVerb.Distance ? Scene.SumOfDistances : Scene.CountOfOverlaps);

    public static IEnumerable<Func<PeerSet[]>> Groups()
    {
        foreach (string name in ConcaveScene.Names)
        {
            yield return () =>
            {
                ConcaveScene scene = ConcaveScene.Create(name);
                return [new ConcavePeerSet(name, PeerVerb.Distance, scene),
                    new ConcavePeerSet(name, PeerVerb.Boolean, scene)];
            };
        }
    }

    protected override double Truth(int pair, out double size)
    {
        size = Scene.Size;
        return Scene.Distance(pair);
    }
}
