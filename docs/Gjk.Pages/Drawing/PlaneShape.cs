using Gjk.Core;
using Gjk.Core.Diagnostics;

namespace Gjk.Pages;

/// <summary>A convex polygon in the plane z = 0, and the flat mesh that the library is asked about.</summary>
internal sealed class PlaneShape
{
    /// <summary>Units on each side of the plane: more than any depth of the figures.</summary>
    private const float Thickness = 16;

    /// <param name="corners">In any order; what is inside is dropped.</param>
    public PlaneShape(params IEnumerable<Vector2> corners)
    {
        var hull = new ConvexHull(corners.Select(p => new Vector3(p, 0)).ToArray());
        Shape = ConvexShape.Mesh(hull);
        Vector2[] kept = Enumerable.Range(0, hull.VertexCount).Select(i => Plane.Of(hull.GetVertex(i))).ToArray();
        Vector2 middle = kept.Aggregate(Vector2.Zero, (s, p) => s + p) / kept.Length;
        Corners = kept.OrderBy(p => MathF.Atan2(p.Y - middle.Y, p.X - middle.X)).ToArray();
    }

    public ConvexShape Shape { get; }

    /// <summary>Counter-clockwise.</summary>
    public IReadOnlyList<Vector2> Corners { get; }

    public Vector2 Middle => Corners.Aggregate(Vector2.Zero, (s, p) => s + p) / Corners.Count;

    public PlaneShape Moved(Vector2 by) => new(Corners.Select(p => p + by));

    /// <summary>Every difference of a corner of this and one of another: what A - B is the hull of.</summary>
    public IEnumerable<Vector2> Differences(PlaneShape other) =>
        Corners.SelectMany(a => other.Corners.Select(b => a - b));

    /// <summary>A - B.</summary>
    public PlaneShape Minus(PlaneShape other) => new(Differences(other));

    /// <summary>As in the plane: a flat shape leaves another one sideways at once, so both are made thick.</summary>
    public DistanceResult SignedDistance(PlaneShape other) =>
        ConvexQuery.SignedDistance(Thick(), RigidPose.Identity, other.Thick(), RigidPose.Identity);

    public bool Overlaps(PlaneShape other) =>
        ConvexQuery.Overlaps(Shape, RigidPose.Identity, other.Shape, RigidPose.Identity);

    private ConvexShape Thick() => ConvexShape.Mesh(new ConvexHull(
        Corners.SelectMany(p => new[] { new Vector3(p, -Thickness), new Vector3(p, Thickness) }).ToArray()));

    /// <summary>The search for the distance, step by step.</summary>
    public IReadOnlyList<Step> Explain(PlaneShape other)
    {
        var trace = new Trace([]);
        ConvexQuery.Explain(Shape, RigidPose.Identity, other.Shape, RigidPose.Identity, ref trace);
        return trace.Steps;
    }
}

/// <summary>One support, and the simplex that it led to.</summary>
/// <param name="Normal">From the origin to the nearest feature; A is asked against it, B along it.</param>
/// <param name="OnA">A's support point.</param>
/// <param name="OnB">B's support point.</param>
/// <param name="Vertex">Their difference.</param>
/// <param name="LowerBound">What the support proves.</param>
/// <param name="Simplex">The vertices that stayed; empty where the support ended the search.</param>
/// <param name="Weights">Of the vertices that stayed.</param>
/// <param name="Nearest">The simplex's point nearest the origin.</param>
internal sealed record Step(
    Vector2 Normal,
    Vector2 OnA,
    Vector2 OnB,
    Vector2 Vertex,
    double LowerBound,
    IReadOnlyList<Vector2> Simplex,
    IReadOnlyList<double> Weights,
    Vector2 Nearest);

/// <summary>Collects the steps of a search.</summary>
internal readonly struct Trace(List<Step> steps) : IGjkTrace
{
    public List<Step> Steps => steps;

    public bool IsOn => true;

    public void OnSupport(in TracedSupport support) => steps.Add(new Step(
        Plane.Of(support.Normal), Plane.Of(support.PointOnA), Plane.Of(support.PointOnB), Plane.Of(support.Vertex),
        support.LowerBound, [], [], default));

    public void OnReduced(in TracedSimplex simplex)
    {
        TracedSimplex copy = simplex;
        int[] all = Enumerable.Range(0, simplex.Count).ToArray();
        steps[^1] = steps[^1] with
        {
            Simplex = all.Select(i => Plane.Of(copy.Vertex(i))).ToArray(),
            Weights = all.Select(i => copy.Weight(i)).ToArray(),
            Nearest = Plane.Of(simplex.Nearest),
        };
    }
}

/// <summary>What the plane sees of a vector of space.</summary>
internal static class Plane
{
    public static Vector2 Of(Vector3 v) => new(v.X, v.Y);

    public static Vector2 Of(in Double3 v) => new((float)v.X, (float)v.Y);
}
