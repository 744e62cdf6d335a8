#if NET
namespace Gjk.Core;

/// <remarks>Boxes and meshes, the commonest pairs, are asked in registers of four doubles: x, y, z and a 0. Each
/// product and sum is that of the general support, so the answers have the same bits. Whether a pair is one of these is
/// known when the code is compiled.</remarks>
internal static partial class MinkowskiDifference
{
    private const int XyzBits = 7;

    private static Vector256<double> SignBits
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => Vector256.Create(-0.0, -0.0, -0.0, 0);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool HaveLanes<TA, TB>() => HasLanes<TA>() && HasLanes<TB>() && Avx2.IsSupported;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static bool HasLanes<T>() =>
        typeof(T) == typeof(BoxCore) || typeof(T) == typeof(HullCore) || typeof(T) == typeof(SegmentCore)
        || typeof(T) == typeof(TriangleCore);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static int SupportInLanes<TA, TB>(
        ref TA a, ref TB b, in PairFrame frame, in Double3 normal, ref Simplex simplex, int slot, out Double3 w)
    {
        Vector256<double> lanes = SupportInLanes(
            ref a, ref b, frame, -normal,
            out Vector256<double> onA, out Vector256<double> onB, out int idA, out int idB);
        simplex.Fill(slot, lanes, onA, onB, idA, idB);
        w = Xyz(lanes);
        return idA | idB;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static int SupportInLanes<TA, TB>(ref TA a, ref TB b, in PairFrame frame, in Double3 normal, out Double3 w)
    {
        w = Xyz(SupportInLanes(ref a, ref b, frame, -normal, out _, out _, out int idA, out int idB));
        return idA | idB;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static unsafe void SupportInLanes<TA, TB>(
        ref TA a, ref TB b, in PairFrame frame, in Double3 direction, PolytopeVertex* vertex)
    {
        Vector256<double> w = SupportInLanes(
            ref a, ref b, frame, direction,
            out Vector256<double> onA, out Vector256<double> onB, out int idA, out int idB);

        // In this order: the fourth lane of each covers what follows it.
        w.Store((double*)vertex);
        onA.Store((double*)&vertex->OnA);
        onB.Store((double*)&vertex->OnB);
        vertex->IdA = idA;
        vertex->IdB = idB;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector256<double> SupportInLanes<TA, TB>(
        ref TA a, ref TB b, in PairFrame frame, in Double3 direction,
        out Vector256<double> onA, out Vector256<double> onB, out int idA, out int idB)
    {
        Vector256<double> x = Vector256.Create(direction.X), y = Vector256.Create(direction.Y);
        Vector256<double> inB = frame.Inverse.Column0 * x + frame.Inverse.Column1 * y
            + frame.Inverse.Column2 * Vector256.Create(direction.Z);
        onA = Furthest(ref a, Vector256.Create(direction.X, direction.Y, direction.Z, 0), out idA);
        onB = Furthest(ref b, -inB, out idB);
        return VertexOf(frame, onA, onB);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static bool TryPlaceLanes<TA, TB>(
        ref TA a, ref TB b, in PairFrame frame, int idA, int idB, ref Simplex simplex, int slot)
    {
        bool found = TryGet(ref a, idA, out Vector256<double> onA) & TryGet(ref b, idB, out Vector256<double> onB);
        simplex.Fill(slot, VertexOf(frame, onA, onB), onA, onB, idA, idB);
        return found;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector256<double> Furthest<T>(ref T shape, Vector256<double> direction, out int id)
    {
        if (typeof(T) == typeof(HullCore))
        {
            return Unsafe.As<T, HullCore>(ref shape).Support(Xyz(direction), out id);
        }

        if (typeof(T) == typeof(SegmentCore))
        {
            ref SegmentCore segment = ref Unsafe.As<T, SegmentCore>(ref shape);
            id = segment.SupportId(Xyz(direction));
            return segment.Lanes(id);
        }

        if (typeof(T) == typeof(TriangleCore))
        {
            ref TriangleCore triangle = ref Unsafe.As<T, TriangleCore>(ref shape);
            id = triangle.SupportId(Xyz(direction));
            return triangle.Lanes(id);
        }

        // A zero of either sign counts as positive.
        ref BoxCore box = ref Unsafe.As<T, BoxCore>(ref shape);
        Vector256<double> negative = Vector256.LessThan(direction, Vector256<double>.Zero);
        id = box.Corners.Id((int)negative.ExtractMostSignificantBits() & XyzBits);
        return box.Half.Lanes ^ (negative & SignBits);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static bool TryGet<T>(ref T shape, int id, out Vector256<double> vertex)
    {
        if (typeof(T) == typeof(HullCore))
        {
            ref HullCore hull = ref Unsafe.As<T, HullCore>(ref shape);
            vertex = hull.Lanes(id);
            return hull.Has(id);
        }

        if (typeof(T) == typeof(SegmentCore))
        {
            ref SegmentCore segment = ref Unsafe.As<T, SegmentCore>(ref shape);
            vertex = segment.Lanes(id);
            return segment.Has(id);
        }

        if (typeof(T) == typeof(TriangleCore))
        {
            vertex = Unsafe.As<T, TriangleCore>(ref shape).Lanes(id);
            return TriangleCore.Has(id);
        }

        ref BoxCore box = ref Unsafe.As<T, BoxCore>(ref shape);
        vertex = box.Half.Lanes ^ SignsOf(box.Corners.Signs(id & XyzBits));
        return (uint)id <= XyzBits;
    }

    /// <summary>The sign bit of lane i where bit i is set.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector256<double> SignsOf(int bits) =>
        Avx2.ShiftLeftLogicalVariable(Vector256.Create((ulong)bits), Vector256.Create(63UL, 62, 61, 64)).AsDouble()
        & SignBits;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector256<double> VertexOf(in PairFrame frame, Vector256<double> onA, Vector256<double> onB) =>
        onA - (frame.Rotation.Rotate(onB) + frame.TranslationLanes);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Double3 Xyz(Vector256<double> v) => new(v.ToScalar(), v.GetElement(1), v.GetElement(2));
}
#endif
