using Gjk.Core;

namespace Gjk.Pages;

/// <summary>The shortest way out of an overlap, in both pictures.</summary>
internal static class DepthFigure
{
    public static Figure Draw()
    {
        PlaneShape a = Example.A, b = Example.Deep;
        DistanceResult result = a.SignedDistance(b);
        Vector2 push = -result.Distance * Plane.Of(result.Normal);
        var canvas = new Canvas(
            "Two shapes that overlap, the shortest way out, and the side of A - B nearest the origin", 760, 360);
        Panel left = canvas.AddPanel(20, 20, 350, 270, new(-1.4f, -1.4f), new(2.8f, 1.8f));
        left.Polygon(b.Moved(push).Corners, Ink.Faint);
        Example.DrawShapes(left, a, b);
        Vector2 below = b.Middle - new Vector2(0, 0.35f);
        left.Arrow(below, below + push, Ink.Answer);
        left.Label(below + push, Length(push), Ink.Answer, dx: 60, dy: -50, anchor: "start");
        PlaneShape difference = a.Minus(b);
        Panel right = canvas.AddPanel(400, 20, 340, 270, new(-3.3f, -2.3f), new(1.8f, 2.2f));
        right.Polygon(difference.Corners, Ink.Difference);
        right.Disc(default, push.Length(), Ink.Faint, isDashed: true);
        right.Origin("", 0, 0);
        right.Arrow(default, push, Ink.Answer);
        right.Label(push, Length(push), Ink.Answer, dx: 40, dy: 30, anchor: "start");
        canvas.Note(
            322,
            "The depth is the distance from the origin to the nearest side of A - B. Moved by it, B only touches A.");
        canvas.Note(344, "The dashed circle is the largest one around the origin that fits into A - B.");
        return canvas.Finish("depth");
    }

    private static string Length(Vector2 v) => System.FormattableString.Invariant($"{v.Length():0.000}");
}
