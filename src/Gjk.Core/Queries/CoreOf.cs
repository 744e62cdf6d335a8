namespace Gjk.Core;

/// <summary>The core that a shape can be unwrapped to, so that its supports need not switch on its kind. Which kinds a
/// type can have is known when the code is compiled.</summary>
internal static class CoreOf
{
    /// <summary>Whether a shape is placed, so that its core has axes of its own.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool IsPlaced<T>(ref T shape)
        where T : struct, ISupportMap
    {
        if (typeof(T) == typeof(ConvexShape))
            return (UnsafeRef.As<T, ConvexShape>(ref shape).Core & FormKind.Moved) != 0;
        return ShapeTraits<T>.CanBePlaced && ShapeTraits<T>.Instance.PlacementOf(ref shape) is not null;
    }

    /// <summary>What a shape can be unwrapped to.</summary>
    /// <typeparam name="T">The shape's type.</typeparam>
    /// <typeparam name="TOther">The type of the pair's other shape.</typeparam>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FormKind Kind<T, TOther>(ref T shape)
        where T : struct, ISupportMap
        where TOther : struct, ISupportMap
    {
        if (typeof(T) == typeof(ConvexShape)) return UnsafeRef.As<T, ConvexShape>(ref shape).Core & ~FormKind.Moved;
        if (typeof(T) == typeof(ConvexMesh)) return UnsafeRef.As<T, ConvexMesh>(ref shape).Core;
        if (typeof(T) == typeof(BoxShape)) return FormKind.Box;
        if (typeof(T) == typeof(TriangleShape)) return FormKind.Triangle;

        // A TriangleCore, which a mesh gives, is none to unwrap: it is solved as it is, with the same supports.
        // Two capsules of that type have a cheaper support than segments: a sign.
        return (typeof(T) == typeof(CapsuleShape) && typeof(TOther) != typeof(CapsuleShape))
            || typeof(T) == typeof(SegmentShape)
            || typeof(T) == typeof(SphereShape) || typeof(T) == typeof(PointShape)
            ? FormKind.Segment
            : FormKind.None;
    }

    /// <summary>The core of a shape that is known to have it.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Get<T, TCore>(ref T shape, out TCore core)
        where T : struct, ISupportMap
        where TCore : struct, ISupportMap
    {
        UnsafeRef.SkipInit(out core);
        if (typeof(TCore) == typeof(BoxCore)) GetBox(ref shape, out UnsafeRef.As<TCore, BoxCore>(ref core));
        else if (typeof(TCore) == typeof(HullCore)) GetHull(ref shape, out UnsafeRef.As<TCore, HullCore>(ref core));
        else if (typeof(TCore) == typeof(SegmentCore))
            GetSegment(ref shape, out UnsafeRef.As<TCore, SegmentCore>(ref core));
        else GetTriangle(ref shape, out UnsafeRef.As<TCore, TriangleCore>(ref core));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void GetBox<T>(ref T shape, out BoxCore box)
    {
        if (typeof(T) == typeof(ConvexShape)) UnsafeRef.As<T, ConvexShape>(ref shape).Get(out box);
        else if (typeof(T) == typeof(ConvexMesh)) UnsafeRef.As<T, ConvexMesh>(ref shape).Get(out box);
        else UnsafeRef.As<T, BoxShape>(ref shape).Get(out box);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void GetHull<T>(ref T shape, out HullCore hull)
    {
        if (typeof(T) == typeof(ConvexShape)) UnsafeRef.As<T, ConvexShape>(ref shape).Get(out hull);
        else UnsafeRef.As<T, ConvexMesh>(ref shape).Get(out hull);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void GetTriangle<T>(ref T shape, out TriangleCore triangle)
    {
        if (typeof(T) == typeof(ConvexShape)) UnsafeRef.As<T, ConvexShape>(ref shape).Get(out triangle);
        else UnsafeRef.As<T, TriangleShape>(ref shape).Get(out triangle);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void GetSegment<T>(ref T shape, out SegmentCore segment)
    {
        if (typeof(T) == typeof(ConvexShape)) UnsafeRef.As<T, ConvexShape>(ref shape).Get(out segment);
        else if (typeof(T) == typeof(CapsuleShape)) UnsafeRef.As<T, CapsuleShape>(ref shape).Get(out segment);
        else if (typeof(T) == typeof(SegmentShape)) UnsafeRef.As<T, SegmentShape>(ref shape).Get(out segment);
        else if (typeof(T) == typeof(SphereShape)) UnsafeRef.As<T, SphereShape>(ref shape).Get(out segment);
        else UnsafeRef.As<T, PointShape>(ref shape).Get(out segment);
    }
}
