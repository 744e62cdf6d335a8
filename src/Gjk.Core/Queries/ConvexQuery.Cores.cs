#if NET
using System.Runtime.CompilerServices;

namespace Gjk.Core;

public static partial class ConvexQuery
{
    // Each pair of cores has a method of its own, whose frame holds no more than these two.

    [MethodImpl(Jit.AtOnce | MethodImplOptions.NoInlining)]
    private static DistanceResult AskBoxes<TA, TB, TTrace>(
        ref TA a, in RigidPose poseA, ref TB b, in RigidPose poseB, float maxDistance, ref WarmStart warmStart,
        bool isWarm, ref TTrace trace)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
        where TTrace : struct, IGjkTrace
    {
        PairDispatch.Get(ref a, out BoxCore coreA);
        PairDispatch.Get(ref b, out BoxCore coreB);
        return AskCores(ref coreA, poseA, ref coreB, poseB, maxDistance, ref warmStart, isWarm, ref trace);
    }

    [MethodImpl(Jit.AtOnce | MethodImplOptions.NoInlining)]
    private static GjkStatus StatusOfBoxes<TA, TB>(
        ref TA a, in RigidPose poseA, ref TB b, in RigidPose poseB)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        PairDispatch.Get(ref a, out BoxCore coreA);
        PairDispatch.Get(ref b, out BoxCore coreB);
        return StatusOfCores(ref coreA, poseA, ref coreB, poseB);
    }

    [MethodImpl(Jit.AtOnce | MethodImplOptions.NoInlining)]
    private static DistanceResult AskBoxAndHull<TA, TB, TTrace>(
        ref TA a, in RigidPose poseA, ref TB b, in RigidPose poseB, float maxDistance, ref WarmStart warmStart,
        bool isWarm, ref TTrace trace)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
        where TTrace : struct, IGjkTrace
    {
        PairDispatch.Get(ref a, out BoxCore coreA);
        PairDispatch.Get(ref b, out HullCore coreB);
        return AskCores(ref coreA, poseA, ref coreB, poseB, maxDistance, ref warmStart, isWarm, ref trace);
    }

    [MethodImpl(Jit.AtOnce | MethodImplOptions.NoInlining)]
    private static GjkStatus StatusOfBoxAndHull<TA, TB>(
        ref TA a, in RigidPose poseA, ref TB b, in RigidPose poseB)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        PairDispatch.Get(ref a, out BoxCore coreA);
        PairDispatch.Get(ref b, out HullCore coreB);
        return StatusOfCores(ref coreA, poseA, ref coreB, poseB);
    }

    [MethodImpl(Jit.AtOnce | MethodImplOptions.NoInlining)]
    private static DistanceResult AskHullAndBox<TA, TB, TTrace>(
        ref TA a, in RigidPose poseA, ref TB b, in RigidPose poseB, float maxDistance, ref WarmStart warmStart,
        bool isWarm, ref TTrace trace)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
        where TTrace : struct, IGjkTrace
    {
        PairDispatch.Get(ref a, out HullCore coreA);
        PairDispatch.Get(ref b, out BoxCore coreB);
        return AskCores(ref coreA, poseA, ref coreB, poseB, maxDistance, ref warmStart, isWarm, ref trace);
    }

    [MethodImpl(Jit.AtOnce | MethodImplOptions.NoInlining)]
    private static GjkStatus StatusOfHullAndBox<TA, TB>(
        ref TA a, in RigidPose poseA, ref TB b, in RigidPose poseB)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        PairDispatch.Get(ref a, out HullCore coreA);
        PairDispatch.Get(ref b, out BoxCore coreB);
        return StatusOfCores(ref coreA, poseA, ref coreB, poseB);
    }

    [MethodImpl(Jit.AtOnce | MethodImplOptions.NoInlining)]
    private static DistanceResult AskHulls<TA, TB, TTrace>(
        ref TA a, in RigidPose poseA, ref TB b, in RigidPose poseB, float maxDistance, ref WarmStart warmStart,
        bool isWarm, ref TTrace trace)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
        where TTrace : struct, IGjkTrace
    {
        PairDispatch.Get(ref a, out HullCore coreA);
        PairDispatch.Get(ref b, out HullCore coreB);
        return AskCores(ref coreA, poseA, ref coreB, poseB, maxDistance, ref warmStart, isWarm, ref trace);
    }

    [MethodImpl(Jit.AtOnce | MethodImplOptions.NoInlining)]
    private static GjkStatus StatusOfHulls<TA, TB>(
        ref TA a, in RigidPose poseA, ref TB b, in RigidPose poseB)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        PairDispatch.Get(ref a, out HullCore coreA);
        PairDispatch.Get(ref b, out HullCore coreB);
        return StatusOfCores(ref coreA, poseA, ref coreB, poseB);
    }
}
#endif
