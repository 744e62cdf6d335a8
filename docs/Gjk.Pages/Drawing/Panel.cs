namespace Gjk.Pages;

/// <summary>A part of a picture, drawn in the coordinates of the plane: x to the right, y up.</summary>
internal sealed class Panel(Canvas canvas, Vector2 corner, float scale, Vector2 low)
{
    public Vector2 Pixel(Vector2 p) => corner + new Vector2(p.X - low.X, low.Y - p.Y) * scale;

    public void Polygon(IEnumerable<Vector2> points, string color, bool isHatched = false)
    {
        List<Vector2> pixels = points.Select(Pixel).ToList();
        if (isHatched) canvas.Path(pixels, true, "fill=\"url(#hatch)\" stroke=\"none\"");
        canvas.Path(pixels, true, $"fill=\"{color}\" fill-opacity=\".12\" stroke=\"{color}\" stroke-width=\"2\"");
    }

    public void Area(IEnumerable<Vector2> points, string fill, string opacity = ".12") =>
        canvas.Path(points.Select(Pixel), true, $"fill=\"{fill}\" fill-opacity=\"{opacity}\"");

    public void Disc(Vector2 at, float radius, string color, bool isDashed = false) => canvas.Circle(
        Pixel(at), radius * scale, $"fill=\"none\" stroke=\"{color}\" stroke-width=\"2\"{Dash(isDashed)}");

    public void Line(Vector2 from, Vector2 to, string color, bool isDashed = false, float width = 2) => canvas.Path(
        [Pixel(
            from), Pixel(to)], false, $"fill=\"none\" stroke=\"{color}\" stroke-width=\"{width:0.#}\"{Dash(isDashed)}");

    public void Curve(IEnumerable<Vector2> points, string color) =>
        canvas.Path(points.Select(Pixel), false, $"fill=\"none\" stroke=\"{color}\" stroke-width=\"2\"");

    /// <summary>A line with a head of a fixed size in pixels.</summary>
    public void Arrow(Vector2 from, Vector2 to, string color)
    {
        Vector2 end = Pixel(to), along = Vector2.Normalize(end - Pixel(from)), across = new(-along.Y, along.X);
        canvas.Path([Pixel(from), end - 8 * along], false, $"fill=\"none\" stroke=\"{color}\" stroke-width=\"3\"");
        canvas.Path([end, end - 13 * along + 5 * across, end - 13 * along - 5 * across], true, $"fill=\"{color}\"");
    }

    public void Dot(Vector2 at, string color, float radius = 5) =>
        canvas.Circle(Pixel(at), radius, $"fill=\"{color}\" stroke=\"{Ink.Paper}\" stroke-width=\"1.5\"");

    /// <summary>The origin: a cross in a ring, so that it is not taken for a vertex.</summary>
    public void Origin(string label = "origin", float dx = 10, float dy = 20)
    {
        Vector2 at = Pixel(default);
        canvas.Circle(at, 7, $"fill=\"{Ink.Paper}\" stroke=\"{Ink.Origin}\" stroke-width=\"2\"");
        foreach (Vector2 arm in new Vector2[] { new(11, 0), new(0, 11) })
            canvas.Path([at - arm, at + arm], false, $"stroke=\"{Ink.Origin}\" stroke-width=\"2\"");
        canvas.Text(at + new Vector2(dx, dy), label, Ink.Origin, "start");
    }

    public void Label(
        Vector2 at, string text, string color = Ink.Text, float dx = 0, float dy = 0, string anchor = "middle") =>
        canvas.Text(Pixel(at) + new Vector2(dx, dy), text, color, anchor);

    private static string Dash(bool isDashed) => isDashed ? " stroke-dasharray=\"6 5\"" : "";
}
