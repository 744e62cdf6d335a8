#if NET
using System.Runtime.CompilerServices;

namespace Gjk.Core;

/// <remarks>
/// Pairs of known cores. Each pair has a method of its own, whose frame holds no more than these two: a method that
/// held all of them would clear and copy them all.
/// </remarks>
public static partial class ConvexQuery
{
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static DistanceResult AskByKind<TA, TB, TTrace>(
        ref TA a, in RigidPose poseA, ref TB b, in RigidPose poseB, float maxDistance, ref WarmStart warmStart,
        bool isWarm, ref TTrace trace)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
        where TTrace : struct, IGjkTrace
    {
        // Two capsules of that type have a cheaper support than segments: a sign.
        if (typeof(TA) == typeof(CapsuleShape) && typeof(TB) == typeof(CapsuleShape))
            return AskCores(ref a, poseA, ref b, poseB, maxDistance, ref warmStart, isWarm, ref trace);
        return PairDispatch.KindOf(ref a) switch
        {
            CoreKind.Box => AskByKind<TA, TB, BoxCore, TTrace>(
                ref a, poseA, ref b, poseB, maxDistance, ref warmStart, isWarm, ref trace),
            CoreKind.Hull => AskByKind<TA, TB, HullCore, TTrace>(
                ref a, poseA, ref b, poseB, maxDistance, ref warmStart, isWarm, ref trace),
            CoreKind.Segment => AskByKind<TA, TB, SegmentCore, TTrace>(
                ref a, poseA, ref b, poseB, maxDistance, ref warmStart, isWarm, ref trace),
            CoreKind.Triangle => AskByKind<TA, TB, TriangleCore, TTrace>(
                ref a, poseA, ref b, poseB, maxDistance, ref warmStart, isWarm, ref trace),
            _ => AskCores(ref a, poseA, ref b, poseB, maxDistance, ref warmStart, isWarm, ref trace),
        };
    }

    /// <summary>The same where the first core is known.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static DistanceResult AskByKind<TA, TB, TCoreA, TTrace>(
        ref TA a, in RigidPose poseA, ref TB b, in RigidPose poseB, float maxDistance, ref WarmStart warmStart,
        bool isWarm, ref TTrace trace)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
        where TCoreA : struct, ISupportMap
        where TTrace : struct, IGjkTrace =>
        PairDispatch.KindOf(ref b) switch
        {
            CoreKind.Box => AskAs<TA, TB, TCoreA, BoxCore, TTrace>(
                ref a, poseA, ref b, poseB, maxDistance, ref warmStart, isWarm, ref trace),
            CoreKind.Hull => AskAs<TA, TB, TCoreA, HullCore, TTrace>(
                ref a, poseA, ref b, poseB, maxDistance, ref warmStart, isWarm, ref trace),
            CoreKind.Segment => AskAs<TA, TB, TCoreA, SegmentCore, TTrace>(
                ref a, poseA, ref b, poseB, maxDistance, ref warmStart, isWarm, ref trace),
            CoreKind.Triangle => AskAs<TA, TB, TCoreA, TriangleCore, TTrace>(
                ref a, poseA, ref b, poseB, maxDistance, ref warmStart, isWarm, ref trace),
            _ => AskCores(ref a, poseA, ref b, poseB, maxDistance, ref warmStart, isWarm, ref trace),
        };

    [MethodImpl(MethodImplOptions.NoInlining)]
    private static DistanceResult AskAs<TA, TB, TCoreA, TCoreB, TTrace>(
        ref TA a, in RigidPose poseA, ref TB b, in RigidPose poseB, float maxDistance, ref WarmStart warmStart,
        bool isWarm, ref TTrace trace)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
        where TCoreA : struct, ISupportMap
        where TCoreB : struct, ISupportMap
        where TTrace : struct, IGjkTrace
    {
        PairDispatch.Get(ref a, out TCoreA coreA);
        PairDispatch.Get(ref b, out TCoreB coreB);
        return AskCores(ref coreA, poseA, ref coreB, poseB, maxDistance, ref warmStart, isWarm, ref trace);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static GjkStatus StatusByKind<TA, TB>(ref TA a, in RigidPose poseA, ref TB b, in RigidPose poseB)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap =>
        PairDispatch.KindOf(ref a) switch
        {
            CoreKind.Box => StatusByKind<TA, TB, BoxCore>(ref a, poseA, ref b, poseB),
            CoreKind.Hull => StatusByKind<TA, TB, HullCore>(ref a, poseA, ref b, poseB),
            CoreKind.Segment => StatusByKind<TA, TB, SegmentCore>(ref a, poseA, ref b, poseB),
            CoreKind.Triangle => StatusByKind<TA, TB, TriangleCore>(ref a, poseA, ref b, poseB),
            _ => StatusOfCores(ref a, poseA, ref b, poseB),
        };

    /// <summary>The same where the first core is known.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static GjkStatus StatusByKind<TA, TB, TCoreA>(ref TA a, in RigidPose poseA, ref TB b, in RigidPose poseB)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
        where TCoreA : struct, ISupportMap =>
        PairDispatch.KindOf(ref b) switch
        {
            CoreKind.Box => StatusAs<TA, TB, TCoreA, BoxCore>(ref a, poseA, ref b, poseB),
            CoreKind.Hull => StatusAs<TA, TB, TCoreA, HullCore>(ref a, poseA, ref b, poseB),
            CoreKind.Segment => StatusAs<TA, TB, TCoreA, SegmentCore>(ref a, poseA, ref b, poseB),
            CoreKind.Triangle => StatusAs<TA, TB, TCoreA, TriangleCore>(ref a, poseA, ref b, poseB),
            _ => StatusOfCores(ref a, poseA, ref b, poseB),
        };

    [MethodImpl(MethodImplOptions.NoInlining)]
    private static GjkStatus StatusAs<TA, TB, TCoreA, TCoreB>(
        ref TA a, in RigidPose poseA, ref TB b, in RigidPose poseB)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
        where TCoreA : struct, ISupportMap
        where TCoreB : struct, ISupportMap
    {
        PairDispatch.Get(ref a, out TCoreA coreA);
        PairDispatch.Get(ref b, out TCoreB coreB);
        return StatusOfCores(ref coreA, poseA, ref coreB, poseB);
    }
}
#endif
