namespace Gjk.Pages;

/// <summary>Apart and overlapping: where the origin is in A - B.</summary>
internal static class OriginFigure
{
    public static Figure Draw()
    {
        var canvas = new Canvas(
            "Two shapes apart, and A - B beside the origin; two that overlap, and the origin in A - B", 760, 520);
        Row(canvas, 30, Example.A, Example.B, "apart: the origin is outside A - B");
        Row(canvas, 280, Example.A, Example.Deep, "overlapping: the origin is inside A - B");
        return canvas.Finish("origin");
    }

    private static void Row(Canvas canvas, float top, PlaneShape a, PlaneShape b, string caption)
    {
        Panel left = canvas.AddPanel(10, top, 360, 190, new(-1.3f, -1.2f), new(3.5f, 1.2f));
        Example.DrawShapes(left, a, b);
        Panel right = canvas.AddPanel(390, top, 360, 190, new(-4.6f, -2.1f), new(1.8f, 2.2f));
        PlaneShape difference = a.Minus(b);
        right.Polygon(difference.Corners, Ink.Difference);
        right.Label(difference.Middle, "A - B", Ink.Difference, dx: -30);
        right.Origin(dx: a.Overlaps(b) ? 34 : 16, dy: a.Overlaps(b) ? -46 : 30);
        canvas.Note(top + 218, caption);
    }
}
