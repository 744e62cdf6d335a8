#if NET
using static Gjk.Core.WideLanes;
using Lanes = System.Runtime.Intrinsics.Vector256<double>;

namespace Gjk.Core;

/// <summary>The results of four walks, as <c>ConvexQuery.Finish</c> and <see cref="ClosestPointWeights"/> have them;
/// lanes that need more than the plain case are left to the scalar query.</summary>
internal static unsafe class WideFinish
{
    /// <summary>Finds the points, adds the margins and rounds.</summary>
    /// <param name="a">The first shapes.</param>
    /// <param name="b">The second shapes.</param>
    /// <param name="batch">Has the poses.</param>
    /// <param name="index">The pairs' places in it.</param>
    /// <param name="s">The ends of the walks.</param>
    /// <param name="maxDistance">What was asked.</param>
    /// <param name="results">Gets the results.</param>
    /// <returns>One bit for each lane whose result is complete.</returns>
    [MethodImpl(Jit.AtOnce | MethodImplOptions.NoInlining)]
    public static uint Finish<TA, TB>(
        ref TA a, ref TB b, in WideBatch batch, int* index, ref WidePairs s, float maxDistance, ref WideResults results)
        where TA : struct, IWideSide
        where TB : struct, IWideSide
    {
        Lanes good = s.Closed & WeightsOfFeature(ref s, ref results);
        if (s.Inside != Lanes.Zero) good |= WeightsOfInside(ref s, ref results);
        Lanes inside = s.Inside, count = s.Count;
        Lanes hasB = Vector256.GreaterThan(count, Lanes.One) | inside;
        Lanes hasC = Vector256.GreaterThan(count, Vector256.Create(2.0)) | inside;
        WideVector onA = a.Vertex(Low(s.SlotsA)) * results.WeightA, onB = b.Vertex(High(s.SlotsA)) * results.WeightA;
        onA = WideVector.Select(hasB, onA + a.Vertex(Low(s.SlotsB)) * results.WeightB, onA);
        onB = WideVector.Select(hasB, onB + b.Vertex(High(s.SlotsB)) * results.WeightB, onB);
        onA = WideVector.Select(hasC, onA + a.Vertex(Low(s.SlotsC)) * results.WeightC, onA);
        onB = WideVector.Select(hasC, onB + b.Vertex(High(s.SlotsC)) * results.WeightC, onB);
        if (inside != Lanes.Zero)
        {
            onA = WideVector.Select(inside, onA + a.Vertex(Low(s.SlotsW)) * results.WeightD, onA);
            onB = WideVector.Select(inside, onB + b.Vertex(High(s.SlotsW)) * results.WeightD, onB);
        }

        uint placed = Points(batch, index, s, onA, onB, maxDistance, ref results);
        return (good | s.Beyond).ExtractMostSignificantBits() & placed;
    }

    /// <summary>Which lanes are apart and which overlap; what is in neither is for the scalar query.</summary>
    [MethodImpl(Jit.AtOnce | MethodImplOptions.NoInlining)]
    public static void Statuses(ref WidePairs s, out uint apart, out uint overlapping)
    {
        Unsafe.SkipInit(out WideResults unused);
        Lanes scale = Lanes.One / Vector256.Sqrt(s.NormalSquared);
        Lanes distance = s.Height * scale - s.MarginA - s.MarginB;
        Lanes touching = s.Closed & Vector256.LessThanOrEqual(
            distance, Vector256.Create(GjkTolerances.Touch) * (s.RadiusA + s.RadiusB));
        apart = (s.Beyond | Vector256.AndNot(s.Closed, touching)).ExtractMostSignificantBits();
        Lanes inside = s.Inside == Lanes.Zero ? Lanes.Zero : WeightsOfInside(ref s, ref unused);
        overlapping = (touching | inside).ExtractMostSignificantBits();
    }

    /// <summary>As <see cref="ClosestPointWeights.OfFeature"/>; the lanes whose weights leave no doubt.</summary>
    private static Lanes WeightsOfFeature(ref WidePairs s, ref WideResults r)
    {
        Lanes count = s.Count, one = Lanes.One, zero = Lanes.Zero;
        Lanes isVertex = Vector256.Equals(count, one), isFace = Vector256.Equals(count, Vector256.Create(3.0));

        // A face is wound away from the origin first.
        s.TurnFaces(s.Closed & isFace & Vector256.LessThan(s.Winding, zero));
        WideVector a = s.A, ab = s.B - a, ac = s.C - a, inPlane = WideVector.Cross(s.Normal, a);
        Lanes abSquared = ab.LengthSquared, t = -WideVector.Dot(ab, a) / abSquared;
        Lanes scale = one / s.NormalSquared;
        Lanes b = -WideVector.Dot(ac, inPlane) * scale, c = WideVector.Dot(ab, inPlane) * scale, w = one - b - c;
        Lanes onEdge = Vector256.GreaterThanOrEqual(t, zero) & Vector256.LessThanOrEqual(t, one);
        Lanes onFace = Vector256.GreaterThanOrEqual(w, zero) & Vector256.GreaterThanOrEqual(b, zero)
            & Vector256.GreaterThanOrEqual(c, zero) & Vector256.GreaterThan(
                s.NormalSquared, Vector256.Create(ClosestPointWeights.Needle) * (abSquared * ac.LengthSquared));
        r.WeightA = Select(isFace, w, Select(isVertex, one, one - t));
        r.WeightB = Select(isFace, b, t);
        r.WeightC = c;
        return Select(isFace, onFace, isVertex | onEdge);
    }

    /// <summary>As <see cref="ClosestPointWeights.TryInside"/>, with W, the newest vertex, last; which lanes clearly
    /// are inside.</summary>
    private static Lanes WeightsOfInside(ref WidePairs s, ref WideResults r)
    {
        // The order of the scalar tetrahedron: the newest vertex, and the others wound away from the origin.
        Lanes turned = s.Inside & Vector256.LessThan(s.Winding, Lanes.Zero);
        WideVector a = s.W, b = s.A, c = WideVector.Select(turned, s.C, s.B), d = WideVector.Select(turned, s.B, s.C);
        WideVector cd = WideVector.Cross(c, d);
        Lanes va = WideVector.Dot(b, cd), vb = -WideVector.Dot(a, cd);
        Lanes vc = WideVector.Dot(a, WideVector.Cross(b, d)), vd = -WideVector.Dot(a, WideVector.Cross(b, c));
        Lanes sum = va + vb + vc + vd, turn = SignOf(sum);
        Lanes least = Vector256.Min(Vector256.Min(va * turn, vb * turn), Vector256.Min(vc * turn, vd * turn));
        Lanes size = a.LengthSquared + b.LengthSquared + c.LengthSquared + d.LengthSquared, cube = size * size * size;
        Lanes clear = Vector256.GreaterThan(least, Lanes.Zero)
            & Vector256.GreaterThan(least * least, Vector256.Create(ClosestPointWeights.ClearVolumeSquared) * cube)
            & Vector256.GreaterThan(sum * sum, Vector256.Create(ClosestPointWeights.ClearSumSquared) * cube);
        Lanes inside = s.Inside & clear;
        s.Inside = inside;
        Vector256<long> slotsA = s.SlotsA, slotsB = s.SlotsB, slotsC = s.SlotsC, slotsW = s.SlotsW;
        s.SlotsA = Select(inside, slotsW, slotsA);
        s.SlotsB = Select(inside, slotsA, slotsB);
        s.SlotsC = Select(inside, Select(turned, slotsC, slotsB), slotsC);
        s.SlotsW = Select(turned, slotsB, slotsC);
        r.WeightA = Select(inside, va / sum, r.WeightA);
        r.WeightB = Select(inside, vb / sum, r.WeightB);
        r.WeightC = Select(inside, vc / sum, r.WeightC);
        r.WeightD = vd / sum;
        return inside;
    }

    /// <summary>The rest of <c>ConvexQuery.Finish</c>.</summary>
    private static uint Points(
        in WideBatch batch, int* index, in WidePairs s, in WideVector onA, in WideVector onB, float maxDistance,
        ref WideResults r)
    {
        Lanes one = Lanes.One, zero = Lanes.Zero, inside = s.Inside, margins = s.MarginA + s.MarginB;
        Lanes size = s.RadiusA + s.RadiusB, scale = one / Vector256.Sqrt(s.NormalSquared);
        Lanes distance = s.Height * scale - s.MarginA - s.MarginB;
        Lanes touching = Vector256.LessThanOrEqual(distance, Vector256.Create(GjkTolerances.Touch) * size);
        Vector128<float> rounded = Avx.ConvertToVector128Single(distance);
        Lanes beyond = Vector256.GreaterThan(
            Avx.ConvertToVector256Double(rounded), Vector256.Create((double)Math.Max(maxDistance, 0)));
        WideVector none = new(zero, zero, zero), toA = s.Normal * scale;
        WideVector toAInB = WideVector.Select(
            Vector256.GreaterThan(s.MarginB, zero), s.Rotation.InverseRotate(toA), none);

        // Touching, a point that divides the way between the cores as the margins do.
        touching = Vector256.AndNot(touching, inside | s.Beyond);
        Lanes share = (s.Height * scale / margins) & Vector256.GreaterThan(margins, zero);
        Lanes reachA = Select(touching, share * s.MarginA, s.MarginA);
        Lanes reachB = Select(touching, share * s.MarginB, s.MarginB);
        Lanes common = inside | touching;
        Lanes far = s.Beyond | Vector256.AndNot(s.Closed & beyond, touching);
        Lanes smaller = IsSmallerB(s);
        Lanes isFar = Select(
            smaller, IsFarApart(distance, s.RadiusA, s.CenterA), IsFarApart(distance, s.RadiusB, s.CenterB));
        Lanes good = far | common | ~isFar;
        WideVector localA = WideVector.Select(inside, onA, onA - toA * reachA) + s.CenterA;
        WideVector localB = WideVector.Select(inside, onB, onB + toAInB * reachB) + s.CenterB;
        WideVector normal = -s.RotationA.Rotate(toA), worldA = s.RotationA.Rotate(localA) + s.PositionA;
        WideVector way = normal * distance, worldB = worldA + way;
        if (s.ArePlaced != zero)
        {
            localA = WideVector.Select(s.ArePlaced, batch.TurnsOfA(index).Rotate(localA), localA);
            localB = WideVector.Select(s.ArePlaced, batch.TurnsOfB(index).Rotate(localB), localB);
        }

        if (smaller != zero)
        {
            worldB = WideVector.Select(smaller, WideFrame.PlaceB(batch, index, localB), worldB);
            worldA = WideVector.Select(smaller, WideVector.Select(common, worldB, worldB - way), worldA);
        }

        // Beyond what was asked, the plane says all that is known.
        normal = WideVector.Select(far, s.RotationA.Rotate(s.Normal * -scale), normal);
        Lanes planeGap = s.Plane * scale, gap = Select(far, planeGap, Vector256.Min(planeGap, s.Height * scale));
        Lanes reach = Vector256.Create(2.0) * size + gap;
        Lanes bound = gap - margins - Vector256.Create(GjkTolerances.LowerBoundError) * reach;
        r.IsOverlapping = common.ExtractMostSignificantBits();
        r.IsBeyond = far.ExtractMostSignificantBits();
        r.Set(
            Vector256.AndNot(distance, common), Vector256.AndNot(RoundDown(bound), common), worldA,
            WideVector.Select(common, worldA, worldB), WideVector.Select(common, none, normal), localA, localB);
        r.Iterations = Avx.ConvertToVector128Int32(s.Iterations);
        return good.ExtractMostSignificantBits();
    }

    /// <summary>As <c>DistanceFinish.IsSmallerB</c>, where nothing is curved.</summary>
    private static Lanes IsSmallerB(in WidePairs s) =>
        Vector256.LessThan(s.RadiusB * Vector256.Create(DistanceFinish.MuchSmaller), s.RadiusA)
            & Vector256.LessThanOrEqual(
                s.CenterB.SumOfMagnitudes, Vector256.Create(DistanceFinish.FarApart) * s.RadiusA);

    /// <summary>As <c>DistanceFinish.IsFarApart</c>.</summary>
    private static Lanes IsFarApart(Lanes distance, Lanes radius, in WideVector center)
    {
        Lanes ratio = Vector256.Create(DistanceFinish.FarApart);
        return Vector256.GreaterThan(distance, ratio * radius)
            & Vector256.GreaterThan(distance, ratio * center.SumOfMagnitudes);
    }

    /// <summary>As <see cref="RoundOff.Down"/> for positive numbers; 0 for the others.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Lanes RoundDown(Lanes x)
    {
        Vector128<float> nearest = Avx.ConvertToVector128Single(x);
        Lanes wide = Avx.ConvertToVector256Double(nearest);
        Lanes below = Avx.ConvertToVector256Double((nearest.AsInt32() - Vector128<int>.One).AsSingle());
        Lanes down = Vector256.ConditionalSelect(Vector256.GreaterThan(wide, x), below, wide);
        return down & Vector256.GreaterThan(x, Lanes.Zero);
    }
}
#endif
