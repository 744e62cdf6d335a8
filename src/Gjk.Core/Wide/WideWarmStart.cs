#if NET
using static Gjk.Core.WideLanes;
using Lanes = System.Runtime.Intrinsics.Vector256<double>;

namespace Gjk.Core;

/// <summary>Where four warm queries begin, and what they leave: <see cref="WarmStart"/> in lanes.</summary>
/// <remarks>A lane is taken only where the whole of the old feature is the nearest of itself still, as it is for pairs
/// that move little; the others are asked alone.</remarks>
internal static unsafe class WideWarmStart
{
    /// <summary>Count: those of a tetrahedron.</summary>
    public const int MostVertices = 4;

    /// <summary>The first normal of pairs that remember no vertices: as <see cref="WarmStart.FirstNormal"/>.</summary>
    public static void Direct(ref WarmStart starts, int* index, ref WidePairs s)
    {
        ref WarmStart a = ref Unsafe.Add(ref starts, index[0]), b = ref Unsafe.Add(ref starts, index[1]);
        ref WarmStart c = ref Unsafe.Add(ref starts, index[2]), d = ref Unsafe.Add(ref starts, index[3]);
        var normal = WideVector.Of(a.Normal, b.Normal, c.Normal, d.Normal);
        Lanes squared = normal.LengthSquared;
        Lanes isKnown = Vector256.GreaterThan(squared, Lanes.Zero)
            & Vector256.LessThanOrEqual(squared, Vector256.Create(WarmStart.LongestNormal));
        s.Normal = WideVector.Select(isKnown, normal, s.Normal);
        s.NormalSquared = s.Normal.LengthSquared;
    }

    /// <summary>Places the remembered vertices where they are now: as <see cref="WarmStart.Seed"/> and what follows
    /// it. There are four in each lane, or one to three.</summary>
    [MethodImpl(Jit.AtOnce | MethodImplOptions.NoInlining)]
    public static void Restore<TA, TB>(ref TA a, ref TB b, ref WarmStart starts, int* index, ref WidePairs s)
        where TA : struct, IWideSide
        where TB : struct, IWideSide
    {
        ref WarmStart p = ref Unsafe.Add(ref starts, index[0]), q = ref Unsafe.Add(ref starts, index[1]);
        ref WarmStart u = ref Unsafe.Add(ref starts, index[2]), v = ref Unsafe.Add(ref starts, index[3]);
        s.Count = Vector256.Create((double)p.Count, q.Count, u.Count, v.Count);
        Transpose(p.IdsA, q.IdsA, u.IdsA, v.IdsA, out FourSlots onA);
        Transpose(p.IdsB, q.IdsB, u.IdsB, v.IdsB, out FourSlots onB);

        // Where there is no second or third vertex, the first takes its place.
        Lanes hasB = Vector256.GreaterThan(s.Count, Lanes.One);
        Lanes hasC = Vector256.GreaterThan(s.Count, Vector256.Create(2.0));
        Lanes found = Lanes.AllBitsSet;
        s.SlotsA = Slots(ref a, ref b, onA.A, onB.A, ref found);
        s.SlotsB = Slots(ref a, ref b, Select(hasB, onA.B, onA.A), Select(hasB, onB.B, onB.A), ref found);
        s.SlotsC = Slots(ref a, ref b, Select(hasC, onA.C, onA.A), Select(hasC, onB.C, onB.A), ref found);
        s.A = Place(ref a, ref b, s, s.SlotsA);
        s.B = Place(ref a, ref b, s, s.SlotsB);
        s.C = Place(ref a, ref b, s, s.SlotsC);
        if (p.Count < MostVertices)
        {
            s.Live &= found;
            KeepAll(ref s);
            return;
        }

        // The tetrahedron of a walk that has ended: the first of the four counts as the newest.
        (s.W, s.SlotsW, s.A, s.SlotsA, s.B, s.SlotsB) = (s.A, s.SlotsA, s.B, s.SlotsB, s.C, s.SlotsC);
        s.SlotsC = Slots(ref a, ref b, onA.D, onB.D, ref found);
        s.C = Place(ref a, ref b, s, s.SlotsC);
        s.Inside = s.Live & found;
        s.Live = Lanes.Zero;
    }

    private static Vector256<long> Slots<TA, TB>(
        ref TA a, ref TB b, Vector256<long> idsA, Vector256<long> idsB, ref Lanes found)
        where TA : struct, IWideSide
        where TB : struct, IWideSide =>
        a.SlotsOf(idsA, ref found) | Vector256.ShiftLeft(b.SlotsOf(idsB, ref found), 32);

    private static WideVector Place<TA, TB>(ref TA a, ref TB b, in WidePairs s, Vector256<long> slots)
        where TA : struct, IWideSide
        where TB : struct, IWideSide =>
        s.Vertex(a.Vertex(Low(slots)), b.Vertex(High(slots)));

    /// <summary>Ends the lanes whose origin is not beside the whole feature, or touches it.</summary>
    private static void KeepAll(ref WidePairs s)
    {
        Lanes zero = Lanes.Zero, isVertex = Vector256.Equals(s.Count, Lanes.One);
        Lanes isEdge = Vector256.Equals(s.Count, Vector256.Create(2.0));
        Lanes isFace = Vector256.Equals(s.Count, Vector256.Create(3.0));
        WideVector a = s.A, b = s.B, ab = b - a, ac = s.C - a;
        Lanes besideEdge = Vector256.LessThan(WideVector.Dot(ab, a), zero)
            & Vector256.GreaterThan(WideVector.Dot(ab, b), zero);
        WideVector moment = WideVector.Cross(ab, a), toEdge = WideVector.Cross(moment, ab);
        WideVector normal = WideVector.Cross(ab, ac);
        Lanes besideFace = Vector256.GreaterThan(WideVector.Dot(WideVector.Cross(ab, normal), a), zero)
            & Vector256.GreaterThan(WideVector.Dot(WideVector.Cross(normal, ac), a), zero)
            & Vector256.GreaterThan(WideVector.Dot(WideVector.Cross(ac - ab, normal), b), zero);
        Lanes height = WideVector.Dot(normal, a);
        Lanes winding = SignOf(height);
        Lanes squared = a.LengthSquared;
        s.Normal = WideVector.Select(isFace, normal * winding, WideVector.Select(isEdge, toEdge, a));
        s.Height = Select(isFace, height * winding, Select(isEdge, moment.LengthSquared, squared));
        s.NormalSquared = s.Normal.LengthSquared;
        s.DistanceSquared = s.Height * s.Height / s.NormalSquared;
        s.Live &= ((isFace & besideFace) | (isEdge & besideEdge) | isVertex)
            & Vector256.GreaterThan(s.DistanceSquared, s.TouchSquared);

        // A face is wound away from the origin, as a scalar walk takes it over.
        s.FlipFaces(isFace & Vector256.LessThan(winding, zero));
    }

    /// <summary>Remembers where the lanes that have their results ended: as <see cref="WarmStart.Store"/>.</summary>
    [MethodImpl(Jit.AtOnce | MethodImplOptions.NoInlining)]
    public static void Store<TA, TB>(ref TA a, ref TB b, in WidePairs s, uint done, int* index, ref WarmStart starts)
        where TA : struct, IWideSide
        where TB : struct, IWideSide
    {
        // The faces of finished lanes are wound already.
        Lanes isFace = Vector256.Equals(s.Count, Vector256.Create(3.0));
        Lanes turned = s.Beyond & isFace & Vector256.LessThan(s.Winding, Lanes.Zero);
        Vector256<long> second = Select(turned, s.SlotsC, s.SlotsB), third = Select(turned, s.SlotsB, s.SlotsC);
        var counts = Avx.ConvertToVector128Int32(Select(s.Inside, Vector256.Create((double)MostVertices), s.Count));
        FourSlots onA, onB;
        onA.A = a.IdsOf(Low(s.SlotsA));
        onA.B = a.IdsOf(Low(second));
        onA.C = a.IdsOf(Low(third));
        onA.D = a.IdsOf(Low(s.SlotsW));
        onB.A = b.IdsOf(High(s.SlotsA));
        onB.B = b.IdsOf(High(second));
        onB.C = b.IdsOf(High(third));
        onB.D = b.IdsOf(High(s.SlotsW));
        onA.Pack(out Vector256<long> evenA, out Vector256<long> oddA);
        onB.Pack(out Vector256<long> evenB, out Vector256<long> oddB);
        for (int lane = 0; done != 0; lane++, done >>= 1)
        {
            if ((done & 1) == 0) continue;
            Vector256<long> idsA = (lane & 1) == 0 ? evenA : oddA, idsB = (lane & 1) == 0 ? evenB : oddB;
            bool isUpper = (lane & 2) != 0;
            ref WarmStart start = ref Unsafe.Add(ref starts, index[lane]);
            start.Set(
                counts.GetElement(lane), (isUpper ? idsA.GetUpper() : idsA.GetLower()).AsInt32(),
                (isUpper ? idsB.GetUpper() : idsB.GetLower()).AsInt32());
            if (counts.GetElement(lane) == 0) start.SetNormal(s.Normal[lane]);
        }
    }

    /// <summary>Four ids of each of four lanes, as four registers of one id per lane.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Transpose(
        Vector128<int> a, Vector128<int> b, Vector128<int> c, Vector128<int> d, out FourSlots slots)
    {
        var even = Vector256.Create(a.AsInt64(), c.AsInt64());
        var odd = Vector256.Create(b.AsInt64(), d.AsInt64());
        Vector256<long> low = Avx2.UnpackLow(even, odd), high = Avx2.UnpackHigh(even, odd);
        slots.A = Low(low);
        slots.B = High(low);
        slots.C = Low(high);
        slots.D = High(high);
    }

    /// <summary>An id of each lane, four times.</summary>
    private struct FourSlots
    {
        public Vector256<long> A, B, C, D;

        /// <summary>The four ids of lanes 0 and 2, and of lanes 1 and 3, side by side.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public readonly void Pack(out Vector256<long> even, out Vector256<long> odd)
        {
            Vector256<long> low = A | Vector256.ShiftLeft(B, 32), high = C | Vector256.ShiftLeft(D, 32);
            even = Avx2.UnpackLow(low, high);
            odd = Avx2.UnpackHigh(low, high);
        }
    }
}
#endif
