#if NET
using System.Runtime.CompilerServices;

namespace Gjk.Core;

/// <summary>
/// Unwraps shapes to the cores that queries have a support of their own for, so that supports need not switch on the
/// shape's kind. Which kinds a type can have is known when the code is compiled.
/// </summary>
internal static class PairDispatch
{
    /// <summary>What a shape can be unwrapped to.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static CoreKind KindOf<T>(ref T shape)
        where T : struct, ISupportMap
    {
        if (typeof(T) == typeof(ConvexShape)) return Unsafe.As<T, ConvexShape>(ref shape).Core;
        if (typeof(T) == typeof(ConvexMesh)) return Unsafe.As<T, ConvexMesh>(ref shape).Core;
        if (typeof(T) == typeof(BoxShape)) return CoreKind.Box;
        if (typeof(T) == typeof(TriangleShape)) return CoreKind.Triangle;
        return typeof(T) == typeof(CapsuleShape) || typeof(T) == typeof(SegmentShape)
            || typeof(T) == typeof(SphereShape) || typeof(T) == typeof(PointShape)
            ? CoreKind.Segment
            : CoreKind.Other;
    }

    /// <summary>Asks about the cores that the shapes can be unwrapped to, or about the shapes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Ask<TA, TB, TQuestion>(
        ref TA a, in RigidPose poseA, ref TB b, in RigidPose poseB, ref TQuestion question)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
        where TQuestion : struct, IPairQuestion
    {
        switch (KindOf(ref a))
        {
            case CoreKind.Box:
                Get(ref a, out BoxCore box);
                AskOf(ref box, poseA, ref b, poseB, ref question);
                break;
            case CoreKind.Hull:
                Get(ref a, out HullCore hull);
                AskOf(ref hull, poseA, ref b, poseB, ref question);
                break;
            case CoreKind.Segment:
                Get(ref a, out SegmentCore segment);
                AskOf(ref segment, poseA, ref b, poseB, ref question);
                break;
            case CoreKind.Triangle:
                Get(ref a, out TriangleCore triangle);
                AskOf(ref triangle, poseA, ref b, poseB, ref question);
                break;
            default:
                question.Ask(ref a, poseA, ref b, poseB);
                break;
        }
    }

    /// <summary>The same where the first shape is as it will be.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void AskOf<TA, TB, TQuestion>(
        ref TA a, in RigidPose poseA, ref TB b, in RigidPose poseB, ref TQuestion question)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
        where TQuestion : struct, IPairQuestion
    {
        switch (KindOf(ref b))
        {
            case CoreKind.Box:
                Get(ref b, out BoxCore box);
                question.Ask(ref a, poseA, ref box, poseB);
                break;
            case CoreKind.Hull:
                Get(ref b, out HullCore hull);
                question.Ask(ref a, poseA, ref hull, poseB);
                break;
            case CoreKind.Segment:
                Get(ref b, out SegmentCore segment);
                question.Ask(ref a, poseA, ref segment, poseB);
                break;
            case CoreKind.Triangle:
                Get(ref b, out TriangleCore triangle);
                question.Ask(ref a, poseA, ref triangle, poseB);
                break;
            default:
                question.Ask(ref a, poseA, ref b, poseB);
                break;
        }
    }

    /// <summary>The core of a shape that is known to have it.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Get<T, TCore>(ref T shape, out TCore core)
        where T : struct, ISupportMap
        where TCore : struct, ISupportMap
    {
        Unsafe.SkipInit(out core);
        if (typeof(TCore) == typeof(BoxCore)) GetBox(ref shape, out Unsafe.As<TCore, BoxCore>(ref core));
        else if (typeof(TCore) == typeof(HullCore)) GetHull(ref shape, out Unsafe.As<TCore, HullCore>(ref core));
        else if (typeof(TCore) == typeof(SegmentCore))
            GetSegment(ref shape, out Unsafe.As<TCore, SegmentCore>(ref core));
        else GetTriangle(ref shape, out Unsafe.As<TCore, TriangleCore>(ref core));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void GetBox<T>(ref T shape, out BoxCore box)
    {
        if (typeof(T) == typeof(ConvexShape)) Unsafe.As<T, ConvexShape>(ref shape).Get(out box);
        else if (typeof(T) == typeof(ConvexMesh)) Unsafe.As<T, ConvexMesh>(ref shape).Get(out box);
        else Unsafe.As<T, BoxShape>(ref shape).Get(out box);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void GetHull<T>(ref T shape, out HullCore hull)
    {
        if (typeof(T) == typeof(ConvexShape)) Unsafe.As<T, ConvexShape>(ref shape).Get(out hull);
        else Unsafe.As<T, ConvexMesh>(ref shape).Get(out hull);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void GetTriangle<T>(ref T shape, out TriangleCore triangle)
    {
        if (typeof(T) == typeof(ConvexShape)) Unsafe.As<T, ConvexShape>(ref shape).Get(out triangle);
        else Unsafe.As<T, TriangleShape>(ref shape).Get(out triangle);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void GetSegment<T>(ref T shape, out SegmentCore segment)
    {
        if (typeof(T) == typeof(ConvexShape)) Unsafe.As<T, ConvexShape>(ref shape).Get(out segment);
        else if (typeof(T) == typeof(CapsuleShape)) Unsafe.As<T, CapsuleShape>(ref shape).Get(out segment);
        else if (typeof(T) == typeof(SegmentShape)) Unsafe.As<T, SegmentShape>(ref shape).Get(out segment);
        else if (typeof(T) == typeof(SphereShape)) Unsafe.As<T, SphereShape>(ref shape).Get(out segment);
        else Unsafe.As<T, PointShape>(ref shape).Get(out segment);
    }
}
#endif
