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
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static void Solve<TA, TB, TTrace>(
        ref TA a, ref TB b, in RelativePose bInA, double maxDistance, ref GjkOutcome outcome, ref TTrace trace)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
        where TTrace : struct, IGjkTrace
    {
        double noise = GjkTolerances.Noise * bInA.Radius, touchSquared = Square(GjkTolerances.Touch * bInA.Radius);
        ref Simplex simplex = ref outcome.Simplex;
        ref ClosestFeature feature = ref outcome.Feature;
        double distanceSquared = double.PositiveInfinity;
        if (simplex.Count == 0) feature.NormalSquared = feature.Normal.LengthSquared;
        else if (!TryBegin(ref outcome, touchSquared, out distanceSquared)) return;

        bool separated = false;
        int idA = -1, idB = -1;
        outcome.Status = GjkStatus.IterationLimit;
        while (outcome.Iterations < GjkTolerances.MaxIterations)
        {
            var normal = new Vector3D(feature.Normal.X, feature.Normal.Y, feature.Normal.Z);
            MinkowskiDifference.Support(ref a, ref b, bInA, normal, ref idA, ref idB, out Vector3D onA, out Vector3D w);
            outcome.Iterations++;
            if (trace.IsOn) trace.OnSupport(new TracedSupport(bInA, normal, onA, w, idA, idB, isExtended: false));
            double plane = Vector3D.Dot(normal, w);
            if (plane > 0)
            {
                separated |= plane * plane > touchSquared * feature.NormalSquared;
                if (plane * plane > maxDistance * maxDistance * feature.NormalSquared)
                {
                    outcome.Status = GjkStatus.BeyondMaxDistance;
                    SetPlane(ref outcome, feature, plane);
                    return;
                }
            }

            if (simplex.Count != 0 && IsEnd(ref outcome, plane, (idA | idB) < 0, noise, bInA.Radius)) return;

            simplex.Push(w, onA, idA, idB);
            bool isOutside = feature.Reduce(ref simplex);
            if (trace.IsOn) trace.OnReduced(new TracedSimplex(simplex, isExtended: false));
            if (!isOutside)
            {
                if (!separated && (IsCertainlyInside(simplex) || HoldsPointNear(simplex, touchSquared))) outcome.Status = GjkStatus.Overlapping;
                return;
            }

            double before = distanceSquared;
            distanceSquared = feature.DistanceSquared;
            if (!(distanceSquared > touchSquared))
            {
                outcome.Status = Touching(simplex, feature, distanceSquared, touchSquared);
                return;
            }

            if (!(distanceSquared < before)) return;
        }
    }

    /// <summary>Two cores that are points, as those of spheres are (their margins are all of their radii): what the loop would find in its one round, in closed form.</summary>
    public static void SolvePoints(in RelativePose bInA, ref GjkOutcome outcome)
    {
        Vector3D w = -bInA.Translation;
        outcome.Simplex.Push(w, default, 0, 0);
        outcome.Iterations = 1;
        outcome.Feature.Reduce(ref outcome.Simplex);
        outcome.Status = outcome.Feature.Height > 0 ? GjkStatus.Separated : GjkStatus.Overlapping;
        SetPlane(ref outcome, outcome.Feature, outcome.Feature.Height);
    }

    /// <summary>Reduces a warm start's simplex; false when that settles the query already, or leaves it undecided.</summary>
    private static bool TryBegin(ref GjkOutcome outcome, double touchSquared, out double distanceSquared)
    {
        distanceSquared = 0;
        if (!outcome.Feature.ReduceAny(ref outcome.Simplex))
        {
            bool overlaps = IsCertainlyInside(outcome.Simplex) || HoldsPointNear(outcome.Simplex, touchSquared);
            outcome.Status = overlaps ? GjkStatus.Overlapping : GjkStatus.IterationLimit;
            return false;
        }

        distanceSquared = outcome.Feature.DistanceSquared;
        if (distanceSquared > touchSquared) return true;
        outcome.Status = Touching(outcome.Simplex, outcome.Feature, distanceSquared, touchSquared);
        return false;
    }

    /// <summary>
    /// The feature seems no further than rounding can tell from contact. The normal of a needle of a triangle may be rounding itself, and then its height says nothing, so a point of
    /// the feature must prove it. A distance that is NaN for another reason than a height of 0 over 0 comes from a shape.
    /// </summary>
    private static GjkStatus Touching(in Simplex simplex, in ClosestFeature feature, double distanceSquared, double touchSquared)
    {
        if (!(feature.Height == 0 || distanceSquared >= 0)) return GjkStatus.InvalidShape;
        return HoldsPointNear(simplex, touchSquared) ? GjkStatus.Overlapping : GjkStatus.IterationLimit;
    }

    /// <summary>The bounds have met, or the newest plane lies behind the feature, which no convex shape's can.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static bool IsEnd(ref GjkOutcome outcome, double plane, bool curved, double noise, double radius)
    {
        double gap = outcome.Feature.Height - plane;
        if (IsClosed(gap, outcome.Feature, curved, curved ? GjkTolerances.NoiseCurved * radius : noise))
        {
            // The normal of a needle of a triangle can be tilted so far by rounding that its corners no longer are level: then the height of one proves nothing.
            if (outcome.Simplex.Count == 3 && !IsLevel(outcome.Simplex, outcome.Feature, plane, curved, GjkTolerances.Level * radius))
            {
                outcome.Status = GjkStatus.IterationLimit;
                return true;
            }

            outcome.Status = GjkStatus.Separated;
            SetPlane(ref outcome, outcome.Feature, plane);
            return true;
        }

        if (gap > 0) return false;
        SettleStall(ref outcome, outcome.Feature, plane, -gap, radius);
        return true;
    }

    /// <summary>The other two corners of a triangle lie no further above the plane than the bounds may be apart.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static bool IsLevel(in Simplex simplex, in ClosestFeature feature, double plane, bool curved, double level)
    {
        double b = Vector3D.Dot(feature.Normal, simplex.WB) - plane, c = Vector3D.Dot(feature.Normal, simplex.WC) - plane;
        return curved || (IsClosed(b, feature, false, level) && IsClosed(c, feature, false, level));
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
        Vector3D a = simplex.WA, b = simplex.WB, c = simplex.WC, d = simplex.WD;
        if (Vector3D.Dot(Vector3D.Cross(b - a, c - a), a) > 0) (b, c) = (c, b);
        return IsCertain(a, b - a, c - a) && IsCertain(a, c - a, d - a) && IsCertain(a, d - a, b - a) && IsCertain(-b, c - b, d - b);
    }

    /// <summary>
    /// A point of the simplex, worked out from its weights, is as near the origin as touching asks: what a sign leaves open where the origin lies on a
    /// face or an edge, as it does for flush boxes, the weights can still prove.
    /// </summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static bool HoldsPointNear(in Simplex simplex, double touchSquared)
    {
        Weights w = ClosestPointWeights.Of(simplex);
        return w.PointOf(simplex.WA, simplex.WB, simplex.WC, simplex.WD).LengthSquared <= touchSquared;
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
        outcome.PlaneNormal = new Vector3D(feature.Normal.X, feature.Normal.Y, feature.Normal.Z);
        outcome.PlaneNormalSquared = feature.NormalSquared;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double Square(double x) => x * x;
}
