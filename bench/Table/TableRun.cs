namespace Gjk.Bench.Table;

/// <summary>Measures every figure of the table in one process. Library and baseline run in turn, so that their factor
/// is more reliable than either figure. All sets are built and visited once before any of them is measured. The runtime
/// then optimises the code for all of them, as in a program that uses more than one shape.</summary>
internal static class TableRun
{
    /// <summary>How many seconds a set is measured. With this value a run takes less than three minutes on a machine of
    /// two cores.</summary>
    public const double DefaultSeconds = 6;

    /// <summary>The most seconds of warm-up, for all sets together and then for each set.</summary>
    private const double CommonWarmUpSeconds = 8, WarmUpSeconds = 2;

    /// <summary>The share of a set's seconds for sets with two loops instead of six, and for the large hulls. The loops
    /// of the large hulls are slow and give few samples anyway.</summary>
    private const double PrimitiveShare = 1.0 / 3, LargeShare = 0.5;

    /// <summary>The share of a set's seconds for depths. Each set has three loops, and its warm-up is short, because
    /// all depths run the same code.</summary>
    private const double DepthShare = 0.3;

    /// <summary>The share of a set's seconds for casts, of which each set has one loop.</summary>
    private const double CastShare = 0.15;

    /// <param name="progress">Receives a line per set.</param>
    /// <param name="seconds">How many seconds to measure a set.</param>
    public static List<TableRow> Run(TextWriter progress, double seconds)
    {
        progress.WriteLine("building the sets");
        TableSet[] scenes =
        [
            .. ReportScenes.Names.Select(TableSet.OfReportScene), .. RandomPairs.Names.Select(TableSet.OfRandomPairs),
        ];
        TableSet[] primitives = [.. TableSet.OfPrimitives()];
        TableSet[] large = [.. RandomPairs.LargeNames.Select(TableSet.OfLargePairs)];

        TableSet[] depths = [.. DepthPairs.Names.Select(TableSet.OfDepthPairs)];

        TableSet[] casts = [.. CastPairs.Names.Select(TableSet.OfCastPairs)];

        progress.WriteLine("warming up");
        double commonSeconds = Math.Min(CommonWarmUpSeconds, seconds * scenes.Length);
        TurnTaking.WarmUp(
            [.. scenes.Concat(primitives).Concat(depths).Concat(casts).SelectMany(s => s.Loops)], commonSeconds);
        Measure(progress, scenes, seconds);
        Measure(progress, primitives, seconds * PrimitiveShare);
        Measure(progress, large, seconds * LargeShare);
        Measure(progress, depths, seconds * DepthShare);
        Measure(progress, casts, seconds * CastShare);

        TableSet[] all = [.. scenes, .. primitives, .. large, .. depths, .. casts];
        return [.. all.SelectMany(s => s.Rows())];
    }

    private static void Measure(TextWriter progress, TableSet[] sets, double seconds)
    {
        foreach (TableSet set in sets)
        {
            progress.WriteLine(set.Name);
            TurnTaking.WarmUp(set.Loops, Math.Min(WarmUpSeconds, seconds));
            TurnTaking.Measure(set.Loops, seconds);
        }
    }
}
