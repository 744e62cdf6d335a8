namespace Gjk.Core.Tests.Support;

/// <summary>Answers with some of their fields changed.</summary>
internal static class ChangedAnswer
{
    public static DistanceResult With(
        this in DistanceResult r, GjkStatus? status = null, float? distance = null, float? bound = null,
        Vector3? pointA = null, Vector3? pointB = null, Vector3? normal = null, Vector3? localA = null,
        Vector3? localB = null) =>
        new(
            status ?? r.Status, distance ?? r.Distance, bound ?? r.LowerBound, pointA ?? r.PointA, pointB ?? r.PointB,
            normal ?? r.Normal, localA ?? r.LocalPointA, localB ?? r.LocalPointB, r.Iterations);

    public static CastResult With(
        this in CastResult r, CastStatus? status = null, float? fraction = null, Vector3? point = null,
        Vector3? normal = null, float? depth = null) =>
        new(
            status ?? r.Status, fraction ?? r.Fraction, point ?? r.Point, normal ?? r.Normal, r.Iterations,
            depth ?? r.Depth);
}
