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
        switch ((PairDispatch.KindOf(ref a), PairDispatch.KindOf(ref b)))
        {
            case (CoreKind.Box, CoreKind.Box):
                return AskAs<TA, TB, BoxCore, BoxCore, TTrace>(
                    ref a, poseA, ref b, poseB, maxDistance, ref warmStart, isWarm, ref trace);
            case (CoreKind.Box, CoreKind.Hull):
                return AskAs<TA, TB, BoxCore, HullCore, TTrace>(
                    ref a, poseA, ref b, poseB, maxDistance, ref warmStart, isWarm, ref trace);
            case (CoreKind.Box, CoreKind.Segment):
                return AskAs<TA, TB, BoxCore, SegmentCore, TTrace>(
                    ref a, poseA, ref b, poseB, maxDistance, ref warmStart, isWarm, ref trace);
            case (CoreKind.Hull, CoreKind.Box):
                return AskAs<TA, TB, HullCore, BoxCore, TTrace>(
                    ref a, poseA, ref b, poseB, maxDistance, ref warmStart, isWarm, ref trace);
            case (CoreKind.Hull, CoreKind.Hull):
                return AskAs<TA, TB, HullCore, HullCore, TTrace>(
                    ref a, poseA, ref b, poseB, maxDistance, ref warmStart, isWarm, ref trace);
            case (CoreKind.Hull, CoreKind.Segment):
                return AskAs<TA, TB, HullCore, SegmentCore, TTrace>(
                    ref a, poseA, ref b, poseB, maxDistance, ref warmStart, isWarm, ref trace);
            case (CoreKind.Segment, CoreKind.Box):
                return AskAs<TA, TB, SegmentCore, BoxCore, TTrace>(
                    ref a, poseA, ref b, poseB, maxDistance, ref warmStart, isWarm, ref trace);
            case (CoreKind.Segment, CoreKind.Hull):
                return AskAs<TA, TB, SegmentCore, HullCore, TTrace>(
                    ref a, poseA, ref b, poseB, maxDistance, ref warmStart, isWarm, ref trace);
            case (CoreKind.Segment, CoreKind.Segment):
                return AskAs<TA, TB, SegmentCore, SegmentCore, TTrace>(
                    ref a, poseA, ref b, poseB, maxDistance, ref warmStart, isWarm, ref trace);
            default:
                return AskCores(ref a, poseA, ref b, poseB, maxDistance, ref warmStart, isWarm, ref trace);
        }
    }

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
        where TB : struct, ISupportMap
    {
        switch ((PairDispatch.KindOf(ref a), PairDispatch.KindOf(ref b)))
        {
            case (CoreKind.Box, CoreKind.Box):
                return StatusAs<TA, TB, BoxCore, BoxCore>(ref a, poseA, ref b, poseB);
            case (CoreKind.Box, CoreKind.Hull):
                return StatusAs<TA, TB, BoxCore, HullCore>(ref a, poseA, ref b, poseB);
            case (CoreKind.Box, CoreKind.Segment):
                return StatusAs<TA, TB, BoxCore, SegmentCore>(ref a, poseA, ref b, poseB);
            case (CoreKind.Hull, CoreKind.Box):
                return StatusAs<TA, TB, HullCore, BoxCore>(ref a, poseA, ref b, poseB);
            case (CoreKind.Hull, CoreKind.Hull):
                return StatusAs<TA, TB, HullCore, HullCore>(ref a, poseA, ref b, poseB);
            case (CoreKind.Hull, CoreKind.Segment):
                return StatusAs<TA, TB, HullCore, SegmentCore>(ref a, poseA, ref b, poseB);
            case (CoreKind.Segment, CoreKind.Box):
                return StatusAs<TA, TB, SegmentCore, BoxCore>(ref a, poseA, ref b, poseB);
            case (CoreKind.Segment, CoreKind.Hull):
                return StatusAs<TA, TB, SegmentCore, HullCore>(ref a, poseA, ref b, poseB);
            case (CoreKind.Segment, CoreKind.Segment):
                return StatusAs<TA, TB, SegmentCore, SegmentCore>(ref a, poseA, ref b, poseB);
            default:
                return StatusOfCores(ref a, poseA, ref b, poseB);
        }
    }

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
