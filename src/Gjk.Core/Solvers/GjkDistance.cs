using System.Runtime.CompilerServices;

namespace Gjk.Core;

/// <summary>
/// GJK's distance algorithm (Gilbert, Johnson and Keerthi 1988, in the geometric form of Muratori 2006). It walks over
/// features of the Minkowski difference A - B, each nearer the origin than the last, until a support plane proves that
/// none is nearer.
/// </summary>
/// <remarks>
/// <para>
/// Each round asks for the vertex w that is furthest against the current feature's normal n. The whole difference lies
/// beyond the plane n·x = n·w, so n·w / |n| is a lower bound of the distance, and the feature itself is an upper bound.
/// When the two meet, the answer is proved. Otherwise w joins the simplex, which is reduced to its feature nearest the
/// origin.
/// </para>
/// <para>
/// Two things differ from the textbook. Nothing is divided: heights are compared with normals of any length. And where
/// rounding could turn the answer, this solver leaves the verdict open and <see cref="GjkExtendedPrecision"/> decides:
/// when the distance stops falling before the bounds meet, when the origin is enclosed but the determinants are not
/// certain, and when it is enclosed after a plane had separated. So what is decided here is proved in double.
/// </para>
/// <para>
/// It terminates because the distance falls strictly from round to round, or the loop hands over, and there are
/// finitely many features. MaxIterations is a backstop.
/// </para>
/// <para>
/// Verdicts. Apart: both bounds met. Enclosed: the origin is inside the tetrahedron, or nearer the feature than
/// rounding can tell. Beyond: a plane is further than asked. Undecided: the caller is to hand over. Contradiction: a
/// support point was NaN, or lay behind one that the same support had given before.
/// </para>
/// </remarks>
internal static class GjkDistance
{
    /// <summary>
    /// Runs the loop from <c>state.Feature.Normal</c> (cold), or from <c>state.Simplex</c> when that has vertices
    /// (warm).
    /// </summary>
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
            MinkowskiDifference.Support(
                ref a, ref b, frame, normal, out int idA, out int idB, out Vector3D onA, out Vector3D onB,
                out Vector3D w);
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
            bool isOutside = ClosestFeatureStep.Reduce(ref simplex, ref feature);
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
    /// Two cores that are points, as those of spheres are (their margins are all of their radii): what the loop would
    /// find in its one round, in closed form.
    /// </summary>
    public static void SolvePoints(in PairFrame frame, ref SolverState state)
    {
        state.Simplex.Push(-frame.Translation, default, default, 0, 0);
        state.Iterations = 1;
        ClosestFeatureStep.Reduce(ref state.Simplex, ref state.Feature);
        state.Verdict = state.Feature.Height > 0 ? Verdict.Apart : Verdict.Enclosed;
        state.Plane.Set(state.Feature, state.Feature.Height);
    }

    /// <summary>
    /// Reduces a warm start's simplex; false when that settles the query already, or leaves it undecided.
    /// </summary>
    private static bool TryBegin(ref SolverState state, out double distanceSquared)
    {
        distanceSquared = 0;
        double touchSquared = state.TouchSquared;
        if (!ClosestFeatureStep.ReduceAny(ref state.Simplex, ref state.Feature))
        {
            state.Verdict = Proofs.Enclosed(state.Simplex, touchSquared);
            return false;
        }

        distanceSquared = state.Feature.DistanceSquared;
        if (distanceSquared > touchSquared) return true;
        state.Verdict = Proofs.Touching(state.Simplex, state.Feature, distanceSquared, touchSquared);
        return false;
    }

    /// <summary>
    /// The bounds have met, or the newest plane lies behind the feature, which no convex shape's can.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static bool IsEnd(ref SolverState state, double plane, double noise)
    {
        double gap = state.Feature.Height - plane;
        if (Proofs.IsClosed(gap, state.Feature, state.IsCurved, noise))
        {
            // The normal of a needle of a triangle can be tilted so far by rounding that its corners no longer are
            // level: then the height of one proves nothing.
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
