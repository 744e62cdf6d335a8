using Gjk.Bench.Baseline;

namespace Gjk.Bench.Scenes;

/// <summary>Sets of a thousand pairs each, in random orientations, with their centres 0.2 to 1.6 apart. The sizes are
/// chosen so that 20 to 40 % of the pairs overlap. A set with only one answer would measure half of the
/// algorithm.</summary>
public static class RandomPairs
{
    /// <summary>Pairs in every set. They are few enough to be visited often, and too many for a branch predictor to
    /// learn.</summary>
    public const int Count = 1000;

    /// <summary>Vertices. The largest hull of <see cref="Names"/>.</summary>
    private const int LargestUsual = 2048;

    /// <summary>How many pairs of a large set the baseline is measured on.</summary>
    public const int LargeBaselinePairs = 100;

    private const float MinDistance = 0.2f;
    private const float MaxDistance = 1.6f;
    private const double MinOverlapRate = 0.2;
    private const double MaxOverlapRate = 0.4;

    /// <summary>How many different hulls a set draws from. From 512 vertices on, they are together larger than a
    /// first-level cache, as in a game level. A separate hull for each of the 2000 objects would measure the memory
    /// instead.</summary>
    private const int HullPool = 64;

    /// <summary>The total number of vertices of the hulls that a large set draws from, and the least number of hulls.
    /// The total is twice that of the largest usual set, so that the caches do not hold a larger part of it. More
    /// vertices would take long to build.</summary>
    private const int LargePoolVertices = 2 * HullPool * LargestUsual, LeastHulls = 4;

    /// <summary>The name of the set, its vertices (0 means boxes), the mean radius or half extent, and the
    /// seed.</summary>
    private static readonly (string Name, int Vertices, float Size, ulong Seed)[] Sets =
    [
        ("box", 0, 0.24f, 11),
        ("box-mesh", 0, 0.24f, 11),
        ("hull8", 8, 0.45f, 12),
        ("hull32", 32, 0.36f, 13),
        ("hull128", 128, 0.33f, 14),
        ("hull512", 512, 0.32f, 15),
        ("hull2048", 2048, 0.32f, 16),
        ("hull8192", 8192, 0.32f, 17),
        ("hull32768", 32768, 0.32f, 18),
        ("hull100000", 100_000, 0.32f, 19),
    ];

    /// <summary>The usual sets.</summary>
    public static IReadOnlyList<string> Names { get; } = [.. Sets.Where(s => !IsLarge(s.Vertices)).Select(s => s.Name)];

    /// <summary>The sets of larger hulls, smallest first. The baseline takes seconds for the list of one of
    /// them.</summary>
    public static IReadOnlyList<string> LargeNames { get; } =
        [.. Sets.Where(s => IsLarge(s.Vertices)).Select(s => s.Name)];

    /// <summary>How many corners an object of the set has.</summary>
    public static int VerticesOf(string name) => Math.Max(Sets.Single(s => s.Name == name).Vertices, 8);

    public static BenchScene Create(string name)
    {
        (string Name, int Vertices, float Size, ulong Seed) set = Sets.Single(s => s.Name == name);
        var prng = new Prng(set.Seed);
        var scene = new BenchScene();
        (Vector3[] Vertices, ConvexShape Shape)[] pool = set.Vertices == 0 ? [] : HullsOf(prng, set.Vertices, set.Size);
        for (int i = 0; i < Count; i++)
        {
            int a = AddObject(scene, prng, set.Name, set.Size, pool, Vector3.Zero);
            Vector3 position = prng.UnitVector() * prng.Range(MinDistance, MaxDistance);
            int b = AddObject(scene, prng, set.Name, set.Size, pool, position);
            scene.AddPair(a, b);
        }

        return CheckOverlapRate(name, scene.Build(), IsLarge(set.Vertices) ? LargeBaselinePairs : Count);
    }

    /// <summary>The share of pairs that overlap, computed by the baseline. This check must not depend on the code that
    /// is measured.</summary>
    public static double OverlapRate(BenchScene scene) =>
        scene.Pairs.Count(p => ReportGjk.Intersects(scene.Colliders[p.A], scene.Colliders[p.B]))
            / (double)scene.Pairs.Length;

    private static bool IsLarge(int vertices) => vertices > LargestUsual;

    private static int AddObject(
        BenchScene scene, Prng prng, string name, float size, (Vector3[] Vertices, ConvexShape Shape)[] pool,
        Vector3 position)
    {
        var pose = new RigidPose(prng.Rotation(), position);
        if (pool.Length > 0)
        {
            (Vector3[] vertices, ConvexShape shape) = pool[prng.Index(pool.Length)];
            return scene.Add(shape, vertices, pose);
        }

        Vector3 half = RandomRadii(prng, size);
        Vector3[] corners = MeshVertices.Box(half);
        return scene.Add(name == "box" ? ConvexShape.Box(half) : ConvexShape.Mesh(corners), corners, pose);
    }

    private static (Vector3[] Vertices, ConvexShape Shape)[] HullsOf(Prng prng, int count, float size)
    {
        int hulls = IsLarge(count) ? Math.Max(LeastHulls, LargePoolVertices / count) : HullPool;
        var pool = new (Vector3[] Vertices, ConvexShape Shape)[hulls];
        for (int i = 0; i < pool.Length; i++)
        {
            Vector3[] vertices = MeshVertices.OnEllipsoid(prng, count, RandomRadii(prng, size));
            pool[i] = (vertices, ConvexShape.Mesh(vertices));
        }

        return pool;
    }

    private static Vector3 RandomRadii(Prng prng, float mean) =>
        new(prng.Range(0.5f, 1.5f) * mean, prng.Range(0.5f, 1.5f) * mean, prng.Range(0.5f, 1.5f) * mean);

    private static BenchScene CheckOverlapRate(string name, BenchScene scene, int pairs)
    {
        double rate = OverlapRate(scene.WithFirstPairs(pairs));
        return rate is >= MinOverlapRate and <= MaxOverlapRate
            ? scene
            : throw new InvalidOperationException(
                FormattableString.Invariant(
                    $"Set {name}: {rate:P1} of the pairs overlap, but 20 to 40 % should. Change its size."));
    }
}
