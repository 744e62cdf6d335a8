#if NET
using static Gjk.Core.WideLanes;
using Lanes = System.Runtime.Intrinsics.Vector256<double>;

namespace Gjk.Core;

/// <summary>The step of <see cref="NextSimplex"/> for four pairs: every branch is a mask.</summary>
internal static class WideStep
{
    private static Lanes Three => Vector256.Create(3.0);

    /// <summary>The first round's: the newest vertex alone.</summary>
    [MethodImpl(Jit.AtOnce | MethodImplOptions.NoInlining)]
    public static void First(ref WidePairs s)
    {
        s.A = s.W;
        s.SlotsA = s.SlotsW;
        s.B = s.C = s.A;
        s.SlotsB = s.SlotsC = s.SlotsA;
        s.Count = s.Live & Lanes.One;
        Lanes squared = s.W.LengthSquared;
        s.Normal = WideVector.Select(s.Live, s.W, s.Normal);
        s.NormalSquared = Select(s.Live, squared, s.NormalSquared);
        s.Height = squared;
    }

    /// <summary>Chooses the face that the origin sees for the lanes that have four vertices, moves the older vertices
    /// up in the others, and reduces all to their nearest features.</summary>
    /// <param name="s">The four pairs.</param>
    [MethodImpl(Jit.AtOnce | MethodImplOptions.NoInlining)]
    public static void Advance(ref WidePairs s)
    {
        Lanes full = Vector256.Equals(s.Count, Three);
        if ((full & s.Live) != Lanes.Zero) TakeFace(ref s, full);
        else Shift(ref s, s.Live);
        Reduce(ref s);
    }

    private static void Shift(ref WidePairs s, Lanes mask)
    {
        s.C = WideVector.Select(mask, s.B, s.C);
        s.SlotsC = Select(mask, s.SlotsB, s.SlotsC);
        s.B = WideVector.Select(mask, s.A, s.B);
        s.SlotsB = Select(mask, s.SlotsA, s.SlotsB);
    }

    [MethodImpl(Jit.AtOnce | MethodImplOptions.NoInlining)]
    private static void TakeFace(ref WidePairs s, Lanes full)
    {
        WideVector a = s.W, ab = s.A - a, ac = s.B - a, ad = s.C - a;
        Lanes winding = s.Winding, zero = Lanes.Zero;
        Lanes abc = Vector256.GreaterThan(WideVector.Dot(WideVector.Cross(ab, ac), a) * winding, zero);
        Lanes acd = Vector256.GreaterThan(WideVector.Dot(WideVector.Cross(ac, ad), a) * winding, zero);
        Lanes adb = Vector256.GreaterThan(WideVector.Dot(WideVector.Cross(ad, ab), a) * winding, zero);
        Lanes inside = Vector256.AndNot(full & s.Live, abc | acd | adb);

        // One that a plane has shown apart is for the scalar query.
        s.Inside |= Vector256.AndNot(inside, s.Separated);
        s.Live = Vector256.AndNot(s.Live, inside);
        Lanes several = full & s.Live & ((abc & (acd | adb)) | (acd & adb));
        if (several != zero) Nearest(s, several, ref abc, ref acd, ref adb);

        // ABC keeps A and B, ACD the last two as they are, ADB turns round.
        Lanes stays = full & Vector256.AndNot(acd, abc), turns = full & Vector256.AndNot(adb, abc | acd);
        Lanes live = s.Live, shifts = Vector256.AndNot(live, stays | turns);
        WideVector b = s.B, c = s.C;
        Vector256<long> slotsB = s.SlotsB, slotsC = s.SlotsC;
        turns &= live;
        s.B = WideVector.Select(shifts, s.A, WideVector.Select(turns, c, b));
        s.C = WideVector.Select(shifts, b, WideVector.Select(turns, s.A, c));
        s.SlotsB = Select(shifts, s.SlotsA, Select(turns, slotsC, slotsB));
        s.SlotsC = Select(shifts, slotsB, Select(turns, s.SlotsA, slotsC));
    }

    /// <summary>Leaves one of several faces: that whose own nearest feature is nearest, the first of equals.</summary>
    [MethodImpl(Jit.AtOnce | MethodImplOptions.NoInlining)]
    private static void Nearest(in WidePairs s, Lanes several, ref Lanes abc, ref Lanes acd, ref Lanes adb)
    {
        Lanes infinity = Vector256.Create(double.PositiveInfinity);
        Lanes toAbc = Vector256.ConditionalSelect(abc, DistanceSquared(s.W, s.A, s.B), infinity);
        Lanes toAcd = Vector256.ConditionalSelect(acd, DistanceSquared(s.W, s.B, s.C), infinity);
        Lanes toAdb = Vector256.ConditionalSelect(adb, DistanceSquared(s.W, s.C, s.A), infinity);
        Lanes first = Vector256.AndNot(abc, Vector256.LessThan(toAcd, toAbc) | Vector256.LessThan(toAdb, toAbc));
        Lanes second = Vector256.AndNot(Vector256.AndNot(acd, Vector256.LessThan(toAdb, toAcd)), first);
        abc = Vector256.ConditionalSelect(several, first, abc);
        acd = Vector256.ConditionalSelect(several, second, acd);
        adb = Vector256.ConditionalSelect(several, ~(first | second), adb);
    }

    [MethodImpl(Jit.AtOnce | MethodImplOptions.NoInlining)]
    private static Lanes DistanceSquared(in WideVector a, in WideVector b, in WideVector c)
    {
        WideVector ab = b - a, ac = c - a, normal = WideVector.Cross(ab, ac);
        Regions(a, ab, ac, normal, out Lanes face, out Lanes besideAB, out Lanes besideAC);
        Lanes edge = besideAB | besideAC;
        WideVector e = WideVector.Select(besideAB, ab, ac), moment = WideVector.Cross(e, a);
        Lanes height = WideVector.Dot(normal, a), toFace = height * height / normal.LengthSquared;
        Lanes m = moment.LengthSquared, toEdge = m * m / WideVector.Cross(moment, e).LengthSquared;
        Lanes v = a.LengthSquared, toVertex = v * v / v;
        return Vector256.ConditionalSelect(face, toFace, Vector256.ConditionalSelect(edge, toEdge, toVertex));
    }

    /// <summary>Where the origin is: above the face, or else beside an edge at A, or else behind A.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Regions(
        in WideVector a, in WideVector ab, in WideVector ac, in WideVector normal, out Lanes face, out Lanes besideAB,
        out Lanes besideAC)
    {
        Lanes zero = Lanes.Zero;
        Lanes beyondAB = Vector256.LessThan(WideVector.Dot(WideVector.Cross(ab, normal), a), zero);
        Lanes beyondAC = Vector256.LessThan(WideVector.Dot(WideVector.Cross(normal, ac), a), zero);
        face = ~(beyondAB | beyondAC);
        besideAB = beyondAB & Vector256.LessThan(WideVector.Dot(ab, a), zero);
        besideAC = beyondAC & Vector256.LessThan(WideVector.Dot(ac, a), zero);
    }

    /// <summary>The nearest feature of W, B and C (with three vertices or more) or W and B (with two).</summary>
    private static void Reduce(ref WidePairs s)
    {
        WideVector a = s.W, ab = s.B - a, ac = s.C - a, normal = WideVector.Cross(ab, ac);
        Regions(a, ab, ac, normal, out Lanes face, out Lanes besideAB, out Lanes besideAC);
        Lanes isTriangle = Vector256.GreaterThan(s.Count, Lanes.One);
        face &= isTriangle;
        besideAC &= isTriangle;
        Lanes alongAB = Vector256.LessThan(WideVector.Dot(ab, a), Lanes.Zero);
        besideAB = Vector256.ConditionalSelect(isTriangle, besideAB, alongAB);
        Lanes edge = besideAB | besideAC, live = s.Live;

        Lanes height = WideVector.Dot(normal, a);
        Lanes winding = SignOf(height);
        WideVector e = WideVector.Select(besideAB, ab, ac), moment = WideVector.Cross(e, a);
        WideVector toEdge = WideVector.Cross(moment, e);
        Lanes vertex = a.LengthSquared;
        WideVector next = WideVector.Select(face, normal * winding, WideVector.Select(edge, toEdge, a));
        Lanes nextHeight = Select(face, height * winding, Select(edge, moment.LengthSquared, vertex));
        Lanes nextSquared = Select(face, normal.LengthSquared, Select(edge, toEdge.LengthSquared, vertex));
        s.Normal = WideVector.Select(live, next, s.Normal);
        s.Height = Select(live, nextHeight, s.Height);
        s.NormalSquared = Select(live, nextSquared, s.NormalSquared);
        s.Winding = Select(live & face, winding, s.Winding);
        s.Count = Select(live, Select(face, Three, Lanes.One + (edge & Lanes.One)), s.Count);

        Lanes takesC = live & Vector256.AndNot(edge, besideAB);
        s.B = WideVector.Select(takesC, s.C, s.B);
        s.SlotsB = Select(takesC, s.SlotsC, s.SlotsB);
        s.A = WideVector.Select(live, a, s.A);
        s.SlotsA = Select(live, s.SlotsW, s.SlotsA);
    }
}
#endif
