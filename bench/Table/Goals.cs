using System;
using System.Collections.Generic;
using System.Linq;
using SetGoals = (double Baseline, double Cold, double Warm, double Moving, double Boolean);

namespace Gjk.Bench.Table;

/// <summary>
/// The goals for the library, in nanoseconds per pair on the machine on which the other engines were measured. They are
/// about half the time of the best engine. On another machine the same factor over the baseline counts. So a goal is
/// scaled by the baseline's time here, divided by its time there.
/// </summary>
internal static class Goals
{
    /// <summary>The set, the baseline's cold distance on the goals' machine, and the goals there.</summary>
    private static readonly Dictionary<string, SetGoals> Of = new()
    {
        ["cubes"] = (507, 90, 40, 70, 25),
        ["spheres"] = (5443, 300, 60, 110, 120),
        ["box"] = (492, 125, 40, 80, 70),
        ["box-mesh"] = (492, 125, 40, 80, 70),
        ["hull8"] = (567, 125, 40, 75, 60),
        ["hull32"] = (1270, 220, 45, 95, 100),
        ["hull128"] = (3799, 350, 50, 120, 120),
        ["hull512"] = (13557, 1100, 60, 150, 350),
        ["hull2048"] = (46706, 1600, 80, 180, 600),
    };

    /// <summary>
    /// Cold distance through the generic path. No baseline figure from that machine is known, so the machine is
    /// compared by the sets.
    /// </summary>
    private static readonly Dictionary<string, double> OfPrimitives = new()
    {
        ["sphere-sphere"] = 12,
        ["capsule-capsule"] = 40,
        ["box-box cubes"] = 60,
        ["box-box random"] = 80,
    };

    /// <summary>The goal of a query. Null if none was set.</summary>
    public static double? For(string set, Query query)
    {
        if (OfPrimitives.TryGetValue(set, out double primitive)) return primitive;
        if (!Of.TryGetValue(set, out SetGoals goals)) return null;
        return query switch
        {
            Query.Cold => goals.Cold,
            Query.Warm => goals.Warm,
            Query.Moving => goals.Moving,
            Query.Boolean => goals.Boolean,
            _ => throw new ArgumentOutOfRangeException(nameof(query)),
        };
    }

    /// <summary>
    /// How many times slower this machine is, by the baseline of one set. Null if there is no figure for the goals'
    /// machine.
    /// </summary>
    public static double? Slowness(string set, double baselineHere) =>
        Of.TryGetValue(set, out SetGoals goals) ? baselineHere / goals.Baseline : null;

    /// <summary>The geometric mean over the sets.</summary>
    public static double MeanSlowness(IEnumerable<double> slownesses) => Math.Exp(slownesses.Average(Math.Log));
}
