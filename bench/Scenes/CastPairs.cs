namespace Gjk.Bench.Scenes;

/// <summary>Sets of a thousand pairs of which one object moves, for the question when they meet. They are drawn after
/// the description of the lists on which other engines were measured; they are not the same pairs.</summary>
/// <remarks>
/// <list type="bullet">
/// <item>box, h8, h32: boxes, and hulls of that many corners, of about unit size, that meet after a way of up to 8.
/// </item>
/// <item>graze: hulls and boxes that pass each other with a gap of 1e-7 to 1e-3, or with an overlap of as much.</item>
/// <item>slide: equally turned boxes with faces in one plane, or nearly, that slide along it.</item>
/// <item>inside: pairs that overlap before they move.</item>
/// <item>miss: pairs that pass by at 0.05 to 1, stop short, or go away.</item>
/// <item>speed: ways of 1e-5 to 1e6.</item>
/// <item>ray: a point against a box, a hull, a sphere, a capsule, or a cylinder, asked as a ray.</item>
/// <item>round: spheres and capsules with each other, with boxes and with hulls.</item>
/// <item>thin: plates and rods of 1:1000 to 1:10,000, with each other and with small bodies.</item>
/// </list>
/// </remarks>
public static class CastPairs
{
    /// <summary>Pairs in every set, as many as in the sets for distances.</summary>
    public const int Count = RandomPairs.Count;

    private const string Ray = "ray";

    /// <summary>The name of the set, the corners of its objects if they have equally many, the seed, the least and the
    /// most share of pairs that meet, overlaps at the start included, and what draws the pairs.</summary>
    private static readonly
        (string Name, int Vertices, ulong Seed, double Least, double Most, Func<Prng, Action<CastScene>> Begin)[] Sets =
        [
            ("box", 8, 71, 1, 1, CastSets.Boxes),
            ("h8", 8, 72, 1, 1, prng => CastSets.Hulls(prng, 8)),
            ("h32", 32, 73, 1, 1, prng => CastSets.Hulls(prng, 32)),
            ("graze", 0, 74, 0.4, 0.6, CastSets.Grazes),
            ("slide", 8, 75, 0.3, 0.8, CastSets.Slides),
            ("inside", 0, 76, 1, 1, CastSets.Insides),
            ("miss", 0, 77, 0, 0, CastSets.Misses),
            ("speed", 0, 78, 0.98, 1, CastSets.Speeds),
            (Ray, 0, 79, 0.5, 0.8, CastSets.Rays),
            ("round", 0, 80, 1, 1, CastSets.Rounds),
            ("thin", 0, 81, 1, 1, CastSets.Thins),
        ];

    public static IReadOnlyList<string> Names { get; } = [.. Sets.Select(s => s.Name)];

    /// <summary>How many corners an object of the set has. 0 if the set has different ones.</summary>
    public static int VerticesOf(string name) => Sets.Single(s => s.Name == name).Vertices;

    /// <exception cref="FactorCheckException">An answer is wrong, or too many or too few pairs meet.</exception>
    public static CastScene Create(string name)
    {
        (string Name, int Vertices, ulong Seed, double Least, double Most, Func<Prng, Action<CastScene>> Begin) set =
            Sets.Single(s => s.Name == name);
        Action<CastScene> addPair = set.Begin(new Prng(set.Seed));
        var scene = new CastScene(name == Ray);
        for (int i = 0; i < Count; i++) addPair(scene);
        scene.Build();
        CastCheck.Run(name, scene, set.Least, set.Most);
        return scene;
    }
}
