#if NET
using Lanes = System.Runtime.Intrinsics.Vector256<double>;

namespace Gjk.Core;

/// <remarks>Four faces at once, one per lane, product by product and sum by sum as one alone.</remarks>
internal unsafe partial struct Polytope
{
    private readonly double LeastKeyInLanes()
    {
        Lanes least = Vector256.Load(_keys);
        for (int i = 4; i < _faceCount; i += 4) least = Avx.Min(Vector256.Load(_keys + i), least);
        Vector128<double> two = Sse2.Min(least.GetLower(), least.GetUpper());
        return Sse2.MinScalar(two, Sse2.UnpackHigh(two, two)).ToScalar();
    }

    /// <summary><see cref="TrySetFace"/> for four slots, of which those from the end on hold no face.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private readonly bool TrySetLanes(int first, int end, double lowest)
    {
        PolytopeFace* one = _faces + first;
        PolytopeFace* two = first + 1 < end ? one + 1 : one, three = first + 2 < end ? one + 2 : one;
        PolytopeFace* four = first + 3 < end ? one + 3 : one;
        WideVector p = Corners(one, two, three, four, 0), q = Corners(one, two, three, four, 1);
        WideVector r = Corners(one, two, three, four, 2), normal = WideVector.Cross(q - p, r - p);
        Lanes a = WideVector.Dot(normal, p), b = WideVector.Dot(normal, q), c = WideVector.Dot(normal, r);
        Lanes least = Avx.Min(Avx.Min(a, b), c), most = Avx.Max(Avx.Max(a, b), c);
        Lanes squared = normal.LengthSquared, length = normal.SumOfMagnitudes;
        Lanes limit = least + length * Vector256.Create(_noise);
        Lanes key = least * Vector256.Abs(least) / squared;
        Vector256<long> slots = Vector256.Create(0L, 1, 2, 3) + Vector256.Create((long)first);
        Lanes isThere = Vector256.LessThan(slots, Vector256.Create((long)end)).AsDouble();
        key = ((key.AsInt64() & Vector256.Create(~SlotBits)) | slots).AsDouble();
        key = Vector256.ConditionalSelect(isThere, key, Vector256.Create(Gone));
        key.Store(_keys + first);
        Store(one, normal, limit, least, squared);
        Lanes isGood = Vector256.LessThanOrEqual(most - least, length * Vector256.Create(_level))
            & Vector256.GreaterThanOrEqual(key, Vector256.Create(lowest));
        uint bad = Vector256.AndNot(isThere, isGood).ExtractMostSignificantBits();
        bool have = true;
        for (int i = first; bad != 0; i++, bad >>= 1)
            if ((bad & 1) != 0) have &= TryRepair(i, lowest);
        return have;
    }

    /// <summary>The same corner of four faces.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private readonly WideVector Corners(
        PolytopeFace* one, PolytopeFace* two, PolytopeFace* three, PolytopeFace* four, int corner) =>
        WideVector.Transpose(
            Vector256.Load((double*)(_vertices + one->Vertices[corner])),
            Vector256.Load((double*)(_vertices + two->Vertices[corner])),
            Vector256.Load((double*)(_vertices + three->Vertices[corner])),
            Vector256.Load((double*)(_vertices + four->Vertices[corner])));

    /// <summary>Writes columns of four faces into their rows.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Store(PolytopeFace* face, in WideVector normal, Lanes limit, Lanes least, Lanes squared)
    {
        Lanes xy = Avx.UnpackLow(normal.X, normal.Y), xyOdd = Avx.UnpackHigh(normal.X, normal.Y);
        Lanes zLimit = Avx.UnpackLow(normal.Z, limit), zLimitOdd = Avx.UnpackHigh(normal.Z, limit);
        Avx.Permute2x128(xy, zLimit, 0x20).Store((double*)face);
        Avx.Permute2x128(xyOdd, zLimitOdd, 0x20).Store((double*)(face + 1));
        Avx.Permute2x128(xy, zLimit, 0x31).Store((double*)(face + 2));
        Avx.Permute2x128(xyOdd, zLimitOdd, 0x31).Store((double*)(face + 3));
        Lanes offset = Avx.UnpackLow(least, squared), offsetOdd = Avx.UnpackHigh(least, squared);
        offset.GetLower().Store(&face[0].Offset);
        offsetOdd.GetLower().Store(&face[1].Offset);
        offset.GetUpper().Store(&face[2].Offset);
        offsetOdd.GetUpper().Store(&face[3].Offset);
    }
}
#endif
