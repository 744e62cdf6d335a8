namespace Gjk.Bench.Table;

/// <summary>One figure beside its baseline, in nanoseconds per pair.</summary>
/// <param name="Set">The set's name.</param>
/// <param name="Vertices">Per object, as the baseline scans them; 0 for the library's own primitives.</param>
/// <param name="Pairs">In the list.</param>
/// <param name="Query">What was asked.</param>
/// <param name="Library">The library's time.</param>
/// <param name="Baseline">The baseline's: its boolean for a boolean, its cold distance for all else, as it knows no warm start.</param>
/// <param name="Goal">On the goals' machine; null where none was set.</param>
/// <param name="GoalHere">The goal scaled to this machine.</param>
internal sealed record TableRow(string Set, int Vertices, int Pairs, Query Query, double Library, double Baseline, double? Goal, double? GoalHere)
{
    public double Factor => Baseline / Library;

    public bool? Met => GoalHere is double goal ? Library <= goal : null;
}
