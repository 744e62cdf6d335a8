namespace Gjk.Pages;

/// <summary>How the two bounds of the distance meet.</summary>
internal static class BoundsFigure
{
    public static Figure Draw()
    {
        IReadOnlyList<Step> steps = Round(new(0, 0), 1).Explain(Round(new(1.6f, 2.2f), 0.2f));
        List<(int Number, double Above, double Below)> rows = Rows(steps);
        double top = rows.Max(r => r.Above) * 1.1;
        var canvas = new Canvas(
            "The upper and the lower bound of the distance after each step, until they meet", 760, 380);
        Panel panel = canvas.AddPanel(70, 30, 640, 290, default, new(6.4f, 2.9f));
        Vector2 Place(int number, double value) =>
            new(6.2f * number / rows.Count, (float)(2.8 * Math.Max(value, 0) / top));
        panel.Arrow(default, new(0, 2.9f), Ink.Faint);
        panel.Arrow(default, new(6.4f, 0), Ink.Faint);
        panel.Curve(rows.Select(r => Place(r.Number, r.Above)), Ink.Answer);
        panel.Curve(rows.Select(r => Place(r.Number, r.Below)), Ink.A);
        foreach ((int number, double above, double below) in rows)
        {
            panel.Dot(Place(number, above), Ink.Answer);
            panel.Dot(Place(number, below), Ink.A, 4);
            panel.Label(Place(number, 0), $"{number}", dy: 22);
        }

        panel.Label(
            Place(1, rows[0].Above), "|v|: the distance is at most this", Ink.Answer, dx: 12, dy: -6, anchor: "start");
        panel.Label(
            Place(4, rows[3].Below), "the best plane: it is at least this", Ink.A, dx: 4, dy: 28, anchor: "start");
        canvas.Note(378, $"step; after {rows.Count} of them no number lies between the two, and the loop ends");
        return canvas.Finish("bounds");
    }

    /// <summary>Per step, |v| and the best lower bound so far.</summary>
    public static List<(int Number, double Above, double Below)> Rows(IReadOnlyList<Step> steps)
    {
        var rows = new List<(int, double, double)>();
        double above = double.PositiveInfinity, below = 0;
        for (int i = 0; i < steps.Count; i++)
        {
            below = Math.Max(below, steps[i].LowerBound);
            if (steps[i].Simplex.Count > 0) above = steps[i].Nearest.Length();
            rows.Add((i + 1, above, below));
        }

        return rows;
    }

    /// <summary>A flat ellipse of 60 corners about a point, the longer half 2 units.</summary>
    public static PlaneShape Round(Vector2 middle, float shorter) => new(Enumerable.Range(0, 60).Select(i =>
    {
        (double sine, double cosine) = Math.SinCos(i * Math.Tau / 60);
        return middle + new Vector2((float)Math.Round(2 * cosine, 4), (float)Math.Round(shorter * sine, 4));
    }));
}
