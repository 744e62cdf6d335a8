using System.Globalization;

namespace Gjk.Pages;

/// <summary>A line of a chart.</summary>
/// <param name="Name">The name in the legend.</param>
/// <param name="Color">One of <see cref="Ink"/>.</param>
/// <param name="Points">Counts and nanoseconds from left to right, all above 0.</param>
internal sealed record ChartLine(string Name, string Color, IReadOnlyList<(double Count, double Time)> Points);

/// <summary>Times over counts, on two logarithmic axes.</summary>
internal static class LogLogChart
{
    private const int Width = 760, Height = 470, LegendRow = 30;

    private const float Left = 112, Right = 724, Top = 28, Bottom = 376;

    /// <param name="name">The figure's name.</param>
    /// <param name="title">What the picture shows, for those who cannot see it.</param>
    /// <param name="note">A sentence below: what is counted, and where it was measured.</param>
    /// <param name="lines">All of them with the same counts or some of them.</param>
    public static Figure Draw(string name, string title, string note, params ChartLine[] lines)
    {
        double[] ticks = [.. lines.SelectMany(l => l.Points).Select(p => p.Count).Distinct().Order()];
        double[] times = [.. lines.SelectMany(l => l.Points).Select(p => p.Time)];
        double low = Math.Floor(Math.Log10(times.Min())), high = Math.Ceiling(Math.Log10(times.Max()));
        double span = Math.Log(ticks[^1] / ticks[0]);
        float X(double count) => Left + (Right - Left) * (float)(Math.Log(count / ticks[0]) / span);
        float Y(double time) => Bottom - (Bottom - Top) * (float)((Math.Log10(time) - low) / (high - low));

        var canvas = new Canvas(title, Width, Height);
        string grid = $"fill=\"none\" stroke=\"{Ink.Faint}\" stroke-width=\"0.5\"";
        for (double decade = low; decade <= high; decade++)
        {
            float y = Y(Math.Pow(10, decade));
            canvas.Path([new(Left, y), new(Right, y)], false, grid);
            canvas.Text(new(Left - 8, y + 5), Unit(decade), anchor: "end");
        }

        foreach (double tick in ticks)
        {
            canvas.Path([new(X(tick), Top), new(X(tick), Bottom)], false, grid);
            canvas.Text(new(X(tick), Bottom + 28), Short(tick));
        }

        for (int i = 0; i < lines.Length; i++)
        {
            ChartLine line = lines[i];
            Vector2[] points = [.. line.Points.Select(p => new Vector2(X(p.Count), Y(p.Time)))];
            canvas.Path(points, false, $"fill=\"none\" stroke=\"{line.Color}\" stroke-width=\"2.4\"");
            foreach (Vector2 point in points) canvas.Circle(point, 3.6f, $"fill=\"{line.Color}\"");
            canvas.Text(new(Left + 14, Top + LegendRow * (i + 1)), line.Name, line.Color, "start");
        }

        canvas.Note(Bottom + 66, note);
        return canvas.Finish(name);
    }

    private static string Unit(double decade)
    {
        string[] units = ["ns", "µs", "ms", "s"];
        int unit = (int)Math.Clamp(Math.Floor(decade / 3), 0, units.Length - 1);
        return string.Create(CultureInfo.InvariantCulture, $"{Math.Pow(10, decade - 3 * unit):0.##} {units[unit]}");
    }

    private static string Short(double count) => count >= 1000
        ? string.Create(CultureInfo.InvariantCulture, $"{count / 1000:0}k")
        : count.ToString("0", CultureInfo.InvariantCulture);
}
