namespace Gjk.Pages;

/// <summary>The same weights on the simplex, on A and on B.</summary>
internal static class WeightsFigure
{
    public static Figure Draw()
    {
        PlaneShape a = Example.A, b = Example.B;
        Step[] steps = [.. a.Explain(b)];
        Step last = steps.Last(s => s.Simplex.Count > 0);
        var canvas = new Canvas("The weights of the nearest point, and the same weights on A and on B", 760, 330);
        Panel left = canvas.AddPanel(20, 20, 350, 240, new(-1.4f, -1.3f), new(3.5f, 1.4f));
        Example.DrawShapes(left, a, b);
        Panel right = canvas.AddPanel(400, 20, 340, 240, new(-4.6f, -2.1f), new(1.2f, 2.2f));
        right.Polygon(a.Minus(b).Corners, Ink.Difference);
        right.Origin();
        Vector2 onA = default, onB = default;
        for (int i = 0; i < last.Simplex.Count; i++)
        {
            Step found = steps.Last(s => s.Vertex == last.Simplex[i]);
            string name = System.FormattableString.Invariant($"{last.Weights[i]:0.00}");
            onA += (float)last.Weights[i] * found.OnA;
            onB += (float)last.Weights[i] * found.OnB;
            // B shows the same corner for both vertices, so its labels stand below each other.
            foreach ((Panel panel, Vector2 at, string ink, Vector2 beside) in new[]
            {
                (left, found.OnA, Ink.A, new Vector2(10, i == 0 ? 24 : -10)),
                (left, found.OnB, Ink.B, new Vector2(10, i == 0 ? 86 : 60)),
                (right, found.Vertex, Ink.Difference, new Vector2(14, i == 0 ? 16 : 4)),
            })
            {
                panel.Dot(at, ink, 6);
                panel.Label(at, name, ink, beside.X, beside.Y, "start");
            }
        }

        right.Line(last.Simplex[0], last.Simplex[^1], Ink.Difference, width: 4);
        foreach ((Panel panel, Vector2 at) in new[] { (left, onA), (left, onB), (right, last.Nearest) })
            panel.Dot(at, Ink.Answer, 6);
        left.Line(onA, onB, Ink.Answer, isDashed: true);
        canvas.Note(
            290,
            "Red: the sum of the corners, each times its weight. On A - B it is v, on A and B the closest points.");
        canvas.Note(312, "A corner that appears in both vertices of the simplex gets both weights.");
        return canvas.Finish("weights");
    }
}
