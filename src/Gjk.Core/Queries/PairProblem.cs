using System.Runtime.CompilerServices;

namespace Gjk.Core;

/// <summary>What is asked of a pair of shapes, or of the cores that they are unwrapped to.</summary>
/// <typeparam name="TResult">The answer's type.</typeparam>
internal interface IPairQuestion<TResult>
{
    /// <summary>Asks about the cores.</summary>
    /// <param name="a">The first core.</param>
    /// <param name="poseA">Pose of its shape in the world.</param>
    /// <param name="b">The second core.</param>
    /// <param name="poseB">Pose of its shape.</param>
    /// <param name="placement">Where the cores are in the frames of the shapes.</param>
    /// <param name="result">Written where it is to be: each copy of it costs Mono as much as a support.</param>
    void Ask<TA, TB>(
        ref TA a, in RigidPose poseA, ref TB b, in RigidPose poseB, in PairPlacement placement, out TResult result)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap;
}

/// <summary>A question that one run of a solver answers.</summary>
/// <typeparam name="TFinding">What the solver finds.</typeparam>
/// <typeparam name="TResult">The answer's type.</typeparam>
internal interface IPairProblem<TFinding, TResult> : IPairQuestion<TResult>
{
    /// <summary>Whether its limits and motions are valid.</summary>
    bool IsValid { get; }

    /// <summary>The answer to invalid input.</summary>
    void Refuse(out TResult result);

    /// <summary>Runs the solver in the frame's units, which are ordinary.</summary>
    void Solve<TA, TB>(ref TA a, ref TB b, ref PairFrame frame, out TFinding finding)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap;

    /// <summary>Makes the answer of what the solver found.</summary>
    void Finish(
        in TFinding finding, in PairFrame frame, in RigidPose poseA, in RigidPose poseB, out TResult result);
}

/// <summary>
/// The pipeline of all questions about a pair: compose the frame, refuse invalid input, go to unit size where lengths
/// would leave the range of double, solve, finish.
/// </summary>
internal static class PairProblem
{
    /// <summary>
    /// A reference to a readonly argument, so that calls on it make no copies; nothing writes through it but a shape's
    /// own mistakes.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
#if NET
    public static ref T Inward<T>(in T shape)
        where T : struct =>
        ref Unsafe.AsRef(in shape);
#else
    public static unsafe ref T Inward<T>(in T shape)
        where T : struct
    {
#pragma warning disable CS8500 // The pointer is a reference again before the garbage collector may move the shape.
        fixed (T* same = &shape) return ref *same;
#pragma warning restore CS8500
    }
#endif

    /// <summary>Asks about shapes as they are, for what the question is told on the way.</summary>
    public static void Ask<TA, TB, TQuestion, TResult>(
        ref TA a, in RigidPose poseA, ref TB b, in RigidPose poseB, ref TQuestion question)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
        where TQuestion : struct, IPairQuestion<TResult> =>
        question.Ask(ref a, poseA, ref b, poseB, PairPlacement.None, out _);

    /// <summary>Composes, refuses, solves and finishes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe void Answer<TA, TB, TProblem, TFinding, TResult>(
        ref TA a, in RigidPose poseA, ref TB b, in RigidPose poseB, in PairPlacement placement, ref TProblem problem,
        out TResult result)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
        where TProblem : struct, IPairProblem<TFinding, TResult>
        where TFinding : unmanaged
    {
#if NET
        Uncleared.Begin(out PairFrame frame);
        Uncleared.Begin(out TFinding finding);
#else
        // Mono clears locals, a kilobyte of them, but not what is allocated.
        byte* memory = stackalloc byte[sizeof(PairFrame) + sizeof(TFinding)];
        ref PairFrame frame = ref *(PairFrame*)memory;
        ref TFinding finding = ref *(TFinding*)(memory + sizeof(PairFrame));
#endif
        PairFrame.Compose(ref a, poseA, ref b, poseB, placement, out frame);
        if (!frame.IsValid || !problem.IsValid)
        {
            problem.Refuse(out result);
            return;
        }

        Solve<TA, TB, TProblem, TFinding, TResult>(ref a, ref b, ref frame, ref problem, out finding);
        problem.Finish(finding, frame, poseA, poseB, out result);
    }

    /// <summary>Solves a valid frame, in its own units or in others.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Solve<TA, TB, TProblem, TFinding, TResult>(
        ref TA a, ref TB b, ref PairFrame frame, ref TProblem problem, out TFinding finding)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
        where TProblem : struct, IPairProblem<TFinding, TResult>
    {
        if (frame.IsOrdinary) problem.Solve(ref a, ref b, ref frame, out finding);
        else SolveInUnitSize<TA, TB, TProblem, TFinding, TResult>(ref a, ref b, ref frame, ref problem, out finding);
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void SolveInUnitSize<TA, TB, TProblem, TFinding, TResult>(
        ref TA a, ref TB b, ref PairFrame frame, ref TProblem problem, out TFinding finding)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
        where TProblem : struct, IPairProblem<TFinding, TResult>
    {
        frame.TightenRadii(ref a, ref b);
        double factor = frame.UnitFactor;
        frame.ToUnitSize(factor);
        var unitA = new UnitSized<TA>(a, factor);
        var unitB = new UnitSized<TB>(b, factor);
        problem.Solve(ref unitA, ref unitB, ref frame, out finding);
    }
}
