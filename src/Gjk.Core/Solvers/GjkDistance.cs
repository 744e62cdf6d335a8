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
/// Deviations from the textbook. (1) Everything is compared undivided: heights and normals of any length. (2) Where rounding could matter
/// (a distance that stopped falling before the bounds met, an enclosed origin whose determinants are not certain, an enclosed origin after a plane had
/// separated) this solver does not answer; <see cref="GjkExtendedPrecision"/> does. So what leaves here is proved in double.
/// Termination: the distance falls strictly from round to round, or the loop hands over; there are finitely many features. MaxIterations is a backstop.
/// Verdicts: Apart: both bounds met. Enclosed: the origin is inside the tetrahedron, or nearer the feature than rounding can tell. Beyond: a plane
/// is further than asked. Undecided: for the caller to hand over. Contradiction: a support point was NaN, or lay behind one that the same support had given before.
/// </remarks>
internal static class GjkDistance
{
    /// <summary>Runs the loop from <c>state.Feature.Normal</c> (cold), or from <c>state.Simplex</c> when that has vertices (warm).</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static void Solve<TA, TB, TTrace>(
        ref TA a, ref TB b, in PairFrame frame, double maxDistance, ref SolverState state, ref TTrace trace)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
        where TTrace : struct, IGjkTrace
    {
        ref Simplex simplex = ref state.Simplex;
        ref ClosestFeature feature = ref state.Feature;
        double distanceSquared = double.PositiveInfinity;
        if (simplex.Count == 0) feature.NormalSquared = feature.Normal.LengthSquared;
        else if (!TryBegin(ref state, out distanceSquared)) return;

        double touchSquared = state.TouchSquared, noise = state.Noise;
        bool separated = false;
        state.Verdict = Verdict.Undecided;
        while (state.Iterations < GjkTolerances.MaxIterations)
        {
            var normal = new Vector3D(feature.Normal.X, feature.Normal.Y, feature.Normal.Z);
            MinkowskiDifference.Support(ref a, ref b, frame, normal, out int idA, out int idB, out Vector3D onA, out Vector3D onB, out Vector3D w);
            state.Iterations++;
            if (state.Matters<TA, TB>(idA | idB))
            {
                state.See(frame, onA, onB, idA | idB);
                (touchSquared, noise) = (state.TouchSquared, state.Noise);
            }

            if (trace.IsOn) trace.OnSupport(new TracedSupport(frame, normal, onA, w, idA, idB, isExtended: false));
            double plane = Vector3D.Dot(normal, w);
            if (plane > 0)
            {
                separated |= plane * plane > touchSquared * feature.NormalSquared;
                if (plane * plane > maxDistance * maxDistance * feature.NormalSquared)
                {
                    state.Verdict = Verdict.Beyond;
                    state.Plane.Set(feature, plane);
                    return;
                }
            }

            if (simplex.Count != 0 && IsEnd(ref state, plane, noise)) return;

            simplex.Push(w, onA, onB, idA, idB);
            bool isOutside = feature.Reduce(ref simplex);
            if (trace.IsOn) trace.OnReduced(new TracedSimplex(simplex, frame.Unit, isExtended: false));
            if (!isOutside)
            {
                if (!separated) state.Verdict = Proofs.Enclosed(simplex, touchSquared);
                return;
            }

            double before = distanceSquared;
            distanceSquared = feature.DistanceSquared;
            if (!(distanceSquared > touchSquared))
            {
                state.Verdict = Proofs.Touching(simplex, feature, distanceSquared, touchSquared);
                return;
            }

            if (!(distanceSquared < before)) return;
        }
    }

    /// <summary>
    /// Two cores that are points, as those of spheres are (their margins are all of their radii): what the loop would find in its one round, in closed form.
    /// </summary>
    public static void SolvePoints(in PairFrame frame, ref SolverState state)
    {
        state.Simplex.Push(-frame.Translation, default, default, 0, 0);
        state.Iterations = 1;
        state.Feature.Reduce(ref state.Simplex);
        state.Verdict = state.Feature.Height > 0 ? Verdict.Apart : Verdict.Enclosed;
        state.Plane.Set(state.Feature, state.Feature.Height);
    }

    /// <summary>Reduces a warm start's simplex; false when that settles the query already, or leaves it undecided.</summary>
    private static bool TryBegin(ref SolverState state, out double distanceSquared)
    {
        distanceSquared = 0;
        double touchSquared = state.TouchSquared;
        if (!state.Feature.ReduceAny(ref state.Simplex))
        {
            state.Verdict = Proofs.Enclosed(state.Simplex, touchSquared);
            return false;
        }

        distanceSquared = state.Feature.DistanceSquared;
        if (distanceSquared > touchSquared) return true;
        state.Verdict = Proofs.Touching(state.Simplex, state.Feature, distanceSquared, touchSquared);
        return false;
    }

    /// <summary>The bounds have met, or the newest plane lies behind the feature, which no convex shape's can.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static bool IsEnd(ref SolverState state, double plane, double noise)
    {
        double gap = state.Feature.Height - plane;
        if (Proofs.IsClosed(gap, state.Feature, state.IsCurved, noise))
        {
            // The normal of a needle of a triangle can be tilted so far by rounding that its corners no longer are level: then the height of one proves nothing.
            if (state.Simplex.Count == 3 && !state.IsCurved
                && !Proofs.IsLevel(state.Simplex, state.Feature, plane, GjkTolerances.Level * state.Size.Value))
            {
                return true;
            }

            state.Verdict = Verdict.Apart;
            state.Plane.Set(state.Feature, plane);
            return true;
        }

        if (gap > 0) return false;
        Proofs.SettleStall(ref state, plane, -gap);
        return true;
    }
}
