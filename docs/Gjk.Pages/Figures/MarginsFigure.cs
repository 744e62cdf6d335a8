using Gjk.Core;

namespace Gjk.Pages;

/// <summary>Round shapes as a core and a margin.</summary>
internal static class MarginsFigure
{
    public static Figure Draw()
    {
        const float radius = 0.6f, round = 0.35f;
        Vector2 low = new(-1, -0.7f), high = new(-1, 0.9f), center = new(2, 0.3f);
        var canvas = new Canvas("A capsule is a segment with a margin, a sphere is a point with one", 760, 330);
        Panel panel = canvas.AddPanel(60, 20, 640, 230, new(-2, -1.5f), new(3, 1.7f));
        foreach (Vector2 end in new[] { low, high }) panel.Disc(end, round, Ink.A, isDashed: true);
        foreach (float side in new[] { -round, round })
            panel.Line(low + new Vector2(side, 0), high + new Vector2(side, 0), Ink.A, true);
        panel.Line(low, high, Ink.A, width: 4);
        panel.Disc(center, radius, Ink.B, isDashed: true);
        panel.Dot(center, Ink.B, 6);
        DistanceResult cores = Ask(0, 0), whole = Ask(round, radius);
        panel.Line(Plane.Of(cores.PointA), Plane.Of(cores.PointB), Ink.Faint, isDashed: true);
        panel.Line(Plane.Of(whole.PointA), Plane.Of(whole.PointB), Ink.Answer, width: 4);
        Vector2 middle = Plane.Of(whole.PointA + whole.PointB) / 2;
        panel.Label(middle, System.FormattableString.Invariant($"{whole.Distance:0.00}"), Ink.Answer, dy: -12);
        panel.Label(high, "capsule: a segment, margin 0.35", Ink.A, dx: 30, dy: -44);
        panel.Label(center, "sphere: a point, margin 0.6", Ink.B, dy: 110);
        string sum = System.FormattableString.Invariant($"{cores.Distance:0.00} - 0.35 - 0.60 = {whole.Distance:0.00}");
        canvas.Note(285, $"GJK measures the cores (grey), then the margins are taken off: {sum}");
        canvas.Note(308, "No corner of the round outline is ever asked for.");
        return canvas.Finish("margins");
    }

    /// <summary>The library's distance with other margins.</summary>
    public static DistanceResult Ask(float capsuleRadius, float sphereRadius) => ConvexQuery.Distance(
        new CapsuleShape(capsuleRadius, 0.8f), new RigidPose(new Vector3(-1, 0.1f, 0)),
        new SphereShape(sphereRadius), new RigidPose(new Vector3(2, 0.3f, 0)));
}
