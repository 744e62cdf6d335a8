namespace Gjk.Bench.Table;

/// <summary>The goals for the library, and what the best of the other engines needs, in nanoseconds per pair on the
/// machine on which those were measured. On another machine the same factor over the baseline counts: a figure is
/// scaled by the baseline's time here, divided by its time there.</summary>
internal static class Goals
{
    /// <summary>The sets in the order of the figures below.</summary>
    private static readonly string[] Sets =
        ["cubes", "spheres", "box", "hull8", "hull32", "hull128", "hull512", "hull2048"];

    /// <summary>The baseline's cold distance on the goals' machine.</summary>
    private static readonly double[] Baseline = [507, 5443, 492, 567, 1270, 3799, 13557, 46706];

    private static readonly Dictionary<Query, double[]> Of = new()
    {
        [Query.Cold] = [105, 190, 150, 170, 265, 340, 440, 560],
        [Query.Warm] = [70, 85, 70, 75, 95, 100, 120, 150],
        [Query.Moving] = [80, 140, 100, 105, 150, 210, 280, 400],
        [Query.Boolean] = [12, 25, 70, 65, 115, 130, 150, 190],
        [Query.BatchCold] = [57, 120, 78, 125, 205, 255, 310, 420],
        [Query.BatchWarm] = [50, 65, 52, 60, 75, 85, 95, 120],
        [Query.BatchBoolean] = [12, 20, 45, 65, 100, 115, 130, 170],
    };

    /// <summary>The best engine of each set. Warm: nothing moved. The batches are of engines that fill the lanes of a
    /// register with pairs; only Bepu does. Bepu refuses flat hulls, and PhysX has no hulls of more than 255
    /// vertices.</summary>
    private static readonly Dictionary<Query, (string Engine, double Nanoseconds)[]> Best = new()
    {
        [Query.Cold] =
        [
            ("Jolt", 140), ("coal", 564), ("openGJK", 201), ("openGJK", 201), ("PhysX", 481), ("PhysX", 587),
            ("coal", 2837), ("coal", 5180),
        ],
        [Query.Warm] =
        [
            ("PhysX", 64), ("coal", 331), ("PhysX", 57), ("PhysX", 63), ("PhysX", 89), ("PhysX", 82), ("coal", 1893),
            ("coal", 2948),
        ],
        [Query.Boolean] =
        [
            ("Jolt", 29), ("Jitter2", 329), ("PhysX", 112), ("PhysX", 90), ("PhysX", 225), ("PhysX", 200),
            ("Jitter2", 1507), ("Jitter2", 2719),
        ],
        [Query.BatchCold] =
        [
            ("Bepu", 67), ("Bepu", 789), ("Bepu", 84), ("Bepu", double.NaN), ("Bepu", 442), ("Bepu", 803),
            ("Bepu", 2051), ("Bepu", 7444),
        ],
    };

    /// <summary>What is faster still where an engine has a shape for boxes; the column above is of hulls.</summary>
    private static readonly Dictionary<Query, (string Engine, double Nanoseconds)> BestOfBoxShapes = new()
    {
        [Query.Cold] = ("PhysX", 119),
        [Query.Boolean] = ("PhysX", 59),
    };

    /// <summary>Cold distance through the generic path. No baseline figure from that machine is known, so the machine
    /// is compared by the sets.</summary>
    private static readonly Dictionary<string, double> OfPrimitives = new()
    {
        ["sphere-sphere"] = 12,
        ["capsule-capsule"] = 45,
        ["box-box cubes"] = 85,
        ["box-box random"] = 105,
    };

    /// <summary>The goal of a query. Null if none was set.</summary>
    public static double? For(string set, Query query)
    {
        if (DepthGoals.Covers(query)) return DepthGoals.For(set, query);
        if (query == Query.Cast) return CastGoals.For(set);
        if (OfPrimitives.TryGetValue(set, out double primitive)) return primitive;
        int column = Column(set);
        return column >= 0 && Of.TryGetValue(query, out double[]? goals) ? goals[column] : null;
    }

    /// <summary>The best engine of a query, and its time. Null if none was measured.</summary>
    public static (string Engine, double Nanoseconds)? BestEngine(string set, Query query)
    {
        if (DepthGoals.Covers(query)) return DepthGoals.BestEngine(set, query);
        if (query == Query.Cast) return CastGoals.BestEngine(set);
        if (set == "box" && BestOfBoxShapes.TryGetValue(query, out (string, double) boxes)) return boxes;
        int column = Column(set);
        if (column < 0 || !Best.TryGetValue(query, out (string Engine, double Nanoseconds)[]? engines)) return null;
        return double.IsNaN(engines[column].Nanoseconds) ? null : engines[column];
    }

    /// <summary>How many times slower this machine is, by the baseline of one set. Null if there is no figure for the
    /// goals' machine.</summary>
    public static double? Slowness(string set, double baselineHere)
    {
        int column = Column(set);
        return column >= 0 ? baselineHere / Baseline[column] : null;
    }

    /// <summary>The geometric mean over the sets.</summary>
    public static double MeanSlowness(IEnumerable<double> slownesses) => Math.Exp(slownesses.Average(Math.Log));

    /// <summary>Boxes as meshes have the figures of boxes.</summary>
    private static int Column(string set) => Array.IndexOf(Sets, set == "box-mesh" ? "box" : set);
}
