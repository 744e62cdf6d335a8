using Gjk.Demo.Study.Data;
using Gjk.Demo.Study.Fit;

namespace Gjk.Demo.Study;

/// <summary>Draws the results as SVG: one panel with curves for each condition, and the thresholds of all.</summary>
internal static class StudyPlot
{
    private const int Wide = 360, High = 240, Left = 48, Bottom = 44, Top = 30, Right = 22;

    private const string Ink = "#1d2733", Grid = "#c9d1db", Curves = "#2b6cd4", Mean = "#c2410c";

    /// <summary>Psychometric curves of all people with their data, and the curve of the means.</summary>
    public static string PsychometricCurves(StudyAnalysis analysis)
    {
        string[] conditions = [.. analysis.Curves.Select(c => c.Condition).Distinct()];
        int columns = Math.Clamp(conditions.Length, 1, 3),
            rows = Math.Max(1, (conditions.Length + columns - 1) / columns);
        var svg = new StringBuilder(Open(columns * Wide, rows * High, "Psychometric curves"));
        for (int i = 0; i < conditions.Length; i++)
        {
            svg.Append(
                CultureInfo.InvariantCulture,
                    $"<g transform=\"translate({i % columns * Wide} {i / columns * High})\">");
            Panel(svg, conditions[i], [.. analysis.Curves.Where(c => c.Condition == conditions[i])]);
            svg.Append("</g>\n");
        }

        return svg.Append("</svg>\n").ToString();
    }

    /// <summary>The mean threshold of each condition with its interval, for both tasks that have one.</summary>
    public static string Thresholds(StudyAnalysis analysis)
    {
        StudyRow[] rows =
        [
            .. analysis.Rows.Where(r => r.Who == StudyRow.Everybody
                && ((r.Task == Trial.Adjustment && r.Measure == "mean")
                    || (r.Task == Trial.Constant && r.Measure == "pse"))),
        ];
        const int line = 30, wide = 720, left = 260;
        int high = Top + Math.Max(1, rows.Length) * line + Bottom;
        var svg = new StringBuilder(Open(wide, high, "Thresholds with intervals of 95 %"));
        double[] ends =
            [0, .. rows.SelectMany(r => new[] { r.Value.Value, r.Value.Low, r.Value.High }).Where(double.IsFinite)];
        Axis x = Axis.Of(ends.Min(), ends.Max(), left, wide - Right);
        x.Draw(svg, Top, high - Bottom, "signed gap (units of the scene)");
        for (int i = 0; i < rows.Length; i++)
        {
            double y = Top + (i + 0.5) * line;
            Estimate e = rows[i].Value;
            Text(svg, 8, y + 4, $"{rows[i].Condition}, {(rows[i].Measure == "pse" ? "PSE" : "adjusted")}", "start");
            if (double.IsFinite(e.Low) && double.IsFinite(e.High))
            {
                svg.Append(Invariant($"<path d=\"M{x.At(e.Low):F1} {y:F1}H{x.At(e.High):F1}\" "));
                svg.Append($"stroke=\"{Curves}\" stroke-width=\"3\"/>\n");
            }

            svg.Append(Invariant($"<circle cx=\"{x.At(e.Value):F1}\" cy=\"{y:F1}\" r=\"5\" fill=\"{Mean}\"/>\n"));
        }

        return svg.Append("</svg>\n").ToString();
    }

    private static void Panel(StringBuilder svg, string name, PersonCurve[] people)
    {
        GapCount[] counts = [.. people.SelectMany(p => p.Data.Counts)];
        Axis x = Axis.Of(counts.Min(c => c.Gap), counts.Max(c => c.Gap), Left, Wide - Right);
        double Y(double rate) => High - Bottom - rate * (High - Bottom - Top);
        x.Draw(svg, Top, High - Bottom, "signed gap");
        foreach (double rate in (double[])[0, 0.5, 1])
        {
            svg.Append(Invariant($"<path d=\"M{Left} {Y(rate):F1}H{Wide - Right}\" stroke=\"{Grid}\"/>\n"));
            Text(svg, Left - 6, Y(rate) + 4, Invariant($"{rate * 100:F0} %"), "end");
        }

        Text(svg, Left, Top - 10, $"{name}: answers \"touching\"", "start");
        Curve[] fitted = [.. people.Where(p => p.Fit.Status == FitStatus.Fitted).Select(p => p.Fit.Curve)];
        foreach (Curve curve in fitted) Line(svg, curve, x, Y, Curves, 1, 0.35);
        foreach (IGrouping<double, GapCount> at in counts.GroupBy(c => c.Gap))
        {
            double rate = (double)at.Sum(c => c.Touching) / at.Sum(c => c.Trials);
            svg.Append(Invariant($"<circle cx=\"{x.At(at.Key):F1}\" cy=\"{Y(rate):F1}\" r=\"4\" fill=\"{Ink}\"/>\n"));
        }

        if (fitted.Length == 0) return;
        var mean = new Curve(
            fitted[0].Form, fitted.Average(c => c.Pse), fitted.Average(c => c.Scale), fitted.Average(c => c.Lapse));
        Line(svg, mean, x, Y, Mean, 2.5, 1);
    }

    private static void Line(
        StringBuilder svg, Curve curve, Axis x, Func<double, double> y, string colour, double width, double opacity)
    {
        IEnumerable<string> points = Enumerable.Range(0, 61).Select(i => x.Low + (x.High - x.Low) * i / 60)
            .Select(gap => Invariant($"{x.At(gap):F1},{y(curve.Touching(gap)):F1}"));
        svg.Append(Invariant(
            $"<polyline points=\"{string.Join(' ', points)}\" fill=\"none\" stroke=\"{colour}\" "));
        svg.Append(Invariant($"stroke-width=\"{width}\" opacity=\"{opacity}\"/>\n"));
    }

    private static string Open(int wide, int high, string title) => Invariant($"""
        <svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {wide} {high}" width="{wide}" height="{high}" role="img"
         font-family="system-ui, sans-serif" font-size="12" fill="{Ink}"><title>{title}</title>
        <rect width="{wide}" height="{high}" fill="#ffffff"/>

        """);

    private static void Text(StringBuilder svg, double x, double y, string text, string anchor) =>
        svg.Append(
            Invariant($"<text x=\"{x:F1}\" y=\"{y:F1}\" text-anchor=\"{anchor}\">{PlainText.Markup(text)}</text>\n"));

    private static string Invariant(FormattableString text) => FormattableString.Invariant(text);

    /// <summary>A horizontal axis with round ticks.</summary>
    private sealed record Axis(double Low, double High, double From, double To)
    {
        public static Axis Of(double low, double high, double from, double to)
        {
            double margin = high > low ? 0.05 * (high - low) : 1;
            return new Axis(low - margin, high + margin, from, to);
        }

        public double At(double value) => From + (value - Low) / (High - Low) * (To - From);

        public void Draw(StringBuilder svg, double top, double bottom, string name)
        {
            double raw = (High - Low) / 4, power = Math.Pow(10, Math.Floor(Math.Log10(raw)));
            double step = power * (raw / power < 2 ? 1 : raw / power < 5 ? 2 : 5);
            for (double tick = Math.Ceiling(Low / step) * step; tick <= High; tick += step)
            {
                double shown = Math.Round(tick / step) * step;
                svg.Append(Invariant($"<path d=\"M{At(shown):F1} {top:F1}V{bottom:F1}\" stroke=\"{Grid}\"/>\n"));
                Text(svg, At(shown), bottom + 16, Math.Abs(shown) < step / 2 ? "0" : Invariant($"{shown:G4}"),
                    "middle");
            }

            Text(svg, (From + To) / 2, bottom + 34, name, "middle");
        }
    }
}
