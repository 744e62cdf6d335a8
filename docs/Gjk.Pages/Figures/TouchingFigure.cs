namespace Gjk.Pages;

/// <summary>Two squares that share an edge: the origin on the boundary of A - B.</summary>
internal static class TouchingFigure
{
    public static PlaneShape Square => new(new Vector2(-1, -1), new(1, -1), new(1, 1), new(-1, 1));

    public static Figure Draw()
    {
        var canvas = new Canvas(
            "Squares apart, touching and overlapping, and the origin outside, on and inside A - B", 760, 420);
        (float Move, string Caption)[] cases = [(2.5f, "apart: no"), (2, "touching: yes"), (1.5f, "overlapping: yes")];
        for (int i = 0; i < cases.Length; i++)
        {
            PlaneShape b = Square.Moved(new(cases[i].Move, 0.5f));
            float left = 15 + 250 * i;
            Panel top = canvas.AddPanel(left, 15, 230, 150, new(-1.2f, -1.2f), new(3.7f, 1.7f));
            Example.DrawShapes(top, Square, b);
            Panel bottom = canvas.AddPanel(left, 180, 230, 180, new(-4.8f, -2.8f), new(1.4f, 2f));
            bottom.Polygon(Square.Minus(b).Corners, Ink.Difference);
            bottom.Origin("", 0, 0);
            canvas.Text(new(left + 115, 390), cases[i].Caption, Square.Overlaps(b) ? Ink.Answer : Ink.Text);
        }

        return canvas.Finish("touching");
    }
}
