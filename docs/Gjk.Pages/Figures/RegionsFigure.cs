namespace Gjk.Pages;

/// <summary>The Voronoi regions of a triangle, and those in which the origin cannot be.</summary>
internal static class RegionsFigure
{
    private const float Far = 4;

    public static Figure Draw()
    {
        Vector2 p = new(-1.2f, -0.7f), q = new(1.3f, -0.6f), w = new(0.2f, 1.1f);
        var canvas = new Canvas("A triangle's regions: three corners, three edges, the inside", 760, 440);
        Panel panel = canvas.AddPanel(130, 20, 500, 360, new(-2.6f, -1.8f), new(2.6f, 2f));
        Vector2 pq = Outward(p, q), qw = Outward(q, w), wp = Outward(w, p);
        foreach (Vector2[] skipped in new Vector2[][]
        {
            [p, q, q + pq, p + pq],
            [p, p + pq, p + 2 * pq + 2 * wp, p + wp],
            [q, q + qw, q + 2 * pq + 2 * qw, q + pq],
        })
        {
            panel.Area(Clip(skipped), "url(#hatch)", "1");
        }

        panel.Polygon([p, q, w], Ink.Difference);
        foreach ((Vector2 corner, Vector2 n) in new[] { (p, pq), (p, wp), (q, pq), (q, qw), (w, qw), (w, wp) })
            panel.Line(corner, Cut(corner, n), Ink.Faint, isDashed: true);
        foreach ((Vector2 at, string name, float dx) in new[] { (p, "p", -18), (q, "q", 18f) })
            Corner(panel, at, name, dx);
        panel.Dot(w, Ink.Difference, 6);
        panel.Label(w, "w", Ink.Difference, dx: 14, dy: 6);
        panel.Label(new(0.1f, -1.35f), "nearest: edge pq");
        panel.Label(new(1.75f, 0.75f), "nearest: edge qw");
        panel.Label(new(-1.55f, 0.75f), "nearest: edge wp");
        panel.Label(new(0.1f, -0.1f), "inside");
        panel.Label(new(0.55f, 1.85f), "nearest: w", dx: -20);
        panel.Label(new(-2.05f, -1.35f), "nearest: p");
        panel.Label(new(2.1f, -1.35f), "nearest: q");
        canvas.Note(
            408, "w is the new vertex. The last step went from pq towards the origin: a boolean may skip the hatched.");
        canvas.Note(430, "A distance query keeps p and q: rounding, or a step from elsewhere, can leave it there.");
        return canvas.Finish("regions");
    }

    private static Vector2 Outward(Vector2 from, Vector2 to)
    {
        Vector2 edge = Vector2.Normalize(to - from);
        return Far * new Vector2(edge.Y, -edge.X);
    }

    private static void Corner(Panel panel, Vector2 at, string name, float dx)
    {
        panel.Dot(at, Ink.Difference, 6);
        panel.Label(at, name, Ink.Difference, dx, dy: 28);
    }

    /// <summary>The end of a ray at the picture's edge.</summary>
    private static Vector2 Cut(Vector2 from, Vector2 along)
    {
        float x = along.X > 0 ? (2.6f - from.X) / along.X : along.X < 0 ? (-2.6f - from.X) / along.X : float.MaxValue;
        float y = along.Y > 0 ? (2f - from.Y) / along.Y : along.Y < 0 ? (-1.8f - from.Y) / along.Y : float.MaxValue;
        return from + float.Min(x, y) * along;
    }

    /// <summary>A convex polygon cut to the picture (Sutherland and Hodgman, 1974).</summary>
    private static List<Vector2> Clip(IEnumerable<Vector2> polygon)
    {
        List<Vector2> points = [.. polygon];
        foreach ((Vector2 normal, float limit) in new[]
            { (Vector2.UnitX, 2.6f), (-Vector2.UnitX, 2.6f), (Vector2.UnitY, 2f), (-Vector2.UnitY, 1.8f) })
        {
            var kept = new List<Vector2>();
            for (int i = 0; i < points.Count; i++)
            {
                Vector2 from = points[i], to = points[(i + 1) % points.Count];
                float a = limit - Vector2.Dot(normal, from), b = limit - Vector2.Dot(normal, to);
                if (a >= 0) kept.Add(from);
                if (a * b < 0) kept.Add(from + a / (a - b) * (to - from));
            }

            points = kept;
        }

        return points;
    }
}
