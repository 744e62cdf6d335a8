namespace Gjk.Pages;

/// <summary>One support on each shape makes one of A - B.</summary>
internal static class SupportFigure
{
    public static Figure Draw()
    {
        PlaneShape a = Example.A, b = Example.B;
        Step step = a.Explain(b)[0];
        Vector2 d = -Vector2.Normalize(step.Normal), across = new(-d.Y, d.X);
        var canvas = new Canvas("The furthest points of A along d and of B against d, and their difference", 760, 330);
        Panel left = canvas.AddPanel(20, 40, 350, 240, new(-1.4f, -1.3f), new(3.5f, 1.4f));
        Example.DrawShapes(left, a, b);
        foreach ((Vector2 point, string name, string ink, float dx) in new[]
            { (step.OnA, "a", Ink.A, 16), (step.OnB, "b", Ink.B, -18f) })
        {
            left.Line(point - 1.3f * across, point + 1.3f * across, Ink.Faint, isDashed: true);
            left.Dot(point, ink, 7);
            left.Label(point, name, ink, dx, dy: 8);
        }

        left.Arrow(a.Middle, a.Middle + 0.8f * d, Ink.A);
        left.Label(a.Middle + 0.8f * d, "d", Ink.A, dx: -4, dy: -14);
        left.Arrow(b.Middle, b.Middle - 0.6f * d, Ink.B);
        left.Label(b.Middle - 0.6f * d, "-d", Ink.B, dx: 22, dy: 26);

        Panel right = canvas.AddPanel(400, 40, 340, 240, new(-4.6f, -2.1f), new(1.2f, 2.2f));
        right.Polygon(a.Minus(b).Corners, Ink.Difference);
        right.Line(step.Vertex - 2 * across, step.Vertex + 2 * across, Ink.Faint, isDashed: true);
        right.Dot(step.Vertex, Ink.Answer, 7);
        right.Label(step.Vertex, "a - b", Ink.Answer, dx: 14, dy: -4, anchor: "start");
        right.Origin();
        canvas.Note(
            312, "a is furthest along d in A, b is furthest along -d in B; so a - b is furthest along d in A - B.");
        return canvas.Finish("support");
    }
}
