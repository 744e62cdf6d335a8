namespace Gjk.Bench.Scenes;

/// <summary>Sets of a thousand overlapping pairs, for the question how deep they are. They are drawn after the
/// description of the lists on which other engines were measured; they are not the same pairs.</summary>
/// <remarks>
/// <list type="bullet">
/// <item>box shallow: boxes 1e-6 to 1e-2 deep, by a corner in a face, edge across edge, or corner to corner.</item>
/// <item>box deep: boxes with the middle of one inside the other.</item>
/// <item>flush: boxes face to face, 1e-5 to 0.1 deep: centred, shifted, sides in one plane, at edges or corners.</item>
/// <item>hull8, hull32, hull128, hull512: hulls of that many corners. A third is shallow, a third deeper, and of a
/// third the middle of one is near the middle of the other.</item>
/// <item>needle: rods, plates and spikes of 1:1000 to 1:10,000, with each other and with a cube and a hull.</item>
/// <item>nested: a box or hull inside another that is 2 to 1000 times larger.</item>
/// <item>concentric: two copies of one shape about one centre: in the same place, turned, or off by 1e-7 to 0.1.</item>
/// <item>ratio: a body of size 1 at one of size 1e3 or 1e4.</item>
/// <item>far: bodies of size 1 at 1e5 from the origin.</item>
/// <item>round: spheres and capsules with each other, with boxes and with hulls. A third is shallow, in a third the
/// margins overlap, in a sixth the cores too, and a sixth is deep.</item>
/// </list>
/// </remarks>
public static class DepthPairs
{
    /// <summary>Pairs in every set, as many as in the sets for distances.</summary>
    public const int Count = RandomPairs.Count;

    private const string Flush = "flush";

    /// <summary>The name of the set, the corners of its objects if they have equally many, the seed, and what draws the
    /// pairs.</summary>
    private static readonly (string Name, int Vertices, ulong Seed, Func<Prng, Action<BenchScene>> Begin)[] Sets =
    [
        ("box shallow", 8, 51, DepthSets.ShallowBoxes),
        ("box deep", 8, 52, DepthSets.DeepBoxes),
        (Flush, 8, 53, DepthSets.FlushBoxes),
        ("hull8", 8, 54, prng => DepthSets.Hulls(prng, 8)),
        ("hull32", 32, 55, prng => DepthSets.Hulls(prng, 32)),
        ("hull128", 128, 56, prng => DepthSets.Hulls(prng, 128)),
        ("hull512", 512, 57, prng => DepthSets.Hulls(prng, 512)),
        ("needle", 0, 58, DepthSets.Needles),
        ("nested", 0, 59, DepthSets.Nested),
        ("concentric", 0, 60, DepthSets.Concentric),
        ("ratio", 0, 61, DepthSets.Ratio),
        ("far", 0, 62, DepthSets.Far),
        ("round", 0, 63, DepthSets.Round),
    ];

    public static IReadOnlyList<string> Names { get; } = [.. Sets.Select(s => s.Name)];

    /// <summary>The sets of boxes and hulls that have equally many corners and no flush faces.</summary>
    public static IReadOnlyList<string> EvenNames { get; } =
        [.. Sets.Where(s => s.Vertices > 0 && s.Name != Flush).Select(s => s.Name)];

    /// <summary>How many corners an object of the set has. 0 if the set has different ones.</summary>
    public static int VerticesOf(string name) => Sets.Single(s => s.Name == name).Vertices;

    /// <exception cref="FactorCheckException">A pair does not overlap, or its depth is not proved.</exception>
    public static BenchScene Create(string name)
    {
        (string Name, int Vertices, ulong Seed, Func<Prng, Action<BenchScene>> Begin) set =
            Sets.Single(s => s.Name == name);
        Action<BenchScene> addPair = set.Begin(new Prng(set.Seed));
        var scene = new BenchScene();
        for (int i = 0; i < Count; i++) addPair(scene);
        scene.Build();
        DepthCheck.Run(name, scene);
        return scene;
    }
}
