namespace Gjk.Demo.Study.Fit;

/// <summary>One figure of the analysis: a row of its CSV.</summary>
/// <param name="Task">The task it is of.</param>
/// <param name="Condition">What was shown, or two conditions with " - " between them.</param>
/// <param name="Who">A participant, or "all".</param>
/// <param name="Measure">What was measured, such as pse.</param>
/// <param name="Value">The figure with its interval of 95 %; NaN where there is none.</param>
/// <param name="Count">Trials for a participant, people for all.</param>
/// <param name="P">A corrected probability, or NaN.</param>
/// <param name="Note">What else must be known, or empty.</param>
internal sealed record StudyRow(
    string Task, string Condition, string Who, string Measure, Estimate Value, int Count, double P, string Note)
{
    public const string Everybody = "all";

    public const string Header = "task,condition,who,measure,value,low,high,count,p,note";

    public string ToCsv() => string.Join(',', ((string[])
    [
        Task, Condition, Who, Measure, Text(Value.Value), Text(Value.Low), Text(Value.High),
        Count.ToString(CultureInfo.InvariantCulture), Text(P), Note,
    ]).Select(PlainText.CsvField));

    /// <summary>Six digits; nothing for what is not known.</summary>
    public static string Text(double value) =>
        double.IsNaN(value) ? "" : value.ToString("G6", CultureInfo.InvariantCulture);
}
