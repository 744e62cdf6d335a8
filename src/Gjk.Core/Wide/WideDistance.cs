#if NET
using Lanes = System.Runtime.Intrinsics.Vector256<double>;

namespace Gjk.Core;

/// <summary>The walk of <see cref="GjkDistance"/> for four pairs at once, one pair per lane of a register.</summary>
/// <remarks>
/// <para>Each operation is the scalar walk's, in its order, without fused products, so each lane has the bits of its
/// pair alone. The lanes go in step until the last has ended; a lane that has ended keeps what it had.</para>
/// <para>Only plain ends are told here: the bounds have met, a plane is further than asked, the origin is enclosed and
/// no plane had separated, the feature touches the origin. What ends otherwise (a tilted face, a plane behind the
/// feature, a distance that stopped falling) has no mask and is asked again alone, where extended precision
/// decides.</para>
/// </remarks>
internal static class WideDistance
{
    /// <summary>Walks from the normal until no lane is live.</summary>
    [MethodImpl(Jit.AtOnce | MethodImplOptions.NoInlining)]
    public static void Solve<TA, TB>(ref TA a, ref TB b, ref WidePairs s)
        where TA : struct, IWideSide
        where TB : struct, IWideSide
    {
        Support(ref a, ref b, ref s);
        JudgeFirst(ref s);
        WideStep.First(ref s);
        Progress(ref s);
        Walk(ref a, ref b, ref s, 1);
    }

    /// <summary>Walks from the features that the live lanes have.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Walk<TA, TB>(ref TA a, ref TB b, ref WidePairs s, int rounds)
        where TA : struct, IWideSide
        where TB : struct, IWideSide
    {
        for (; rounds < GjkTolerances.MaxIterations && s.Live != Lanes.Zero; rounds++)
        {
            Support(ref a, ref b, ref s);
            Judge(ref s);
            if (s.Live == Lanes.Zero) return;
            WideStep.Advance(ref s);
            Progress(ref s);
        }
    }

    /// <summary>As <see cref="MinkowskiDifference"/>.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Support<TA, TB>(ref TA a, ref TB b, ref WidePairs s)
        where TA : struct, IWideSide
        where TB : struct, IWideSide
    {
        uint live = s.Live.ExtractMostSignificantBits();
        WideVector normal = s.Normal;
        WideVector onA = a.Support(-normal, live, out Vector256<long> slotsA);
        WideVector onB = b.Support(s.Rotation.InverseRotate(normal), live, out Vector256<long> slotsB);
        s.W = s.Vertex(onA, onB);
        s.SlotsW = slotsA | Vector256.ShiftLeft(slotsB, 32);
        s.Iterations += s.Live & Lanes.One;
    }

    private static void JudgeFirst(ref WidePairs s)
    {
        Lanes plane = WideVector.Dot(s.Normal, s.W);
        s.Plane = plane;
        Lanes beyond = See(ref s, plane);
        s.Beyond = s.Live & beyond;
        s.Live = Vector256.AndNot(s.Live, beyond);
    }

    /// <summary>What the newest plane says about the nearest feature.</summary>
    [MethodImpl(Jit.AtOnce | MethodImplOptions.NoInlining)]
    private static void Judge(ref WidePairs s)
    {
        Lanes plane = WideVector.Dot(s.Normal, s.W), live = s.Live;
        s.Plane = Vector256.ConditionalSelect(live, plane, s.Plane);
        Lanes beyond = See(ref s, plane);
        s.Beyond |= live & beyond;
        live = Vector256.AndNot(live, beyond);

        Lanes gap = s.Height - plane;
        Lanes closed = IsClosed(s, gap, s.NoiseSquared);
        Lanes isFace = Vector256.Equals(s.Count, Vector256.Create(3.0));
        if ((isFace & closed & live) != Lanes.Zero)
        {
            Lanes level = IsClosed(s, WideVector.Dot(s.Normal, s.B) - plane, s.LevelSquared)
                & IsClosed(s, WideVector.Dot(s.Normal, s.C) - plane, s.LevelSquared);
            s.Closed |= Vector256.AndNot(live & closed, Vector256.AndNot(isFace, level));
        }
        else
        {
            s.Closed |= live & closed;
        }

        s.Live = Vector256.AndNot(live & Vector256.GreaterThan(gap, Lanes.Zero), closed);
    }

    /// <summary>Notes which lanes a plane shows apart; gives those that it shows further than asked.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Lanes See(ref WidePairs s, Lanes plane)
    {
        Lanes positive = Vector256.GreaterThan(plane, Lanes.Zero), squared = plane * plane;
        s.Separated |= positive & Vector256.GreaterThan(squared, s.TouchSquared * s.NormalSquared);
        return positive & Vector256.GreaterThan(squared, s.ReachSquared * s.NormalSquared);
    }

    /// <summary>As <see cref="Proofs.IsClosed"/>.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Lanes IsClosed(in WidePairs s, Lanes gap, Lanes noiseSquared) =>
        Vector256.LessThanOrEqual(Vector256.Abs(gap), Vector256.Create(GjkTolerances.RelativeGap) * s.Height)
            | Vector256.LessThanOrEqual(gap * gap, noiseSquared * s.NormalSquared);

    /// <summary>Ends the lanes that touch the origin, and those whose distance has not fallen.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Progress(ref WidePairs s)
    {
        Lanes squared = s.Height * s.Height / s.NormalSquared, live = s.Live;
        Lanes apart = Vector256.GreaterThan(squared, s.TouchSquared);
        s.Live = live & apart & Vector256.LessThan(squared, s.DistanceSquared);
        s.DistanceSquared = squared;
    }
}
#endif
