using Gjk.Bench.Benchmarks;

namespace Gjk.Bench.Table;

/// <summary>The loops of one set of pairs.</summary>
internal sealed class TableSet
{
    /// <summary>The most gap of a contact point, as a share of the smaller object's size: as much as one moves between
    /// two calls where the sets move.</summary>
    private const float MostGapShare = 0.01f;

    private readonly TimedLoop? _baseline;
    private readonly TimedLoop? _baselineBoolean;
    private readonly List<(Query Query, Func<double> Nanoseconds)> _library = [];
    private readonly List<TimedLoop> _loops;
    private readonly int _vertices;
    private readonly int _pairs;

    private TableSet(string name, int vertices, int pairs, TimedLoop? baseline, TimedLoop? baselineBoolean = null)
    {
        Name = name;
        _vertices = vertices;
        _pairs = pairs;
        _baseline = baseline;
        _baselineBoolean = baselineBoolean;
        _loops = [.. new[] { baseline, baselineBoolean }.OfType<TimedLoop>()];
    }

    public string Name { get; }

    public IReadOnlyCollection<TimedLoop> Loops => _loops;

    public static TableSet OfReportScene(string name)
    {
        BenchScene scene = ReportScenes.Create(name);
        return OfScene(name, name == ReportScenes.Cubes ? 24 : 515, scene, scene);
    }

    public static TableSet OfRandomPairs(string name)
    {
        BenchScene scene = RandomPairs.Create(name);
        return OfScene(name, RandomPairs.VerticesOf(name), scene, scene);
    }

    /// <summary>A set on which the baseline is slow. The baseline gets only the first pairs.</summary>
    public static TableSet OfLargePairs(string name)
    {
        BenchScene scene = RandomPairs.Create(name);
        return OfScene(name, RandomPairs.VerticesOf(name), scene, scene.WithFirstPairs(RandomPairs.LargeBaselinePairs));
    }

    /// <summary>The primitives through the generic path, without warm starts.</summary>
    public static IEnumerable<TableSet> OfPrimitives()
    {
        var pairs = new PrimitivePairs();
        yield return OfTyped("sphere-sphere", pairs.Spheres);
        yield return OfTyped("capsule-capsule", pairs.Capsules);
        yield return OfTyped("box-box cubes", pairs.Cubes);
        yield return OfTyped("box-box random", pairs.Boxes);
        yield return OfTyped("triangle-triangle", pairs.Triangles);
    }

    /// <summary>Overlapping pairs. The baseline does not know how deep they are.</summary>
    public static TableSet OfDepthPairs(string name)
    {
        BenchScene scene = DepthPairs.Create(name);
        int pairs = scene.Pairs.Length;
        var set = new TableSet(name, DepthPairs.VerticesOf(name), pairs, baseline: null);
        var sliding = new Sliding(scene);
        var warmStarts = new WarmStart[pairs];
        var depth = new TimedLoop(pairs, () => SceneQueries.Depth(scene));
        set.Add(Query.Depth, depth);
        set.Add(
            Query.DepthMoving, new TimedLoop(pairs, () => SceneQueries.WarmDepth(scene, sliding.Next(), warmStarts)));
        float[] mostGaps = [.. scene.Pairs.Select(p => MostGap(scene.Shapes[p.A], scene.Shapes[p.B]))];
        var contacts = new TimedLoop(pairs, () => SceneQueries.Contacts(scene, mostGaps));
        set.AddOnTop(Query.ContactsOnTop, depth, contacts);
        return set;
    }

    /// <summary>Pairs that move. The baseline does not know when they meet.</summary>
    public static TableSet OfCastPairs(string name)
    {
        CastScene scene = CastPairs.Create(name);
        int pairs = scene.Pairs.Length;
        var set = new TableSet(name, CastPairs.VerticesOf(name), pairs, baseline: null);
        set.Add(Query.Cast, new TimedLoop(pairs, () => scene.SumOfFractions()));
        return set;
    }

    public IEnumerable<TableRow> Rows()
    {
        foreach ((Query query, Func<double> nanoseconds) in _library)
        {
            bool isBoolean = query is Query.Boolean or Query.BatchBoolean && _baselineBoolean is not null;
            TimedLoop? baseline = isBoolean ? _baselineBoolean : _baseline;
            yield return new TableRow(Name, _vertices, _pairs, query, nanoseconds(), baseline?.Nanoseconds);
        }
    }

    private static TableSet OfScene(string name, int vertices, BenchScene scene, BenchScene forBaseline)
    {
        int pairs = scene.Pairs.Length, baselinePairs = forBaseline.Pairs.Length;
        var baseline = new TimedLoop(baselinePairs, () => SceneQueries.BaselineDistance(forBaseline));
        var baselineBoolean = new TimedLoop(baselinePairs, () => SceneQueries.BaselineOverlaps(forBaseline));
        var set = new TableSet(name, vertices, pairs, baseline, baselineBoolean);
        WarmStart[] resting = new WarmStart[pairs], moving = new WarmStart[pairs];
        var motion = new Motion(scene);
        set.Add(Query.Cold, new TimedLoop(pairs, () => SceneQueries.Distance(scene)));
        set.Add(Query.Warm, new TimedLoop(pairs, () => SceneQueries.WarmDistance(scene, scene.Poses, resting)));
        set.Add(Query.Moving, new TimedLoop(pairs * Motion.FramesPerRound, () => Round(scene, motion, moving)));
        set.Add(Query.Boolean, new TimedLoop(pairs, () => SceneQueries.Overlaps(scene)));
        ObjectPair[] list = [.. scene.Pairs.Select(p => new ObjectPair(p.A, p.B))];
        var distances = new DistanceResult[pairs];
        var statuses = new GjkStatus[pairs];
        set.Add(Query.BatchCold, new TimedLoop(pairs, () => SceneQueries.BatchDistance(scene, list, distances)));
        var batchStarts = new WarmStart[pairs];
        set.Add(
            Query.BatchWarm, new TimedLoop(pairs, () => SceneQueries.BatchWarm(scene, list, distances, batchStarts)));
        set.Add(Query.BatchBoolean, new TimedLoop(pairs, () => SceneQueries.BatchOverlaps(scene, list, statuses)));
        return set;
    }

    private static TableSet OfTyped<TShape>(string name, TypedPairs<TShape> pairs)
        where TShape : struct, ISupportMap
    {
        var set = new TableSet(name, 0, RandomPairs.Count, new TimedLoop(RandomPairs.Count, pairs.BaselineDistance));
        set.Add(Query.Cold, new TimedLoop(RandomPairs.Count, pairs.Distance));
        return set;
    }

    private static float MostGap(in ConvexShape a, in ConvexShape b) =>
        (float)(MostGapShare * Math.Min(Motion.Size(a), Motion.Size(b)));

    /// <summary>Runs all frames forward and back, so that every sample does the same work.</summary>
    private static float Round(BenchScene scene, Motion motion, WarmStart[] warmStarts)
    {
        float sum = 0;
        for (int i = 0; i < Motion.FramesPerRound; i++)
            sum += SceneQueries.WarmDistance(scene, motion.Next(), warmStarts);
        return sum;
    }

    private void Add(Query query, TimedLoop loop)
    {
        _library.Add((query, () => loop.Nanoseconds));
        _loops.Add(loop);
    }

    /// <summary>Adds a query that does more than another one. Its row is the difference.</summary>
    private void AddOnTop(Query query, TimedLoop below, TimedLoop loop)
    {
        _library.Add((query, () => loop.Nanoseconds - below.Nanoseconds));
        _loops.Add(loop);
    }
}
