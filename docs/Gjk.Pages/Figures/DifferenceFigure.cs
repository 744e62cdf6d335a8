namespace Gjk.Pages;

/// <summary>All differences of corners, and the few that a query asks for.</summary>
internal static class DifferenceFigure
{
    public static Figure Draw()
    {
        PlaneShape a = Example.A, b = Example.B;
        List<Vector2> all = a.Differences(b).ToList(), asked = Asked(a, b);
        var canvas = new Canvas(
            $"A - B has {all.Count} candidates for corners; the query asked for {asked.Count}", 760, 420);
        Panel panel = canvas.AddPanel(20, 40, 720, 330, new(-4.6f, -2f), new(1.2f, 2.2f));
        panel.Polygon(a.Minus(b).Corners, Ink.Difference);
        foreach (Vector2 point in all) panel.Dot(point, Ink.Faint, 4);
        for (int i = 0; i < asked.Count; i++)
        {
            panel.Dot(asked[i], Ink.Answer, 7);
            panel.Label(asked[i], $"{i + 1}", Ink.Answer, dx: 14, dy: -8);
        }

        panel.Origin();
        canvas.Note(
            404, $"{all.Count} differences of corners (grey); the query asked for {asked.Count} of them (numbered)");
        canvas.Note(426, "The outline of A - B is drawn for you. The query never has it.");
        return canvas.Finish("difference");
    }

    /// <summary>The vertices of A - B that the query saw.</summary>
    public static List<Vector2> Asked(PlaneShape a, PlaneShape b) =>
        a.Explain(b).Select(s => s.Vertex).Distinct().ToList();
}
