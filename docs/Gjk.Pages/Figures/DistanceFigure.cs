using Gjk.Core;

namespace Gjk.Pages;

/// <summary>The distance in both pictures.</summary>
internal static class DistanceFigure
{
    public static Figure Draw()
    {
        PlaneShape a = Example.A, b = Example.B;
        DistanceResult result = a.SignedDistance(b);
        Vector2 nearest = a.Explain(b).Last(s => s.Simplex.Count > 0).Nearest;
        var canvas = new Canvas("The shortest line between the shapes, and the one from the origin to A - B", 760, 320);
        Panel left = canvas.AddPanel(20, 20, 350, 240, new(-1.4f, -1.3f), new(3.5f, 1.4f));
        Example.DrawShapes(left, a, b);
        Ends(left, Plane.Of(result.PointA), Plane.Of(result.PointB), result.Distance);
        Panel right = canvas.AddPanel(400, 20, 340, 240, new(-4.6f, -2.1f), new(1.2f, 2.2f));
        right.Polygon(a.Minus(b).Corners, Ink.Difference);
        right.Origin("");
        Ends(right, nearest, default, nearest.Length());
        canvas.Note(
            290, "PointA - PointB is the point of A - B nearest the origin: the two red lines have the same length.");
        return canvas.Finish("distance");
    }

    private static void Ends(Panel panel, Vector2 from, Vector2 to, float length)
    {
        panel.Line(from, to, Ink.Answer, width: 3);
        panel.Dot(from, Ink.Answer);
        panel.Dot(to, Ink.Answer);
        panel.Label((from + to) / 2, System.FormattableString.Invariant($"{length:0.000}"), Ink.Answer, dy: 56);
    }
}
