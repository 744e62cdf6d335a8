namespace Gjk.Pages;

/// <summary>A vertex that the nearest feature does not need leaves the simplex.</summary>
internal static class DropFigure
{
    public static Figure Draw()
    {
        PlaneShape a = Example.A, b = Example.B;
        (Step before, Step after) = FirstDrop(a, b);
        Vector2 dropped = before.Simplex.Append(after.Vertex).First(v => !after.Simplex.Contains(v));
        var canvas = new Canvas(
            "A new corner joins the simplex, and the one that is no longer needed leaves it", 760, 340);
        Side(canvas, 20, a, b, before.Simplex, before.Nearest, "before: the simplex and its point nearest the origin");
        Panel right = Side(
            canvas, 390, a, b, after.Simplex, after.Nearest, "after: one vertex joined, one was dropped");
        right.Label(after.Vertex, "new", Ink.Answer, dx: 14, dy: 16, anchor: "start");
        right.Dot(dropped, Ink.Faint, 7);
        right.Label(dropped, "dropped", Ink.Text, dx: -14, dy: 20, anchor: "end");
        return canvas.Finish("drop");
    }

    /// <summary>Two steps in a row, of which the second drops a vertex.</summary>
    /// <exception cref="InvalidOperationException">The query dropped none.</exception>
    public static (Step Before, Step After) FirstDrop(PlaneShape a, PlaneShape b)
    {
        IReadOnlyList<Step> steps = a.Explain(b);
        for (int i = 1; i < steps.Count; i++)
        {
            int count = steps[i].Simplex.Count;
            if (count > 0 && count <= steps[i - 1].Simplex.Count) return (steps[i - 1], steps[i]);
        }

        throw new InvalidOperationException("No vertex was dropped.");
    }

    private static Panel Side(
        Canvas canvas, float left, PlaneShape a, PlaneShape b,
        IReadOnlyList<Vector2> simplex, Vector2 nearest, string caption)
    {
        Panel panel = canvas.AddPanel(left, 20, 350, 270, new(-4.6f, -2.1f), new(1.2f, 2.2f));
        panel.Polygon(a.Minus(b).Corners, Ink.Difference);
        for (int i = 1; i < simplex.Count; i++) panel.Line(simplex[i - 1], simplex[i], Ink.Answer, width: 4);
        foreach (Vector2 vertex in simplex) panel.Dot(vertex, Ink.Answer, 7);
        panel.Line(default, nearest, Ink.Origin, isDashed: true);
        panel.Dot(nearest, Ink.Origin);
        panel.Label(nearest, "v", Ink.Origin, dx: 4, dy: 34);
        panel.Origin();
        canvas.Caption(new(left + 175, 324), caption, 350);
        return panel;
    }
}
