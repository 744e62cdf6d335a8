namespace Gjk.Pages;

/// <summary>The two polygons that most figures show.</summary>
internal static class Example
{
    public static PlaneShape A => new(
        new Vector2(-1, -0.8f), new(0.6f, -1), new(1.2f, 0.3f), new(0.1f, 1.1f), new(-1.1f, 0.6f));

    /// <summary>Beside A.</summary>
    public static PlaneShape B => new(new Vector2(1.9f, -0.5f), new(3.3f, -0.9f), new(2.9f, 0.9f));

    /// <summary>Moved into A.</summary>
    public static PlaneShape Deep => B.Moved(new Vector2(-1.5f, 0.15f));

    /// <summary>Draws both shapes with their names.</summary>
    public static void DrawShapes(Panel panel, PlaneShape a, PlaneShape b)
    {
        panel.Polygon(a.Corners, Ink.A);
        panel.Polygon(b.Corners, Ink.B);
        panel.Label(a.Middle, "A", Ink.A, dx: -16, dy: 5);
        panel.Label(b.Middle, "B", Ink.B, dx: 12, dy: 5);
    }
}
