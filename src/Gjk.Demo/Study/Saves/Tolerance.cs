using Gjk.Demo.Study.Fit;

namespace Gjk.Demo.Study.Saves;

/// <summary>What people do not see, as <c>study fit</c> found it.</summary>
/// <param name="Condition">The condition with the smallest threshold, the most careful one.</param>
/// <param name="Curve">How often a gap looks like touching, in units of the study.</param>
/// <param name="IsSimulated">True if nobody but simulated observers took part.</param>
internal sealed record Tolerance(string Condition, Curve Curve, bool IsSimulated)
{
    /// <summary>Reads the thresholds from the CSV of <c>study fit</c>.</summary>
    /// <exception cref="RefusedException">It is none, or has no threshold above 0.</exception>
    public static Tolerance Read(string file, string text)
    {
        string[] lines = text.Split('\n', StringSplitOptions.RemoveEmptyEntries);
        if (lines.Length == 0 || lines[0].TrimEnd('\r') != StudyRow.Header)
            throw new RefusedException($"{file}: line 1: must be the header of study fit: {StudyRow.Header}");
        string[][] rows = [.. lines.Skip(1).Select(l => l.TrimEnd('\r').Split(',')).Where(r => r[0] == "constant")];
        Dictionary<string, double> jnd = Means(rows, "jnd");
        var both = Means(rows, "pse").Where(p => jnd.ContainsKey(p.Key) && p.Value > 0).OrderBy(p => p.Value).ToList();
        if (both.Count == 0)
            throw new RefusedException(
                $"{file}: no condition has a PSE above 0 and a JND for all, so nothing is unseen");
        (string condition, double pse) = both[0];
        var curve = new Curve(
            CurveForm.Gaussian, pse, Curve.ScaleOf(CurveForm.Gaussian, jnd[condition]), Lapse: 0);
        string[] people = [.. rows.Select(r => r[2]).Where(who => who != StudyRow.Everybody).Distinct()];
        bool isSimulated = people.All(p => p.StartsWith("simulated-", StringComparison.Ordinal));
        return new Tolerance(PlainText.Of(condition), curve, isSimulated);
    }

    private static Dictionary<string, double> Means(string[][] rows, string measure) => rows
        .Where(r => r.Length > 4 && r[2] == StudyRow.Everybody && r[3] == measure)
        .Select(r => (Condition: r[1], Is: double.TryParse(
            r[4], NumberStyles.Float, CultureInfo.InvariantCulture, out double value), Value: value))
        .Where(r => r.Is && double.IsFinite(r.Value)).ToDictionary(r => r.Condition, r => r.Value);
}
