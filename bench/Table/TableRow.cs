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
internal sealed record TableRow(
    string Set, int Vertices, int Pairs, Query Query, double Library, double? Baseline)
{
    public double? Factor => Baseline / Library;
}
