using System.Net;
using System.Text;

namespace Gjk.Bench.Reporting;

/// <summary>Writes the few SVG elements that a line chart needs. Coordinates are in pixels with y downwards, and are
/// written with one decimal.</summary>
internal sealed class SvgWriter
{
    /// <summary>Larger text where the picture is as narrow as a phone, without that which reads upwards, for which
    /// there is no room; and other colours where the reader's theme is dark.</summary>
    private const string Style = """
        <style>
        @media (max-width: 520px) {
        [font-size="12"], [font-size="13"] { font-size: 19px } [font-size="17"] { font-size: 20px }
        [transform] { display: none }
        }
        @media (prefers-color-scheme: dark) {
        [fill="#ffffff"] { fill: #1f2430 } [fill="#1f2328"] { fill: #e6edf3 } [fill="#57606a"] { fill: #aab4c0 }
        [stroke="#d0d7de"], [stroke="#e6e9ed"] { stroke: #3d4552 }
        [stroke="#0969da"] { stroke: #58a6ff } [fill="#0969da"] { fill: #58a6ff }
        [stroke="#bf5b04"] { stroke: #ff9a52 } [fill="#bf5b04"] { fill: #ff9a52 }
        [stroke="#8250df"] { stroke: #c4a5fb } [fill="#8250df"] { fill: #c4a5fb }
        [stroke="#6e7781"] { stroke: #aab4c0 } [fill="#6e7781"] { fill: #aab4c0 }
        }
        </style>

        """;

    private readonly StringBuilder _text = new();

    public SvgWriter(int width, int height, string title) => _text.Append(
        CultureInfo.InvariantCulture,
        $"<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" "
        + $"viewBox=\"0 0 {width} {height}\" font-family=\"system-ui, -apple-system, 'Segoe UI', Helvetica, Arial, "
        + $"sans-serif\" role=\"img\">\n<title>{WebUtility.HtmlEncode(title)}</title>\n{Style}");

    public enum Anchor
    {
        Start,
        Middle,
        End,
    }

    public void Rectangle(
        double x, double y, double width, double height, double radius, string fill, string stroke) => Element(
        $"<rect x=\"{N(x)}\" y=\"{N(y)}\" width=\"{N(width)}\" height=\"{N(height)}\" rx=\"{N(radius)}\" "
        + $"fill=\"{fill}\" stroke=\"{stroke}\"/>");

    public void Line(double x1, double y1, double x2, double y2, string stroke, double width) => Element(
        $"<line x1=\"{N(x1)}\" y1=\"{N(y1)}\" x2=\"{N(x2)}\" y2=\"{N(y2)}\" "
        + $"stroke=\"{stroke}\" stroke-width=\"{N(width)}\"/>");

    public void Polyline(IEnumerable<(double X, double Y)> points, string stroke, double width) => Element(
        $"<polyline points=\"{string.Join(' ', points.Select(p => $"{N(p.X)},{N(p.Y)}"))}\" fill=\"none\" "
        + $"stroke=\"{stroke}\" stroke-width=\"{N(width)}\" stroke-linejoin=\"round\"/>");

    /// <summary>Adds a dot. Its text appears when the pointer rests on the dot.</summary>
    public void Dot(double x, double y, double radius, string fill, string tip) => Element(
        $"<circle cx=\"{N(x)}\" cy=\"{N(y)}\" r=\"{N(radius)}\" fill=\"{fill}\">"
        + $"<title>{WebUtility.HtmlEncode(tip)}</title></circle>");

    public void Text(double x, double y, string text, int size, string fill, Anchor anchor, bool bold = false)
    {
        string weight = bold ? " font-weight=\"600\"" : "";
        Element(
            $"<text x=\"{N(x)}\" y=\"{N(y)}\" font-size=\"{size}\" fill=\"{fill}\"{AnchorOf(anchor)}{weight}>"
            + $"{WebUtility.HtmlEncode(text)}</text>");
    }

    /// <summary>Adds text that reads upwards, centred on the point.</summary>
    public void TextUpwards(double x, double y, string text, int size, string fill) => Element(
        $"<text transform=\"translate({N(x)} {N(y)}) rotate(-90)\" font-size=\"{size}\" fill=\"{fill}\""
        + $"{AnchorOf(Anchor.Middle)}>{WebUtility.HtmlEncode(text)}</text>");

    public string Finish() => _text + "</svg>\n";

    private static string N(double value) => value.ToString("0.#", CultureInfo.InvariantCulture);

    private static string AnchorOf(Anchor anchor) => anchor switch
    {
        Anchor.Middle => " text-anchor=\"middle\"",
        Anchor.End => " text-anchor=\"end\"",
        _ => "",
    };

    private void Element(string element) => _text.Append(element).Append('\n');
}
