namespace Gjk.Core;

/// <summary>The distance solver that decides what double cannot. It takes the same walk as <see cref="GjkDistance"/>,
/// with a simplex step of 106 bits that assumes nothing (<see cref="ExtendedFeatureStep"/>).</summary>
/// <remarks>
/// <para>The vertices of A - B are taken as doubles, which lie within a few units in the last place of where they are.
/// Moving vertices by that much moves the distance by no more. On these points the step is as good as exact.</para>
/// <para>It terminates because the distance, compared in 106 bits, falls strictly, or the walk ends. When it ends with
/// the bounds apart, the support function contradicts itself. About one pair in a thousand of the hard families gets
/// here, and none of the ordinary ones. It costs some microseconds.</para>
/// <para>Verdicts are those of <see cref="GjkDistance"/>. Undecided is final here, and means that the iterations ran
/// out.</para>
/// </remarks>
internal static class GjkExtendedPrecision
{
    /// <summary>Decides what <see cref="GjkDistance"/> has left open.</summary>
    /// <remarks>A warm start can hold anything, so a contradiction that was found on the way from it may be its own,
    /// and the query begins again without it.</remarks>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Settle<TA, TB, TTrace>(
        ref TA a, ref TB b, in PairFrame frame, double maxDistance, bool isWarm, ref SolverState state,
        ref TTrace trace)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
        where TTrace : struct, IGjkTrace
    {
        if (state.Verdict == Verdict.Undecided || (isWarm && state.Verdict == Verdict.Contradiction))
            Solve(ref a, ref b, frame, maxDistance, ref state, ref trace);
    }

    /// <summary>Solves from the beginning, in the first direction.</summary>
    [MethodImpl(Jit.AtOnce | MethodImplOptions.NoInlining)]
    public static void Solve<TA, TB, TTrace>(
        ref TA a, ref TB b, in PairFrame frame, double maxDistance, ref SolverState state, ref TTrace trace)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
        where TTrace : struct, IGjkTrace
    {
        int limit = state.Iterations + GjkTolerances.MaxIterations;
        Double3 normal = frame.FirstNormal;
        ClosestFeature feature = default;
        Simplex simplex = default;
        DoubleDouble distanceSquared = default;
        state.Plane.NormalSquared = 0;
        while (true)
        {
            int slot = simplex.FreeSlot;
            int ids = MinkowskiDifference.Support(ref a, ref b, frame, normal, ref simplex.At(slot), out Double3 w);
            state.Iterations++;
            if (state.ChangesTolerances<TA, TB>(ids)) state.Observe(frame, simplex.At(slot));
            if (trace.IsOn) trace.OnSupport(new TracedSupport(frame, normal, simplex.At(slot), isExtended: true));
            double plane = Double3.Dot(normal, w);
            if (simplex.Count > 0 && Ends(ref state, simplex, feature, plane, maxDistance, frame.Margins, limit))
                return;

            Simplex before = simplex;
            simplex.Push(slot);
            bool outside = ExtendedFeatureStep.TryReduce(
                ref simplex, out ClosestFeature next, out DoubleDouble nextSquared);
            if (trace.IsOn) trace.OnReduced(new TracedSimplex(simplex, frame, isExtended: true));
            if (!outside || !((double)nextSquared > state.TouchSquared))
            {
                bool isNumber = !outside || (double)nextSquared >= 0;
                state.Verdict = isNumber ? Verdict.Enclosed : Verdict.Contradiction;
                state.Simplex = simplex;
                state.Feature = next;
                state.Weights = ClosestPointWeights.Of(simplex);
                return;
            }

            if (before.Count > 0 && !((nextSquared - distanceSquared).Sign < 0))
            {
                state.Simplex = before;
                state.Feature = feature;
                state.Weights = ClosestPointWeights.OfFeature(before, feature);
                Proofs.SettleStall(ref state, plane, feature.Height - plane);
                return;
            }

            distanceSquared = nextSquared;
            feature = next;
            normal = feature.Normal;
        }
    }

    /// <summary>Records the newest plane and says whether it settles the query.</summary>
    private static bool Ends(
        ref SolverState state, in Simplex simplex, in ClosestFeature feature, double plane, double maxDistance,
        double margins, int limit)
    {
        double gap = feature.Height - plane;
        state.Simplex = simplex;
        state.Feature = feature;
        if (state.Plane.NormalSquared == 0 || plane / Math.Sqrt(feature.NormalSquared) > state.Plane.Distance)
            state.Plane.Set(feature, plane);

        state.Weights = ClosestPointWeights.OfFeature(simplex, feature);
        if (plane > 0 && plane * plane > maxDistance * maxDistance * feature.NormalSquared)
        {
            state.Verdict = Verdict.Beyond;
            return true;
        }

        if (Proofs.IsClosed(gap, feature, state.IsCurved, state.Noise, margins))
        {
            state.Verdict = Verdict.Apart;
            return true;
        }

        if (!(gap > 0))
        {
            Proofs.SettleStall(ref state, plane, -gap);
            return true;
        }

        state.Verdict = Verdict.Undecided;
        return state.Iterations >= limit;
    }
}
