using System.Text;

namespace Gjk.Bench.Table;

/// <summary>The rows of casts as two tables with a column per set: here, and as other engines were measured.</summary>
internal static class CastReport
{
    /// <param name="text">Where to append the tables.</param>
    /// <param name="rows">All rows. Others are left out.</param>
    /// <param name="slowness">How many times slower this machine is than the goals' machine.</param>
    public static void Append(StringBuilder text, IEnumerable<TableRow> rows, double slowness)
    {
        TableRow[] cold = [.. rows.Where(r => r.Query == Query.Cast)];
        if (cold.Length == 0) return;

        SetColumns.Header(text, "cast here, ns per pair", cold);
        SetColumns.Line(text, "Gjk, cold", cold, r => SetColumns.Time(r.Library));
        SetColumns.Line(
            text, "the best engine, scaled", cold, r => $"{r.Best?.Engine} {SetColumns.Time(r.BestHere)}");
        SetColumns.Line(text, "wins", cold, r => r.Winner ?? "");
        SetColumns.Line(text, "goal, scaled", cold, r => SetColumns.Time(r.GoalHere));

        SetColumns.Header(text, "cast elsewhere", cold);
        foreach (string engine in CastGoals.EngineNames)
            SetColumns.Line(text, engine, cold, r => SetColumns.Time(CastGoals.Of(engine, r.Set)));
        SetColumns.Line(text, "goal", cold, r => SetColumns.Time(r.Goal));
        string wrong = string.Join(", ", CastGoals.EngineNames.Select(e => $"{e} {CastGoals.WrongOf(e)}"));
        text.Append(
            CultureInfo.InvariantCulture,
            $"""

            One object of each pair moves. Points are asked as rays. The engines were measured and the goals set
            elsewhere, as for depths, on other pairs of the same description, so both are scaled by the average
            slowness, {slowness:0.00}. Of {CastGoals.Judged} such casts they have wrong by more than 1e-5 of the
            size: {wrong}.

            """);
    }
}
