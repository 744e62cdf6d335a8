using Gjk.Demo.Study.Data;
using Gjk.Demo.Study.Fit;

namespace Gjk.Demo.Study;

/// <summary>The results as CSV and as a page.</summary>
internal static class StudyReport
{
    private const string Style =
        "body{font:16px/1.5 system-ui,sans-serif;max-width:1120px;margin:2em auto;padding:0 1em;color:#1d2733}"
        + "table{border-collapse:collapse;font-size:14px}td,th{padding:3px 10px;border-bottom:1px solid #c9d1db;"
        + "text-align:left}td.n{text-align:right;font-variant-numeric:tabular-nums}svg{max-width:100%;height:auto}"
        + ".s{overflow-x:auto}";

    public static string Csv(StudyAnalysis analysis) =>
        StudyRow.Header + "\n" + string.Concat(analysis.Rows.Select(r => r.ToCsv() + "\n"));

    public static string Page(StudyAnalysis analysis, IReadOnlyList<Trial> trials, AnalysisSettings settings)
    {
        bool isSimulated = trials.Any(t => t.Participant.StartsWith("simulated-", StringComparison.Ordinal));
        var html = new StringBuilder($"""
            <!doctype html>
            <html lang="en"><head><meta charset="utf-8">
            <meta name="viewport" content="width=device-width, initial-scale=1">
            <meta http-equiv="Content-Security-Policy" content="default-src 'none'; style-src 'unsafe-inline'; "
                + "img-src data:">
            <link rel="icon" href="data:,"><title>Results of plan {PlainText.Markup(trials[0].Plan)}</title>
            <style>{Style}</style></head><body>
            <h1>Results of plan {PlainText.Markup(trials[0].Plan)}</h1>

            """);
        if (isSimulated) html.Append("<p><strong>Simulated observers: these are no data of people.</strong></p>\n");
        html.Append(PlainText.Markup(
            $"{analysis.IncludedPeople} people, {trials.Count(t => t.Kind == Trial.Real)} trials. "
                + $"{Exclusions(analysis, settings)} "
            + $"The library's answer to each of {trials.Count(t => t.Record.Length > 0)} records is the stored "
                + $"distance, "
            + "bit for bit. Gaps are in units of the scene; positive ones are apart."));
        if (analysis.Curves.Count > 0)
            html.Append("<h2>Constant stimuli</h2><div class=\"s\">").Append(
                StudyPlot.PsychometricCurves(analysis)).Append("</div>\n");
        html.Append("<h2>Thresholds</h2><div class=\"s\">").Append(StudyPlot.Thresholds(analysis)).Append("</div>\n");
        Table(html, "Everybody", [.. analysis.Rows.Where(r => r.Who == StudyRow.Everybody)]);
        Table(html, "Each person", [.. analysis.Rows.Where(r => r.Who != StudyRow.Everybody)]);
        return html.Append("</body></html>\n").ToString();
    }

    /// <summary>A sentence that says who was left out, and why.</summary>
    public static string Exclusions(StudyAnalysis analysis, AnalysisSettings settings)
    {
        string most =
            FormattableString.Invariant($"more than {settings.MostCatchErrors * 100:G3} % of the catch trials");
        return analysis.Excluded.Count == 0
            ? $"Nobody was excluded for failing {most}."
            : $"Excluded for failing {most}: {string.Join(", ", analysis.Excluded)}.";
    }

    private static void Table(StringBuilder html, string title, StudyRow[] rows)
    {
        html.Append($"<h2>{title}</h2><div class=\"s\"><table><tr>");
        foreach (string column in StudyRow.Header.Split(',')) html.Append($"<th>{column}</th>");
        html.Append("</tr>\n");
        foreach (StudyRow r in rows)
        {
            html.Append("<tr>");
            foreach (string text in (string[])[r.Task, r.Condition, r.Who, r.Measure])
                html.Append($"<td>{PlainText.Markup(text)}</td>");
            foreach (double n in (double[])[r.Value.Value, r.Value.Low, r.Value.High, r.Count, r.P])
                html.Append($"<td class=\"n\">{StudyRow.Text(n)}</td>");
            html.Append($"<td>{PlainText.Markup(r.Note)}</td></tr>\n");
        }

        html.Append("</table></div>\n");
    }
}
