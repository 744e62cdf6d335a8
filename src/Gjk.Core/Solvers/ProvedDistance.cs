using System.Runtime.CompilerServices;

namespace Gjk.Core;

/// <summary>The distance of two cores, proved: in double where double can, else in extended precision.</summary>
internal static class ProvedDistance
{
    /// <summary>Runs the solvers from the feature or simplex that the state holds.</summary>
    /// <remarks>
    /// A warm start can hold anything, so a contradiction that was found on the way from it may be its own, and the
    /// query begins again without it.
    /// </remarks>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Solve<TA, TB, TTrace>(
        ref TA a, ref TB b, in PairFrame frame, double maxDistance, bool isWarm, ref SolverState state,
        ref TTrace trace)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
        where TTrace : struct, IGjkTrace
    {
        GjkDistance.Solve(ref a, ref b, frame, maxDistance, ref state, ref trace);
        if (state.Verdict == Verdict.Undecided || (isWarm && state.Verdict == Verdict.Contradiction))
            GjkExtendedPrecision.Solve(ref a, ref b, frame, maxDistance, ref state, ref trace);
    }
}
