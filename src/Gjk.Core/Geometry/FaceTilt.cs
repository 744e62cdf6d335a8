namespace Gjk.Core;

/// <summary>Which faces and edges lie level enough across a direction to carry contact points.</summary>
internal static unsafe class FaceTilt
{
    /// <summary>Cosine and sine: a face's normal may be 60 degrees off the direction, an edge may rise by 30 degrees.
    /// Steeper ones leave within a maximal gap hardly more than the deepest point, and their heights are ill
    /// conditioned. Pinned by ContactTests.</summary>
    public const double LeastCosine = 0.5, MostSine = 0.5;

    /// <summary>Ratio: one over that cosine, and a little for rounding.</summary>
    public const double MostSecant = 2.0001;

    /// <summary>Whether a face lies level enough.</summary>
    /// <param name="normal">Outward, of any length.</param>
    /// <param name="direction">Of any length.</param>
    public static bool IsLevelFace(in Double3 normal, in Double3 direction)
    {
        double along = Double3.Dot(normal, direction);
        return along > 0 && along * along >= LeastCosine * LeastCosine * normal.LengthSquared * direction.LengthSquared;
    }

    /// <summary>Whether a face lies level enough as it is seen from outside.</summary>
    /// <param name="normal">Outward, of any length.</param>
    /// <param name="direction">Of any length.</param>
    /// <param name="corners">Which know how the face is seen.</param>
    public static bool IsLevelFace(in Double3 normal, in Double3 direction, in FaceCorners corners) =>
        corners.Outer == null ? IsLevelFace(normal, direction) : corners.Outer->Cosine(normal) >= LeastCosine;

    /// <summary>How steep an edge is, for comparing: the sine, infinite for an edge without length.</summary>
    /// <param name="edge">Of any length.</param>
    /// <param name="direction">Of one length for all that are compared.</param>
    public static double Rise(in Double3 edge, in Double3 direction)
    {
        double length = edge.Length;
        return length > 0 ? Math.Abs(Double3.Dot(edge, direction)) / length : double.PositiveInfinity;
    }

    /// <summary>Whether an edge lies level enough; one without length does not.</summary>
    /// <param name="edge">Of any length.</param>
    /// <param name="direction">Of any length.</param>
    public static bool IsLevelEdge(in Double3 edge, in Double3 direction)
    {
        double rise = Double3.Dot(edge, direction), squared = edge.LengthSquared * direction.LengthSquared;
        return squared > 0 && rise * rise <= MostSine * MostSine * squared;
    }
}
