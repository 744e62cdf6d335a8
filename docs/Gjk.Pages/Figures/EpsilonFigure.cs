using Gjk.Core;

namespace Gjk.Pages;

/// <summary>One epsilon for all sizes, against the answer at each size.</summary>
internal static class EpsilonFigure
{
    /// <summary>The gap between the boxes, in parts of their size.</summary>
    private const double Gap = 1.0 / 4096;

    /// <summary>Units of length: what many programs compare with.</summary>
    private const double Epsilon = 1e-4;

    private const int Smallest = -5, Largest = 5;

    public static Figure Draw()
    {
        var canvas = new Canvas(
            "The gap of two boxes over their size: an absolute epsilon is wrong for all small boxes", 760, 400);
        Panel panel = canvas.AddPanel(80, 20, 640, 300, new(-5.6f, -4.2f), new(5.8f, 1.4f));
        Vector2 Place(double size, double gap) => new((float)Math.Log10(size), Height(gap));
        (Vector2 left, Vector2 right) = (new(-5.6f, Height(Epsilon)), new(5.6f, Height(Epsilon)));
        panel.Area([new(-5.6f, -4), new(5.6f, -4), right, left], "url(#hatch)", ".8");
        panel.Line(left, right, Ink.B, isDashed: true);
        panel.Arrow(new(-5.6f, -4), new(5.8f, -4), Ink.Faint);
        panel.Arrow(new(-5.6f, -4), new(-5.6f, 1.2f), Ink.Faint);
        foreach (int power in Enumerable.Range(Smallest, Largest - Smallest + 1))
        {
            double size = Math.Pow(10, power);
            Vector2 at = Place(size, MeasuredGap((float)size));
            panel.Dot(at, Ink.Answer, 6);
            if (power % 2 != 0) panel.Label(new(power, -4), System.FormattableString.Invariant($"1e{power}"), dy: 20);
        }

        panel.Label(right, "epsilon = 1e-4", Ink.B, dy: -10, anchor: "end");
        panel.Label(new(5.4f, -3.2f), "everything down here «touches»", anchor: "end");
        panel.Label(new(-5.6f, 1.1f), "gap that the query finds", dx: 14, dy: 4, anchor: "start");
        canvas.Note(378, "size of the boxes, from 1e-5 to 1e5; the gap is always the same part of it, 1 / 4096");
        return canvas.Finish("epsilon");
    }

    /// <summary>Where a gap stands: its power of ten, pressed together.</summary>
    private static float Height(double gap) => 0.4f * (float)Math.Log10(gap);

    /// <summary>The library's distance of two cubes that are a fixed part of their size apart.</summary>
    public static double MeasuredGap(float size)
    {
        var box = new BoxShape(new Vector3(size / 2));
        var beside = new RigidPose(new Vector3((float)(size * (1 + Gap)), 0, 0));
        return ConvexQuery.Distance(box, RigidPose.Identity, box, beside).Distance;
    }
}
