using System.Text;

namespace Gjk.Bench.Table;

/// <summary>The rows of depths as two tables with a column per set: here, and as other engines were measured.</summary>
internal static class DepthReport
{
    /// <summary>True for rows that have their place here.</summary>
    public static bool Covers(TableRow row) => DepthGoals.Covers(row.Query);

    /// <param name="text">Where to append the tables.</param>
    /// <param name="rows">All rows. Others are left out.</param>
    /// <param name="slowness">How many times slower this machine is than the goals' machine.</param>
    public static void Append(StringBuilder text, IEnumerable<TableRow> rows, double slowness)
    {
        TableRow[] all = [.. rows.Where(Covers)];
        TableRow[] cold = [.. all.Where(r => r.Query == Query.Depth)];
        TableRow[] contacts = [.. all.Where(r => r.Query == Query.ContactsOnTop)];
        if (cold.Length == 0) return;

        SetColumns.Header(text, "depth here, ns per pair", cold);
        SetColumns.Line(text, "Gjk, cold", cold, r => SetColumns.Time(r.Library));
        SetColumns.Line(
            text, "Gjk, warm, moving", all.Where(r => r.Query == Query.DepthMoving), r => SetColumns.Time(r.Library));
        SetColumns.Line(
            text, "the best engine, cold, scaled", cold, r => $"{r.Best?.Engine} {SetColumns.Time(r.BestHere)}");
        SetColumns.Line(text, "wins, cold", cold, r => r.Winner ?? "");
        SetColumns.Line(text, "goal, cold, scaled", cold, r => SetColumns.Time(r.GoalHere));
        SetColumns.Line(text, "contacts, cold, on top", contacts, r => SetColumns.Time(r.Library));
        SetColumns.Line(text, "goal, contacts, scaled", contacts, r => SetColumns.Time(r.GoalHere));

        SetColumns.Header(text, "depth elsewhere, cold", cold);
        foreach (string engine in DepthGoals.EngineNames)
            SetColumns.Line(text, engine, cold, r => SetColumns.Time(DepthGoals.Of(engine, r.Set)));
        SetColumns.Line(text, "goal", cold, r => SetColumns.Time(r.Goal));
        SetColumns.Line(text, "goal, contacts, on top", contacts, r => SetColumns.Time(r.Goal));
        text.Append(
            CultureInfo.InvariantCulture,
            $"""

            The pairs overlap. Moving is 1 % of the smaller object's size between two calls, across the way out.
            Contacts on top are a cold call with contact points minus a cold depth, both measured in turns. A gap of 1 %
            of the smaller object's size counts as a contact.
            The engines were measured and the goals set elsewhere (one shared 2-core x86-64 machine with AVX-512, one
            pinned core; cited figures), on other pairs of the same description. The report's algorithm answers no
            depths, so both are scaled by the average slowness, {slowness:0.00}, as if that machine were the one of
            the figures above. No engine was measured warm, and none answers all such pairs right.

            """);
    }
}
