using System;
using System.Runtime.CompilerServices;

namespace Gjk.Core;

/// <summary>
/// GJK's distance algorithm (Gilbert, Johnson and Keerthi 1988; the geometric formulation of Muratori 2006): walk over features of
/// the Minkowski difference A - B, each nearer the origin than the last, until a support plane proves that none is nearer.
/// </summary>
/// <remarks>
/// Each round asks for the vertex w furthest against the current feature's normal n. The plane n·x = n·w holds the whole difference on its far side, so n·w / |n| bounds
/// the distance from below, and the feature itself from above: when the two meet, the answer is proved. Otherwise w joins the simplex, which is
/// reduced to its feature nearest the origin.
/// Deviations from the textbook. (1) Everything is compared undivided: heights and normals of any length. (2) Rounding is not argued away: where it could matter
/// (a distance that stopped falling before the bounds met, an enclosed origin whose determinants are not certain, an enclosed origin after a plane had
/// separated) this solver does not answer; <see cref="GjkExtendedPrecision"/> does. So what leaves here is proved in double.
/// Termination: the distance falls strictly from round to round, or the loop hands over; there are finitely many features. MaxIterations is a backstop.
/// Statuses: Separated: both bounds met. Overlapping: the origin is inside the tetrahedron, or nearer the feature than rounding can tell. BeyondMaxDistance: a plane
/// is further than asked. IterationLimit: undecided, for the caller to hand over. InvalidShape: a support point was NaN, or lay behind one that the same support had given before.
/// </remarks>
internal static class GjkDistance
{
    /// <summary>Runs the loop from <c>outcome.Feature.Normal</c> (cold), or from <c>outcome.Simplex</c> when that has vertices (warm).</summary>
    public static void Solve<TA, TB>(ref TA a, ref TB b, in RelativePose bInA, double maxDistance, ref GjkOutcome outcome)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        double noise = GjkTolerances.Noise * bInA.Radius, touchSquared = Square(GjkTolerances.Touch * bInA.Radius);
        ref Simplex simplex = ref outcome.Simplex;
        MinkowskiVertex vertex = default;
        vertex.IdA = vertex.IdB = -1;
        ClosestFeature feature = outcome.Feature;
        if (simplex.Count == 0)
        {
            outcome.Iterations = 1;
            MinkowskiDifference.Support(ref a, ref b, bInA, feature.Normal, ref vertex);
            simplex.Push(vertex);
            feature.Vertex(ref simplex);
        }
        else if (!feature.ReduceAny(ref simplex))
        {
            outcome.Status = IsCertainlyInside(simplex) ? GjkStatus.Overlapping : GjkStatus.IterationLimit;
            return;
        }

        bool separated = false;
        double distanceSquared = feature.DistanceSquared;
        outcome.Status = GjkStatus.IterationLimit;
        while (outcome.Iterations < GjkTolerances.MaxIterations)
        {
            if (!(distanceSquared > touchSquared))
            {
                outcome.Status = feature.Height == 0 || distanceSquared >= 0 ? GjkStatus.Overlapping : GjkStatus.InvalidShape;
                break;
            }

            MinkowskiDifference.Support(ref a, ref b, bInA, feature.Normal, ref vertex);
            outcome.Iterations++;
            double plane = Vector3D.Dot(feature.Normal, vertex.W);
            if (plane > 0)
            {
                separated |= plane * plane > touchSquared * feature.NormalSquared;
                if (plane * plane > maxDistance * maxDistance * feature.NormalSquared)
                {
                    outcome.Status = GjkStatus.BeyondMaxDistance;
                    SetPlane(ref outcome, feature, plane);
                    break;
                }
            }

            bool curved = (vertex.IdA | vertex.IdB) < 0;
            double gap = feature.Height - plane;
            if (IsClosed(gap, feature, curved, curved ? GjkTolerances.NoiseCurved * bInA.Radius : noise))
            {
                outcome.Status = GjkStatus.Separated;
                SetPlane(ref outcome, feature, plane);
                break;
            }

            if (!(gap > 0))
            {
                SettleStall(ref outcome, feature, plane, -gap, bInA.Radius);
                break;
            }

            simplex.Push(vertex);
            if (!feature.Reduce(ref simplex))
            {
                if (!separated && IsCertainlyInside(simplex)) outcome.Status = GjkStatus.Overlapping;
                break;
            }

            double before = distanceSquared;
            distanceSquared = feature.DistanceSquared;
            if (!(distanceSquared < before)) break;
        }

        outcome.Feature = feature;
    }

    /// <summary>The gap between the feature and the plane is nothing beside the distance, or beside what rounding does.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool IsClosed(double gap, in ClosestFeature feature, bool curved, double noise)
    {
        double ratio = curved ? GjkTolerances.RelativeGapCurved : GjkTolerances.RelativeGap;
        return Math.Abs(gap) <= ratio * feature.Height || gap * gap <= noise * noise * feature.NormalSquared;
    }

    /// <summary>The origin lies inside each of the three faces at A, and BCD's plane beyond it, by more than rounding could turn; either way round.</summary>
    internal static bool IsCertainlyInside(in Simplex simplex)
    {
        Vector3D a = simplex.A.W, b = simplex.B.W, c = simplex.C.W, d = simplex.D.W;
        if (Vector3D.Dot(Vector3D.Cross(b - a, c - a), a) > 0) (b, c) = (c, b);
        return IsCertain(a, b - a, c - a) && IsCertain(a, c - a, d - a) && IsCertain(a, d - a, b - a) && IsCertain(-b, c - b, d - b);
    }

    private static bool IsCertain(in Vector3D a, in Vector3D e, in Vector3D f)
    {
        double determinant = -Vector3D.Dot(Vector3D.Cross(e, f), a);
        return determinant > 0 && determinant * determinant > Square(GjkTolerances.DeterminantError) * a.LengthSquared * e.LengthSquared * f.LengthSquared;
    }

    /// <summary>
    /// The shapes' supports disagree by the gap. A small one is the support's own rounding (one that computes in float, say): the feature stands, and the plane says how
    /// far to trust it. A large one, or NaN, is no convex shape.
    /// </summary>
    public static void SettleStall(ref GjkOutcome outcome, in ClosestFeature feature, double plane, double gap, double radius)
    {
        bool small = gap * gap <= Square(GjkTolerances.Contradiction * radius) * feature.NormalSquared;
        outcome.Status = small ? GjkStatus.Separated : GjkStatus.InvalidShape;
        SetPlane(ref outcome, feature, Math.Min(plane, feature.Height));
    }

    public static void SetPlane(ref GjkOutcome outcome, in ClosestFeature feature, double plane)
    {
        outcome.PlaneValue = plane;
        outcome.PlaneNormal = feature.Normal;
        outcome.PlaneNormalSquared = feature.NormalSquared;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double Square(double x) => x * x;
}
