using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Gjk.Bench.Scenes;

namespace Gjk.Bench.Table;

/// <summary>
/// Every figure of the table in one process: library and baseline in turn, so that their factor is worth more than either figure. All sets are built and
/// visited once before any is measured, so that the code that the runtime optimises has seen all of them, as in a program that knows more than one shape.
/// </summary>
internal static class TableRun
{
    /// <summary>Seconds to measure a set; the default run stays under three minutes on a machine of two cores.</summary>
    public const double DefaultSeconds = 6;

    /// <summary>Seconds to warm up, at most: for all sets together, and for each again.</summary>
    private const double CommonWarmUpSeconds = 8, WarmUpSeconds = 2;

    /// <summary>The share of a set's seconds for those with two loops in place of six, and for the large hulls, whose slow loops give few samples anyway.</summary>
    private const double PrimitiveShare = 1.0 / 3, LargeShare = 0.5;

    /// <param name="progress">Gets a line per set.</param>
    /// <param name="seconds">To measure a set.</param>
    /// <param name="meanSlowness">How many times slower than the goals' machine this one is.</param>
    public static List<TableRow> Run(TextWriter progress, double seconds, out double meanSlowness)
    {
        progress.WriteLine("building the sets");
        TableSet[] scenes = [.. ReportScenes.Names.Select(TableSet.OfReportScene), .. RandomPairs.Names.Select(TableSet.OfRandomPairs)];
        TableSet[] primitives = [.. TableSet.OfPrimitives()];
        TableSet[] large = [.. RandomPairs.LargeNames.Select(TableSet.OfLargePairs)];

        progress.WriteLine("warming up");
        TurnTaking.WarmUp([.. scenes.Concat(primitives).SelectMany(s => s.Loops)], Math.Min(CommonWarmUpSeconds, seconds * scenes.Length));
        Measure(progress, scenes, seconds);
        Measure(progress, primitives, seconds * PrimitiveShare);
        Measure(progress, large, seconds * LargeShare);

        double mean = Goals.MeanSlowness(scenes.Select(s => s.Slowness).OfType<double>());
        meanSlowness = mean;
        return [.. scenes.Concat(primitives).Concat(large).SelectMany(s => s.Rows(mean))];
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
