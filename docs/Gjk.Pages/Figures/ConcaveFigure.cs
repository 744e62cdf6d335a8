namespace Gjk.Pages;

/// <summary>A shape with a notch: its hull fills it, its parts do not.</summary>
internal static class ConcaveFigure
{
    private static readonly Vector2[] Outline = [new(
        -1, -1), new(1, -1), new(1, -0.4f), new(-0.4f, -0.4f), new(-0.4f, 1), new(-1, 1)];

    public static PlaneShape Guest =>
        new(new Vector2(-0.1f, -0.1f), new(0.5f, -0.1f), new(0.5f, 0.4f), new(-0.1f, 0.4f));

    /// <summary>What a mesh of the outline is to the library.</summary>
    public static PlaneShape Hull => new(Outline);

    public static PlaneShape[] Parts =>
    [
        new(new Vector2(-1, -1), new(1, -1), new(1, -0.4f), new(-1, -0.4f)),
        new(new Vector2(-1, -0.4f), new(-0.4f, -0.4f), new(-0.4f, 1), new(-1, 1)),
    ];

    public static Figure Draw()
    {
        var canvas = new Canvas(
            "An L with a box in its notch: as one hull they overlap, as two parts they do not", 760, 330);
        Panel left = canvas.AddPanel(30, 20, 330, 240, new(-1.3f, -1.3f), new(1.3f, 1.3f));
        left.Polygon(Hull.Corners, Ink.A, isHatched: true);
        left.Polygon(Outline, Ink.A);
        left.Polygon(Guest.Corners, Ink.B);
        canvas.Caption(new(195, 290), Hull.Overlaps(Guest) ? "one mesh: its hull overlaps B" : "one mesh: apart", 350);
        Panel right = canvas.AddPanel(400, 20, 330, 240, new(-1.3f, -1.3f), new(1.3f, 1.3f));
        float nearest = float.PositiveInfinity;
        foreach (PlaneShape part in Parts)
        {
            right.Polygon(part.Corners, Ink.A);
            nearest = float.Min(nearest, part.SignedDistance(Guest).Distance);
        }

        right.Polygon(Guest.Corners, Ink.B);
        canvas.Caption(
            new(565, 290), System.FormattableString.Invariant($"two convex parts: {nearest:0.00} apart"), 350);
        return canvas.Finish("concave");
    }
}
