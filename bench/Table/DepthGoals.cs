namespace Gjk.Bench.Table;

/// <summary>The goals for depths and contacts, and what other engines need for depths, in nanoseconds per pair, nothing
/// kept between the calls. They were measured on lists of the same description, not on the same pairs, and on a machine
/// on which the baseline's time is not known.</summary>
internal static class DepthGoals
{
    private const double None = double.NaN;

    /// <summary>The sets in the order of the figures below.</summary>
    private static readonly string[] Sets =
    [
        "box shallow", "box deep", "flush", "hull8", "hull32", "hull128", "hull512", "needle", "nested", "concentric",
        "ratio", "far", "round",
    ];

    private static readonly double[] Goal = [105, 105, 80, 550, 1550, 4000, 9500, 500, 720, 1150, 400, 620, 115];

    /// <summary>What contact points may take on top of a cold depth.</summary>
    private static readonly Dictionary<string, double> OnTop = new()
    {
        ["box shallow"] = 120,
        ["box deep"] = 120,
        ["flush"] = 120,
        ["hull32"] = 250,
    };

    /// <summary>PhysX has no hulls of more than 255 vertices. Box3D was not measured on the larger hulls.</summary>
    private static readonly (string Engine, double[] Nanoseconds)[] Engines =
    [
        ("PhysX", [209, 209, 165, 5766, 234e3, 2.4e6, None, 3698, 22e3, 73e3, 2526, 4412, 798]),
        ("Box3D", [781, 886, 614, 1127, 11.2e3, None, None, 1426, 1574, 1988, 1356, 2521, 232]),
        ("Bullet", [734, 1916, 584, 1091, 3130, 8080, 26.3e3, 1001, 1530, 2297, 802, 1244, 6737]),
        ("MuJoCo", [787, 1993, 585, 1140, 3509, 8461, 30.0e3, 1070, 1437, 1082, 1022, 1384, 2397]),
        ("Jolt", [1776, 2815, 635, 2446, 5950, 13.1e3, 35.1e3, 2432, 2881, 3877, 3101, 2239, 4087]),
        ("Jitter2", [1851, 4094, 839, 3304, 7672, 14.3e3, 30.0e3, 3026, 4517, 4988, 2658, 3561, 15.6e3]),
        ("coal", [2632, 5476, 2474, 3515, 7779, 13.0e3, 20.7e3, 3477, 5100, 6204, 3175, 3731, 1069]),
        ("libccd", [2103, 7510, 1114, 3732, 10.3e3, 17.5e3, 51.9e3, 3272, 6303, 9428, 2526, 4471, 662e3]),
    ];

    /// <summary>True for the queries that have their goals here.</summary>
    public static bool Covers(Query query) => query is Query.Depth or Query.DepthMoving or Query.ContactsOnTop;

    public static IEnumerable<string> EngineNames => Engines.Select(e => e.Engine);

    /// <summary>An engine's time where it was measured. Null if it was not.</summary>
    public static double? Of(string engine, string set)
    {
        double time = Engines.Single(e => e.Engine == engine).Nanoseconds[Array.IndexOf(Sets, set)];
        return double.IsNaN(time) ? null : time;
    }

    /// <summary>The goal of a cold depth, or of contacts on top of one. None is set for warm ones.</summary>
    public static double? For(string set, Query query) => query switch
    {
        Query.Depth => Goal[Array.IndexOf(Sets, set)],
        Query.ContactsOnTop when OnTop.TryGetValue(set, out double goal) => goal,
        _ => null,
    };

    /// <summary>The engine that is fastest on a set, and its time. No engine was measured warm, nor for contacts
    /// alone.</summary>
    public static (string Engine, double Nanoseconds)? BestEngine(string set, Query query)
    {
        if (query != Query.Depth) return null;
        string best = EngineNames.Where(e => Of(e, set) is not null).MinBy(e => Of(e, set))!;
        return (best, Of(best, set)!.Value);
    }
}
