namespace Gjk.Core;

/// <summary>The distance of two cores, proved: in double where double can, else in extended precision.</summary>
internal static class ProvedDistance
{
    /// <summary>Runs the solvers from the feature or simplex that the state holds.</summary>
    /// <remarks>A warm start can hold anything, so a contradiction that was found on the way from it may be its own,
    /// and the query begins again without it.</remarks>
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

    /// <summary>How far apart the cores may be before the query may end early; the bands keep its answer that of the
    /// full query.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double CoreReach(float maxDistance, in PairFrame frame) =>
        ShapeReach(maxDistance) / frame.Unit + frame.Margins + GjkTolerances.SeparatedBandCurved * frame.Radius;

    /// <summary>How far apart the shapes may be, in world units.</summary>
    public static double ShapeReach(float maxDistance) =>
        Math.Max(maxDistance, 0.0) * (1 + GjkTolerances.FloatBand) + float.Epsilon;
}
