using System.Runtime.CompilerServices;

namespace Gjk.Core;

/// <summary>
/// Unwraps shapes to the cores that queries have a support of their own for, so that supports need not switch on the
/// shape's kind. Which kinds a type can have is known when the code is compiled.
/// </summary>
/// <remarks>
/// Each pair of cores has a method of its own, whose frame holds no more than these two: a method that held all of them
/// would clear and copy them all. Ahead-of-time compilers would make all the methods of 25 pairs, so for netstandard
/// shapes are asked as they are; the bits are the same.
/// </remarks>
internal static class CoreDispatch
{
#if NET
    /// <summary>Asks about the cores that the shapes can be unwrapped to, or about the shapes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Ask<TA, TB, TQuestion, TResult>(
        ref TA a, in RigidPose poseA, ref TB b, in RigidPose poseB, ref TQuestion question, out TResult result)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
        where TQuestion : struct, IPairQuestion<TResult>
    {
        // Two capsules of that type have a cheaper support than segments: a sign.
        if (typeof(TA) == typeof(CapsuleShape) && typeof(TB) == typeof(CapsuleShape))
        {
            question.Ask(ref a, poseA, ref b, poseB, PairPlacement.None, out result);
            return;
        }

        Ask<TA, TB, TQuestion, TResult>(
            KindOf(ref a), ref a, poseA, KindOf(ref b), ref b, poseB, PairPlacement.None, ref question, out result);
    }

    /// <summary>The same where the cores' kinds are known.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Ask<TA, TB, TQuestion, TResult>(
        CoreKind kindA, ref TA a, in RigidPose poseA, CoreKind kindB, ref TB b, in RigidPose poseB,
        in PairPlacement placement, ref TQuestion question, out TResult result)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
        where TQuestion : struct, IPairQuestion<TResult>
    {
        switch (kindA)
        {
            case CoreKind.Box:
                Ask<TA, TB, BoxCore, TQuestion, TResult>(
                    ref a, poseA, kindB, ref b, poseB, placement, ref question, out result);
                break;
            case CoreKind.Hull:
                Ask<TA, TB, HullCore, TQuestion, TResult>(
                    ref a, poseA, kindB, ref b, poseB, placement, ref question, out result);
                break;
            case CoreKind.Segment:
                Ask<TA, TB, SegmentCore, TQuestion, TResult>(
                    ref a, poseA, kindB, ref b, poseB, placement, ref question, out result);
                break;
            case CoreKind.Triangle:
                Ask<TA, TB, TriangleCore, TQuestion, TResult>(
                    ref a, poseA, kindB, ref b, poseB, placement, ref question, out result);
                break;
            default:
                AskShapes<TA, TB, TQuestion, TResult>(ref a, poseA, ref b, poseB, ref question, out result);
                break;
        }
    }

    /// <summary>The same where the first core is known.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Ask<TA, TB, TCoreA, TQuestion, TResult>(
        ref TA a, in RigidPose poseA, CoreKind kindB, ref TB b, in RigidPose poseB,
        in PairPlacement placement, ref TQuestion question, out TResult result)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
        where TCoreA : struct, ISupportMap
        where TQuestion : struct, IPairQuestion<TResult>
    {
        switch (kindB)
        {
            case CoreKind.Box:
                AskCores<TA, TB, TCoreA, BoxCore, TQuestion, TResult>(
                    ref a, poseA, ref b, poseB, placement, ref question, out result);
                break;
            case CoreKind.Hull:
                AskCores<TA, TB, TCoreA, HullCore, TQuestion, TResult>(
                    ref a, poseA, ref b, poseB, placement, ref question, out result);
                break;
            case CoreKind.Segment:
                AskCores<TA, TB, TCoreA, SegmentCore, TQuestion, TResult>(
                    ref a, poseA, ref b, poseB, placement, ref question, out result);
                break;
            case CoreKind.Triangle:
                AskCores<TA, TB, TCoreA, TriangleCore, TQuestion, TResult>(
                    ref a, poseA, ref b, poseB, placement, ref question, out result);
                break;
            default:
                AskShapes<TA, TB, TQuestion, TResult>(ref a, poseA, ref b, poseB, ref question, out result);
                break;
        }
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void AskCores<TA, TB, TCoreA, TCoreB, TQuestion, TResult>(
        ref TA a, in RigidPose poseA, ref TB b, in RigidPose poseB, in PairPlacement placement,
        ref TQuestion question, out TResult result)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
        where TCoreA : struct, ISupportMap
        where TCoreB : struct, ISupportMap
        where TQuestion : struct, IPairQuestion<TResult>
    {
        Get(ref a, out TCoreA coreA);
        Get(ref b, out TCoreB coreB);
        question.Ask(ref coreA, poseA, ref coreB, poseB, placement, out result);
    }

    /// <summary>What a shape can be unwrapped to.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static CoreKind KindOf<T>(ref T shape)
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

    /// <summary>Where the core of a shape that has one is in the shape's frame.</summary>
    private static Placement? PlacementOf<T>(ref T shape) =>
        typeof(T) == typeof(ConvexShape) ? Unsafe.As<T, ConvexShape>(ref shape).Placement : null;

    /// <summary>The core of a shape that is known to have it.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Get<T, TCore>(ref T shape, out TCore core)
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
#else
    /// <summary>Asks about the shapes.</summary>
    public static void Ask<TA, TB, TQuestion, TResult>(
        ref TA a, in RigidPose poseA, ref TB b, in RigidPose poseB, ref TQuestion question, out TResult result)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
        where TQuestion : struct, IPairQuestion<TResult> =>
        AskShapes<TA, TB, TQuestion, TResult>(ref a, poseA, ref b, poseB, ref question, out result);
#endif

    /// <summary>Asks about shapes of which one has no core, or is placed.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void AskShapes<TA, TB, TQuestion, TResult>(
        ref TA a, in RigidPose poseA, ref TB b, in RigidPose poseB, ref TQuestion question, out TResult result)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
        where TQuestion : struct, IPairQuestion<TResult>
    {
        if (ShapeTraits<TA>.CanBePlaced || ShapeTraits<TB>.CanBePlaced)
            AskInCoreAxes<TA, TB, TQuestion, TResult>(ref a, poseA, ref b, poseB, ref question, out result);
        else question.Ask(ref a, poseA, ref b, poseB, PairPlacement.None, out result);
    }

    /// <summary>Asks about what was placed, if anything was.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void AskInCoreAxes<TA, TB, TQuestion, TResult>(
        ref TA a, in RigidPose poseA, ref TB b, in RigidPose poseB, ref TQuestion question, out TResult result)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
        where TQuestion : struct, IPairQuestion<TResult>
    {
        if (!ShapeTraits<TA>.Of.IsPlaced(ref a) && !ShapeTraits<TB>.Of.IsPlaced(ref b))
        {
            question.Ask(ref a, poseA, ref b, poseB, PairPlacement.None, out result);
            return;
        }

#if NET
        CoreKind kindA = KindOf(ref a) & ~CoreKind.Moved, kindB = KindOf(ref b) & ~CoreKind.Moved;
        if (kindA != CoreKind.Other && kindB != CoreKind.Other)
        {
            var placement = new PairPlacement(PlacementOf(ref a), PlacementOf(ref b));
            Ask<TA, TB, TQuestion, TResult>(
                kindA, ref a, poseA, kindB, ref b, poseB, placement, ref question, out result);
            return;
        }
#endif
        AskCopies<TA, TB, TQuestion, TResult>(ref a, poseA, ref b, poseB, ref question, out result);
    }

    /// <summary>Asks about the shapes without their placements.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void AskCopies<TA, TB, TQuestion, TResult>(
        ref TA a, in RigidPose poseA, ref TB b, in RigidPose poseB, ref TQuestion question, out TResult result)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
        where TQuestion : struct, IPairQuestion<TResult>
    {
        TA coreA = ShapeTraits<TA>.Of.InCoreAxes(a, out Placement? placementA);
        TB coreB = ShapeTraits<TB>.Of.InCoreAxes(b, out Placement? placementB);
        question.Ask(ref coreA, poseA, ref coreB, poseB, new PairPlacement(placementA, placementB), out result);
    }
}
