namespace Gjk.Core;

/// <summary>One of the questions about a pair of shapes: what <see cref="PairQuery"/> runs.</summary>
/// <typeparam name="TResult">The answer's type.</typeparam>
internal interface IPairSolver<TResult> : ICoreSolver
{
    /// <summary>Answers pairs of which a formula knows the answer, before anything is composed.</summary>
    /// <param name="a">The first shape.</param>
    /// <param name="poseA">Its pose in the world.</param>
    /// <param name="b">The second shape.</param>
    /// <param name="poseB">Its pose.</param>
    /// <param name="result">Written where it is to be: each copy of it costs Mono as much as a support.</param>
    bool TryFormula<TA, TB>(ref TA a, in RigidPose poseA, ref TB b, in RigidPose poseB, out TResult result)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap;

    /// <summary>Refuses invalid input, and pairs of which the frame tells all.</summary>
    bool TryBegin<TA, TB>(ref TA a, ref TB b, in RigidPose poseA, ref PairFrame frame, out TResult result)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap;

    /// <summary>Makes the answer of what the solver found.</summary>
    void Finish(
        in SolverState state, in PairFrame frame, in RigidPose poseA, in RigidPose poseB, out TResult result);
}

/// <summary>What is solved for two cores.</summary>
internal interface ICoreSolver
{
    /// <summary>Runs in the frame's units, which are ordinary.</summary>
    void Solve<TA, TB>(ref TA a, ref TB b, ref PairFrame frame, ref SolverState state)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap;
}
