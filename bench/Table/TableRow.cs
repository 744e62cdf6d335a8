namespace Gjk.Bench.Table;

/// <summary>One figure and its baseline, in nanoseconds per pair.</summary>
/// <param name="Set">The set's name.</param>
/// <param name="Vertices">Per object, as the baseline scans them. 0 for the library's own primitives, and where objects
/// differ.</param>
/// <param name="Pairs">The number of pairs in the list.</param>
/// <param name="Query">The query that is measured.</param>
/// <param name="Library">The time of the library. For <see cref="Query.ContactsOnTop"/> it is a difference.</param>
/// <param name="Baseline">The time of the baseline. This is its boolean query for a boolean, and its cold distance for
/// everything else, because it has no warm start. Null for depths, contacts and casts, which it does not
/// answer.</param>
/// <param name="Goal">The goal on the goals' machine. Null if none was set.</param>
/// <param name="Best">The best other engine and its time on that machine. Null if none was measured.</param>
/// <param name="Slowness">How many times slower this machine is than that one.</param>
internal sealed record TableRow(
    string Set, int Vertices, int Pairs, Query Query, double Library, double? Baseline, double? Goal,
    (string Engine, double Nanoseconds)? Best, double Slowness)
{
    public double? Factor => Baseline / Library;

    /// <summary>The goal scaled to this machine.</summary>
    public double? GoalHere => Goal * Slowness;

    /// <summary>The best engine's time scaled to this machine.</summary>
    public double? BestHere => Best?.Nanoseconds * Slowness;

    /// <summary>The faster one, where an engine was measured.</summary>
    public string? Winner => BestHere is not double best ? null : Library < best ? "Gjk" : Best!.Value.Engine;

    /// <summary>Null without a goal, and for a difference of two times that is lost in their noise.</summary>
    public bool? Met => GoalHere is double goal && Library > 0 ? Library <= goal : null;
}
