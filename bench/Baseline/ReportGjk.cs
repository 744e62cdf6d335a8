using Gjk.Demo.Trace;

namespace Gjk.Bench.Baseline;

/// <summary>The algorithm of the 2022 report, written from its description. It is the baseline for this library. It
/// computes in float and has the report's faults. Only the report's random first direction is replaced by the
/// difference of the positions, which is faster and repeatable.</summary>
public static class ReportGjk
{
    /// <summary>The most passes through the loop. The report's loop may never end, but a benchmark's loop
    /// must.</summary>
    public const int IterationCap = 32;

    /// <summary>Units squared, absolute as in the report. A new support point must come closer by this much divided by
    /// the distance. This is a tenth of a millimetre on objects a metre in size.</summary>
    public const float ProgressEpsilon = 1e-4f;

    /// <summary>Units squared. If the origin is closer than this, the objects touch. It is the square of float's
    /// rounding error at coordinates near 1.</summary>
    public const float TouchingSquared = 1e-12f;

    public static bool Intersects(SupportCollider a, SupportCollider b)
    {
        Vector3 direction = FirstDirection(a, b);
        var simplex = new List<MinkowskiPoint>();
        for (int i = 0; i < IterationCap; i++)
        {
            MinkowskiPoint next = Support(a, b, direction);
            if (Vector3.Dot(next.W, direction) < 0) return false;
            simplex.Add(next);
            if (TextbookSimplex<MinkowskiPoint>.Reduce(simplex, ref direction)) return true;
        }

        return false;
    }

    public static ReportResult Distance(SupportCollider a, SupportCollider b)
    {
        var simplex = new List<MinkowskiPoint> { Support(a, b, FirstDirection(a, b)) };
        Vector3 closest = ClosestPoint.Find(simplex, out Vector3 pointA, out Vector3 pointB);
        for (int i = 1; i < IterationCap; i++)
        {
            if (closest.LengthSquared() < TouchingSquared) return new ReportResult(true, 0, pointA, pointB, i);
            Vector3 direction = -closest;
            MinkowskiPoint next = Support(a, b, direction);
            if (Vector3.Dot(next.W, direction) - Vector3.Dot(closest, direction) < ProgressEpsilon)
                return new ReportResult(false, closest.Length(), pointA, pointB, i + 1);
            simplex.Add(next);
            if (TextbookSimplex<MinkowskiPoint>.Reduce(simplex, ref direction))
                return new ReportResult(true, 0, pointA, pointB, i + 1);
            closest = ClosestPoint.Find(simplex, out pointA, out pointB);
        }

        return new ReportResult(false, closest.Length(), pointA, pointB, IterationCap);
    }

    private static Vector3 FirstDirection(SupportCollider a, SupportCollider b)
    {
        Vector3 direction = b.Position - a.Position;
        return direction == Vector3.Zero ? Vector3.UnitX : direction;
    }

    private static MinkowskiPoint Support(SupportCollider a, SupportCollider b, Vector3 direction) =>
        new(a.FindFurthestPoint(direction), b.FindFurthestPoint(-direction));
}
