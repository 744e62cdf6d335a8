using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Numerics;
using System.Text;

namespace Gjk.Pages;

/// <summary>An SVG picture of one or more panels. Every number is rounded, so that all machines draw the same
/// text.</summary>
internal sealed class Canvas
{
    private readonly StringBuilder _svg = new();

    /// <param name="title">What the picture shows, for those who cannot see it.</param>
    /// <param name="width">Pixels.</param>
    /// <param name="height">Pixels.</param>
    public Canvas(string title, int width, int height)
    {
        _svg.Append($"""
            <svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" role="img"
              font-family="system-ui, sans-serif" font-size="15" stroke-linejoin="round" stroke-linecap="round">
            <title>{title}</title>
            <defs><pattern id="hatch" width="7" height="7" patternUnits="userSpaceOnUse" patternTransform="rotate(45)">
            <path d="M0 0V7" stroke="{Ink.Faint}" stroke-width="1.4"/></pattern></defs>
            <rect width="{width}" height="{height}" rx="10" fill="{Ink.Paper}"/>

            """.Replace("\r", ""));
    }

    /// <summary>A part of the picture with coordinates of its own.</summary>
    /// <param name="left">Pixels from the left.</param>
    /// <param name="top">Pixels from the top.</param>
    /// <param name="width">Pixels.</param>
    /// <param name="height">Pixels.</param>
    /// <param name="low">The lowest coordinates that are seen.</param>
    /// <param name="high">The highest ones. The panel keeps their proportions.</param>
    public Panel AddPanel(float left, float top, float width, float height, Vector2 low, Vector2 high)
    {
        float scale = MathF.Min(width / (high.X - low.X), height / (high.Y - low.Y));
        Vector2 free = new Vector2(width, height) - scale * (high - low);
        return new Panel(this, new Vector2(left, top + height) + new Vector2(free.X, -free.Y) / 2, scale, low);
    }

    public void Text(Vector2 at, string text, string color = Ink.Text, string anchor = "middle") =>
        Add(
            $"<text x=\"{At(at.X)}\" y=\"{At(at.Y)}\" fill=\"{color}\" text-anchor=\"{anchor}\">{text}</text>");

    public void Path(IEnumerable<Vector2> points, bool isClosed, string attributes) => Add(
        $"<path d=\"M{string.Join('L', points.Select(p =>
            $"{At(p.X)} {At(p.Y)}"))}{(isClosed ? "Z" : "")}\" {attributes}/>");

    public void Circle(Vector2 at, float radius, string attributes) =>
        Add($"<circle cx=\"{At(at.X)}\" cy=\"{At(at.Y)}\" r=\"{At(radius)}\" {attributes}/>");

    public Figure Finish(string name) => new(name, _svg + "</svg>\n");

    private static string At(float value)
    {
        string text = Math.Round(value, 1).ToString("0.#", CultureInfo.InvariantCulture);
        return text == "-0" ? "0" : text;
    }

    private void Add(string element) => _svg.Append(element).Append('\n');
}
