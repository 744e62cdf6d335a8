#if NET
using Lanes = System.Runtime.Intrinsics.Vector256<double>;

namespace Gjk.Core;

/// <summary>The loop of <see cref="GjkOverlap"/> for four pairs without margins at once.</summary>
/// <remarks>As there, only what rounding cannot change is answered: a plane's gap that exceeds all rounding, or four
/// volumes that do. The rest is asked again alone. It need not take the same way as the scalar loop, because both are
/// certain.</remarks>
internal static class WideOverlap
{
    /// <summary>Count of rounds: as many as the scalar loop's; the rest is for the query alone.</summary>
    private const int MaxRounds = 40;

    /// <summary>One bit for each lane that is apart, and for each that overlaps.</summary>
    [MethodImpl(Jit.AtOnce | MethodImplOptions.NoInlining)]
    public static void Solve<TA, TB>(ref TA a, ref TB b, ref WidePairs s, out uint apart, out uint overlapping)
        where TA : struct, IWideSide
        where TB : struct, IWideSide
    {
        Lanes band = Vector256.Create(GjkTolerances.SeparatedBand) * (s.RadiusA + s.RadiusB);
        Lanes bandSquared = band * band;
        WideDistance.Support(ref a, ref b, ref s);
        Test(ref s, bandSquared);
        WideStep.First(ref s);
        for (int round = 1; round < MaxRounds && s.Live != Lanes.Zero; round++)
        {
            WideDistance.Support(ref a, ref b, ref s);
            Test(ref s, bandSquared);
            if (s.Live != Lanes.Zero) WideStep.Advance(ref s, nearest: false);
        }

        apart = s.Beyond.ExtractMostSignificantBits();
        overlapping = s.Inside == Lanes.Zero ? 0 : (s.Inside & IsInside(s)).ExtractMostSignificantBits();
    }

    /// <summary>Ends the lanes whose newest plane has the origin on its near side.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Test(ref WidePairs s, Lanes bandSquared)
    {
        Lanes plane = WideVector.Dot(s.Normal, s.W), positive = Vector256.GreaterThan(plane, Lanes.Zero);
        Lanes clear = Vector256.GreaterThan(plane * plane, bandSquared * s.Normal.LengthSquared);
        s.Beyond |= s.Live & positive & clear;
        s.Live = Vector256.AndNot(s.Live, positive);
    }

    /// <summary>As <see cref="ClosestPointWeights.IsInside"/>.</summary>
    [MethodImpl(Jit.AtOnce | MethodImplOptions.NoInlining)]
    private static Lanes IsInside(in WidePairs s)
    {
        WideVector a = s.W, b = s.A, c = s.B, d = s.C, cd = WideVector.Cross(c, d);
        Lanes va = WideVector.Dot(b, cd), vb = -WideVector.Dot(a, cd);
        Lanes vc = WideVector.Dot(a, WideVector.Cross(b, d)), vd = -WideVector.Dot(a, WideVector.Cross(b, c));
        Lanes turn = WideLanes.SignOf(va + vb + vc + vd);
        Lanes least = Vector256.Min(Vector256.Min(va * turn, vb * turn), Vector256.Min(vc * turn, vd * turn));
        Lanes size = a.LengthSquared + b.LengthSquared + c.LengthSquared + d.LengthSquared;
        return Vector256.GreaterThan(least, Lanes.Zero) & Vector256.GreaterThan(
            least * least, Vector256.Create(ClosestPointWeights.ClearVolumeSquared) * (size * size * size));
    }
}
#endif
