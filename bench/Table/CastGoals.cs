namespace Gjk.Bench.Table;

/// <summary>The goals for casts, and what other engines need for them, in nanoseconds per pair, nothing kept between
/// the calls. They were measured on lists of the same description, not on the same pairs, and on a machine on which the
/// baseline's time is not known.</summary>
internal static class CastGoals
{
    /// <summary>How many casts the engines were judged on.</summary>
    public const int Judged = 5345;

    /// <summary>The sets in the order of the figures below.</summary>
    private static readonly string[] Sets =
        ["box", "h8", "h32", "graze", "slide", "inside", "miss", "speed", "ray", "round", "thin"];

    private static readonly double[] Goal = [300, 335, 740, 400, 200, 145, 70, 300, 22, 150, 500];

    /// <summary>With how many of the judged casts each has wrong by more than 1e-5 of the size.</summary>
    private static readonly (string Engine, double[] Nanoseconds, int Wrong)[] Engines =
    [
        ("Jolt, tight", [879, 996, 2503, 984, 515, 546, 158, 909, 325, 477, 1324], 14),
        ("Jolt", [875, 993, 2487, 835, 497, 522, 158, 869, 320, 449, 1200], 152),
        ("Box3D, tight", [620, 674, 1525, 954, 411, 336, 388, 918, 243, 382, 1075], 121),
        ("PhysX", [380, 774, 1573, 828, 252, 304, 173, 506, 61, 299, 783], 2353),
        ("Jitter2", [1247, 2165, 3620, 823, 733, 298, 558, 1226, 771, 2914, 3268], 889),
        ("Bepu", [3999, 11.5e3, 16.2e3, 5872, 1891, 1182, 135, 5261, 44, 1328, 8059], 2481),
        ("Bullet", [3780, 4800, 8267, 4641, 1688, 2902, 856, 3760, 2680, 1786, 6207], 949),
    ];

    public static IEnumerable<string> EngineNames => Engines.Select(e => e.Engine);

    /// <summary>An engine's time.</summary>
    public static double Of(string engine, string set) =>
        Engines.Single(e => e.Engine == engine).Nanoseconds[Array.IndexOf(Sets, set)];

    /// <summary>How many of the judged casts an engine has wrong.</summary>
    public static int WrongOf(string engine) => Engines.Single(e => e.Engine == engine).Wrong;

    public static double For(string set) => Goal[Array.IndexOf(Sets, set)];

    /// <summary>The engine that is fastest on a set, and its time.</summary>
    public static (string Engine, double Nanoseconds) BestEngine(string set)
    {
        string best = EngineNames.MinBy(e => Of(e, set))!;
        return (best, Of(best, set));
    }
}
