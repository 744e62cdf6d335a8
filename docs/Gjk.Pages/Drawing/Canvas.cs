using System.Globalization;
using System.Text;

namespace Gjk.Pages;

/// <summary>An SVG picture of one or more panels. Every number is rounded, so that all machines draw the same
/// text.</summary>
internal sealed class Canvas
{
    /// <summary>Pixels of the text where the picture has room, and where it is as narrow as a phone.</summary>
    private const int WideText = 15, NarrowText = 25;

    /// <summary>Pixels of a character of a narrow picture's text, a little more than the mean.</summary>
    private const float NarrowCharacter = 12.5f;

    /// <summary>Pixels from one line of a narrow picture to the next.</summary>
    private const int NarrowLine = 31;

    private readonly StringBuilder _svg = new();
    private readonly string _title;
    private readonly int _width;
    private float _height, _narrowEnd;

    /// <param name="title">What the picture shows, for those who cannot see it.</param>
    /// <param name="width">Pixels.</param>
    /// <param name="height">Pixels; notes below that make it higher.</param>
    public Canvas(string title, int width, int height)
    {
        _title = title;
        _width = width;
        _height = height;
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

    /// <summary>A sentence across the picture. A narrow picture breaks it into lines, downwards and below the notes
    /// before it.</summary>
    /// <param name="y">Where the first line stands.</param>
    /// <param name="text">One sentence or two.</param>
    public void Note(float y, string text) =>
        _narrowEnd = Note(_width / 2, Math.Max(y, _narrowEnd), y, text, _width - 20);

    /// <summary>A sentence below a part of the picture.</summary>
    /// <param name="at">The middle of the first line.</param>
    /// <param name="text">One sentence.</param>
    /// <param name="width">Pixels that it may take.</param>
    public void Caption(Vector2 at, string text, float width) => Note(at.X, at.Y, at.Y, text, width);

    /// <summary>Where the next line of a narrow picture would stand.</summary>
    private float Note(float x, float narrowY, float y, string text, float width)
    {
        List<string> lines = [""];
        foreach (string word in text.Split(' '))
        {
            if ((lines[^1].Length + 1 + word.Length) * NarrowCharacter > width) lines.Add("");
            lines[^1] = lines[^1].Length == 0 ? word : $"{lines[^1]} {word}";
        }

        Add(NoteLine(x, y, text, "wide"));
        for (int i = 0; i < lines.Count; i++) Add(NoteLine(x, narrowY + i * NarrowLine, lines[i], "narrow"));
        float end = narrowY + lines.Count * NarrowLine;
        _height = Math.Max(_height, end - NarrowLine + 14);
        return end;
    }

    public void Path(IEnumerable<Vector2> points, bool isClosed, string attributes) => Add(
        $"<path d=\"M{string.Join('L', points.Select(p =>
            $"{At(p.X)} {At(p.Y)}"))}{(isClosed ? "Z" : "")}\" {attributes}/>");

    public void Circle(Vector2 at, float radius, string attributes) =>
        Add($"<circle cx=\"{At(at.X)}\" cy=\"{At(at.Y)}\" r=\"{At(radius)}\" {attributes}/>");

    public Figure Finish(string name) => new(name, $$"""
        <svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {{_width}} {{At(_height)}}" width="{{_width}}" role="img"
          font-family="system-ui, sans-serif" stroke-linejoin="round" stroke-linecap="round">
        <title>{{_title}}</title>
        <style>
        text { font-size: {{WideText}}px; paint-order: stroke; stroke: {{Ink.Paper}}; stroke-width: 3px }
        .narrow { display: none }
        @media (max-width: 520px) {
        text { font-size: {{NarrowText}}px } .narrow { display: block } .wide { display: none }
        }
        @media (prefers-color-scheme: dark) {
        text { stroke: {{Ink.InTheDark.Single(ink => ink.Light == Ink.Paper).Dark}} }
        {{string.Concat(Ink.InTheDark.Select(ink =>
            $"[fill=\"{ink.Light}\"] {{ fill: {ink.Dark} }} [stroke=\"{ink.Light}\"] {{ stroke: {ink.Dark} }}\n"))}}}
        </style>
        <defs><pattern id="hatch" width="7" height="7" patternUnits="userSpaceOnUse" patternTransform="rotate(45)">
        <path d="M0 0V7" stroke="{{Ink.Faint}}" stroke-width="1.4"/></pattern></defs>
        <rect width="{{_width}}" height="{{At(_height)}}" rx="10" fill="{{Ink.Paper}}"/>

        """.Replace("\r", "") + _svg + "</svg>\n");

    private static string NoteLine(float x, float y, string text, string style) =>
        $"<text class=\"{style}\" x=\"{At(x)}\" y=\"{At(y)}\" fill=\"{Ink.Text}\" text-anchor=\"middle\">{text}</text>";

    private static string At(float value)
    {
        string text = Math.Round(value, 1).ToString("0.#", CultureInfo.InvariantCulture);
        return text == "-0" ? "0" : text;
    }

    private void Add(string element) => _svg.Append(element).Append('\n');
}
