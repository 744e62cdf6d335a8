namespace Gjk.Core;

/// <summary>The support points and vertices of cores as <see cref="Xyz"/>. Boxes, meshes, segments and triangles, the
/// commonest, give them in registers where the hardware has such. The core's type is known at compile time. The bits
/// are those of the core's own support.</summary>
internal static class XyzSupport
{
#if NET
    private const int XyzBits = 7;
#endif

    /// <summary>The point furthest in a direction, and its id or -1.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int Furthest<T>(ref T shape, in Xyz direction, out Xyz point)
        where T : struct, ISupportMap
    {
#if NET
        int id;
        if (typeof(T) == typeof(HullCore))
        {
            point = Unsafe.As<T, HullCore>(ref shape).Support(direction.ToDouble3(), out id);
        }
        else if (typeof(T) == typeof(SegmentCore))
        {
            id = Unsafe.As<T, SegmentCore>(ref shape).SupportId(direction.ToDouble3());
            point = Unsafe.As<T, SegmentCore>(ref shape).Lanes(id);
        }
        else if (typeof(T) == typeof(TriangleCore))
        {
            id = Unsafe.As<T, TriangleCore>(ref shape).SupportId(direction.ToDouble3());
            point = Unsafe.As<T, TriangleCore>(ref shape).Lanes(id);
        }
        else if (typeof(T) == typeof(BoxCore) && Vector256.IsHardwareAccelerated)
        {
            // A zero of either sign counts as positive.
            ref BoxCore box = ref Unsafe.As<T, BoxCore>(ref shape);
            Xyz negative = Vector256.LessThan(direction, Xyz.Zero);
            id = box.Corners.Id((int)negative.ExtractMostSignificantBits() & XyzBits);
            point = box.Half.Lanes ^ (negative & XyzExtensions.SignBits);
        }
        else
        {
            id = shape.Support(direction.ToDouble3(), out Double3 found);
            point = found.ToXyz();
        }

        return id;
#else
        return shape.Support(direction, out point);
#endif
    }

    /// <summary>The vertex with an id; some point where there is none.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool TryGet<T>(ref T shape, int id, out Xyz vertex)
        where T : struct, ISupportMap
    {
#if NET
        if (typeof(T) == typeof(HullCore))
        {
            vertex = Unsafe.As<T, HullCore>(ref shape).Lanes(id);
            return Unsafe.As<T, HullCore>(ref shape).HasVertex(id);
        }

        if (typeof(T) == typeof(BoxCore) && Vector256.IsHardwareAccelerated)
        {
            ref BoxCore box = ref Unsafe.As<T, BoxCore>(ref shape);
            vertex = box.Half.Lanes ^ SignsOf(box.Corners.Signs(id & XyzBits));
            return (uint)id <= XyzBits;
        }

        bool found = shape.TryGetVertex(id, out Double3 point);
        vertex = point.ToXyz();
        return found;
#else
        return shape.TryGetVertex(id, out vertex);
#endif
    }

#if NET
    /// <summary>The sign bit of lane i where bit i is set.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Xyz SignsOf(int bits) =>
        Vector256.Equals(
            Vector256.Create((long)bits) & Vector256.Create(1L, 2, 4, 0), Vector256.Create(1L, 2, 4, -1)).AsDouble()
        & XyzExtensions.SignBits;
#endif
}
