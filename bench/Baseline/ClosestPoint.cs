using Gjk.Demo.Trace;

namespace Gjk.Bench.Baseline;

/// <summary>Finds the point of a vertex, line or triangle that is closest to the origin. Its weights give the points of
/// both colliders, too.</summary>
internal static class ClosestPoint
{
    public static Vector3 Find(List<MinkowskiPoint> simplex, out Vector3 pointA, out Vector3 pointB)
    {
        if (simplex.Count == 1)
        {
            pointA = simplex[0].OnA;
            pointB = simplex[0].OnB;
            return simplex[0].W;
        }

        Vector3 weights = TextbookClosestPoint.Weights(simplex);
        MinkowskiPoint a = simplex[0], b = simplex[1], c = simplex[simplex.Count - 1];
        pointA = weights.X * a.OnA + weights.Y * b.OnA + weights.Z * c.OnA;
        pointB = weights.X * a.OnB + weights.Y * b.OnB + weights.Z * c.OnB;
        return weights.X * a.W + weights.Y * b.W + weights.Z * c.W;
    }
}
