namespace Gjk.Core;

/// <summary>The barycentric weights of the point of a simplex nearest the origin: at least 0, with sum 1. A vertex
/// outside the nearest feature has weight 0.</summary>
/// <remarks>Catto (GDC 2010) and Ericson (2004, section 5.1.5), with the areas taken as triple products with the face's
/// normal, which stays accurate for needles. Total: a degenerate simplex (repeated points, collinear, flat) falls back
/// to the best of its lower simplices, found by comparing them all. Unlike the solver's own step it assumes nothing
/// about how the points were found.</remarks>
internal static class ClosestPointWeights
{
    /// <summary>Length, as a fraction of the vertices' distances from the origin: how far the weighted point of a
    /// tetrahedron that holds the origin may be from it. A hundredth of what witness points are promised (1.2e-7); less
    /// would only ask extended precision more often. Pinned by ClosestPointWeightsTests.NeedleTetrahedra.</summary>
    private const double Residual = 1e-9;

    /// <summary>Squared sine of the angle at a triangle's corner, 2^-40: below it the face's weights have lost half of
    /// their digits, and an edge may be the better answer; a larger one would only cost time. Pinned by
    /// ClosestPointWeightsTests.NeedlesAreWeighedInExtendedPrecision.</summary>
    public const double Needle = 1.0 / (1L << 40);

    /// <summary>Ratio of a volume to the cube of the root of the vertices' squared lengths, added: 4 roundings. The
    /// determinant of three of these vertices, whose lengths' product is at most 0.2 of that cube, is off by 1.12
    /// roundings of the cube at most (proofs/clear-volume.g). Pinned by
    /// ClosestPointWeightsTests.AVolumeIsClearFromFourRoundingsOn.</summary>
    private const double ClearVolume = 4 * RoundOff.Unit;

    /// <summary>The same for the sum of the volumes: what keeps the weights' errors, a rounding or two over it, below
    /// <see cref="Residual"/> (proofs/clear-sum.g). Pinned by
    /// ClosestPointWeightsTests.ASumOfVolumesIsClearFromAHundredThousandthOn.</summary>
    private const double ClearSum = 1e-5;

    /// <summary>The squares of the last two, which the squares of volumes and sums are compared with.</summary>
    public const double ClearVolumeSquared = ClearVolume * ClearVolume, ClearSumSquared = ClearSum * ClearSum;

    /// <summary>The nearest point of a simplex of one to four vertices.</summary>
    public static Weights Of(in Simplex s) => s.Count switch
    {
        1 => new Weights(1, 0, 0, 0),
        2 => Segment(s.WA, s.WB),
        3 => Triangle(s.WA, s.WB, s.WC),
        _ => Tetrahedron(s.WA, s.WB, s.WC, s.WD),
    };

    /// <summary>Reduces a simplex of any origin, about which nothing is known, to its feature nearest the
    /// origin.</summary>
    /// <returns>False when the origin is inside the tetrahedron, or as near as its weights can tell.</returns>
    public static bool TrySelect(ref Simplex simplex)
    {
        Weights w = Of(simplex);
        int kept = 0;
        for (int i = 0; i < simplex.Count; i++)
        {
            if (!(w[i] > 0)) continue;
            int vertex = simplex[i];
            if (kept == 0) simplex.A = vertex;
            else if (kept == 1) simplex.B = vertex;
            else if (kept == 2) simplex.C = vertex;
            kept++;
        }

        if (kept == 4) return false;
        simplex.Count = kept;
        return true;
    }

    /// <summary>The nearest point of a feature that a solver found, whose normal is known and whose inside holds it; up
    /// to rounding the same as <see cref="Of"/>. Where the feature is far away, rounding may put the point a little
    /// beside it; then the weights that are negative become 0. Beside a needle that would move the point far along it,
    /// so the nearest point is looked for.</summary>
    public static Weights OfFeature(in Simplex s, in ClosestFeature feature)
    {
        if (s.Count == 1) return new Weights(1, 0, 0, 0);
        ref readonly Double3 a = ref s.WA, b = ref s.WB;
        Double3.Write(b.X - a.X, b.Y - a.Y, b.Z - a.Z, out Double3 ab);
        if (s.Count == 2)
        {
            double t = -Double3.Dot(ab, a) / ab.LengthSquared;
            if (t >= 0 & t <= 1) return new Weights(1 - t, t, 0, 0);
            return t > 1 ? new Weights(0, 1, 0, 0) : new Weights(1, 0, 0, 0);
        }

        ref readonly Double3 c = ref s.WC;
        Double3.Write(c.X - a.X, c.Y - a.Y, c.Z - a.Z, out Double3 ac);
        if (!(feature.NormalSquared > Needle * (ab.LengthSquared * ac.LengthSquared)))
            return Triangle(a, b, c);
        double scale = 1 / feature.NormalSquared;
        double wb = -Double3.Triple(feature.Normal, a, ac) * scale, wc = Double3.Triple(feature.Normal, a, ab) * scale;
        var weights = new Weights(1 - wb - wc, wb, wc, 0);
        return weights.IsInside ? weights : weights.Clamped;
    }

    /// <summary>The weights of the origin in a tetrahedron that holds it clearly: by so much that rounding can neither
    /// turn the sign of a volume nor take more than a billionth of the size from the weighted point.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool TryInside(in Simplex s, out Weights weights)
    {
        Double3 a = s.WA, b = s.WB, c = s.WC, d = s.WD;
        weights = VolumeWeights(a, b, c, d, out double sum, out double least);
        double cube = CubeOf(a, b, c, d);
        return IsClear(least, cube) & sum * sum > ClearSumSquared * cube;
    }

    /// <summary>Whether the origin clearly is inside a tetrahedron: by more than rounding could turn.</summary>
    public static bool IsInside(in Double3 a, in Double3 b, in Double3 c, in Double3 d)
    {
        VolumeWeights(a, b, c, d, out _, out double least);
        return IsClear(least, CubeOf(a, b, c, d));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static bool IsClear(double least, double cube) => least > 0 & least * least > ClearVolumeSquared * cube;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static double CubeOf(in Double3 a, in Double3 b, in Double3 c, in Double3 d)
    {
        double size = a.LengthSquared + b.LengthSquared + c.LengthSquared + d.LengthSquared;
        return size * size * size;
    }

    /// <summary>The nearest point of the segment AB.</summary>
    public static Weights Segment(in Double3 a, in Double3 b)
    {
        Double3 ab = b - a;
        double along = -Double3.Dot(ab, a), length = ab.LengthSquared;
        if (!(along > 0)) return new Weights(1, 0, 0, 0);
        if (!(along < length)) return new Weights(0, 1, 0, 0);
        double t = along / length;
        return new Weights(1 - t, t, 0, 0);
    }

    /// <summary>The nearest point of the triangle ABC.</summary>
    public static Weights Triangle(in Double3 a, in Double3 b, in Double3 c)
    {
        Weights face = FaceWeights(a, b, c, out bool isNeedle);
        if (face.IsInside && !isNeedle) return face;
        if (isNeedle) face = FaceWeightsExtended(a, b, c);
        Weights ab = Segment(a, b), bc = Segment(b, c), ca = Segment(c, a);
        Weights best = ab;
        double distance = ab.PointOf(a, b, c, default).LengthSquared;
        if (face.IsInside) Keep(ref best, ref distance, face, a, b, c, default);
        Keep(ref best, ref distance, new Weights(0, bc.A, bc.B, 0), a, b, c, default);
        Keep(ref best, ref distance, new Weights(ca.B, 0, ca.A, 0), a, b, c, default);
        return best;
    }

    /// <summary>The nearest point of the tetrahedron ABCD; the origin itself when that is inside.</summary>
    public static Weights Tetrahedron(in Double3 a, in Double3 b, in Double3 c, in Double3 d)
    {
        Weights inside = VolumeWeights(a, b, c, d, out _, out _);
        if (inside.IsInside && IsOrigin(inside, a, b, c, d)) return inside;
        inside = VolumeWeightsExtended(a, b, c, d);
        if (inside.IsInside && IsOrigin(inside, a, b, c, d)) return inside;
        Weights abc = Triangle(a, b, c), abd = Triangle(a, b, d), acd = Triangle(a, c, d), bcd = Triangle(b, c, d);
        Weights best = abc;
        double distance = abc.PointOf(a, b, c, d).LengthSquared;
        Keep(ref best, ref distance, new Weights(abd.A, abd.B, 0, abd.C), a, b, c, d);
        Keep(ref best, ref distance, new Weights(acd.A, 0, acd.B, acd.C), a, b, c, d);
        Keep(ref best, ref distance, new Weights(0, bcd.A, bcd.B, bcd.C), a, b, c, d);
        return best;
    }

    /// <summary>The origin's projection on the plane ABC in barycentric coordinates, negative or NaN where it is not a
    /// point of the triangle.</summary>
    private static Weights FaceWeights(in Double3 a, in Double3 b, in Double3 c, out bool isNeedle)
    {
        Double3 ab = b - a, ac = c - a, normal = Double3.Cross(ab, ac);
        double area = normal.LengthSquared;
        isNeedle = !(area > Needle * ab.LengthSquared * ac.LengthSquared);
        double wb = -Double3.Triple(ac, normal, a) / area;
        double wc = -Double3.Triple(normal, ab, a) / area;
        return new Weights(1 - wb - wc, wb, wc, 0);
    }

    /// <summary>The same in 106 bits: a needle's normal is what is left when products many times its size
    /// cancel.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static Weights FaceWeightsExtended(VectorDD a, VectorDD b, VectorDD c)
    {
        VectorDD ab = b - a, ac = c - a, normal = VectorDD.Cross(ab, ac);
        DoubleDouble area = VectorDD.Dot(normal, normal);
        DoubleDouble wb = -VectorDD.Dot(VectorDD.Cross(ac, normal), a) / area;
        DoubleDouble wc = -VectorDD.Dot(VectorDD.Cross(normal, ab), a) / area;
        return new Weights((double)(1.0 - wb - wc), (double)wb, (double)wc, 0);
    }

    /// <summary>The origin in barycentric coordinates of the tetrahedron: the four signed volumes over their sum; and
    /// the least of them, negative where the origin is outside.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Weights VolumeWeights(
        in Double3 a, in Double3 b, in Double3 c, in Double3 d, out double sum, out double least)
    {
        double va = Double3.Triple(c, d, b), vb = -Double3.Triple(c, d, a);
        double vc = Double3.Triple(b, d, a), vd = -Double3.Triple(b, c, a);
        sum = va + vb + vc + vd;
        double turn = BranchFree.WithSign(1, sum);
        least = Math.Min(Math.Min(va * turn, vb * turn), Math.Min(vc * turn, vd * turn));
        return new Weights(va / sum, vb / sum, vc / sum, vd / sum);
    }

    /// <summary>The same with the volumes in 106 bits: those of four points nearly on a line are what is left when
    /// products many times their size cancel.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static Weights VolumeWeightsExtended(VectorDD a, VectorDD b, VectorDD c, VectorDD d)
    {
        VectorDD cd = VectorDD.Cross(c, d), ab = VectorDD.Cross(a, b);
        DoubleDouble va = VectorDD.Dot(b, cd), vb = -VectorDD.Dot(a, cd);
        DoubleDouble vc = VectorDD.Dot(d, ab), vd = -VectorDD.Dot(c, ab);
        DoubleDouble sum = va + vb + vc + vd;
        return new Weights((double)(va / sum), (double)(vb / sum), (double)(vc / sum), (double)(vd / sum));
    }

    /// <summary>The weighted point is the origin, as near as the witness points are promised and better.</summary>
    private static bool IsOrigin(in Weights w, in Double3 a, in Double3 b, in Double3 c, in Double3 d)
    {
        double size = a.LengthSquared + b.LengthSquared + c.LengthSquared + d.LengthSquared;
        return w.PointOf(a, b, c, d).LengthSquared <= Residual * Residual * size;
    }

    private static void Keep(
        ref Weights best, ref double distance, in Weights candidate, in Double3 a, in Double3 b, in Double3 c,
        in Double3 d)
    {
        double squared = candidate.PointOf(a, b, c, d).LengthSquared;
        if (!(squared < distance)) return;
        distance = squared;
        best = candidate;
    }
}

/// <summary>Up to four barycentric weights.</summary>
[method: MethodImpl(MethodImplOptions.AggressiveInlining)]
internal readonly struct Weights(double a, double b, double c, double d)
{
    public readonly double A = a, B = b, C = c, D = d;

    /// <summary>By position: 0 is A, 3 is D.</summary>
    public double this[int index] => index switch { 0 => A, 1 => B, 2 => C, _ => D };

    /// <summary>No weight is negative or NaN.</summary>
    public bool IsInside => A >= 0 && B >= 0 && C >= 0 && D >= 0;

    /// <summary>None of the first few is 0: the point is inside their feature, not on its rim.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool AreAll(int count) => A != 0 & (count < 2 | B != 0) & (count < 3 | C != 0);

    /// <summary>A face's, without negative weights and with sum 1 again. NaN and infinite weights, which a triangle
    /// without any area has, become those of the first vertex.</summary>
    public Weights Clamped
    {
        get
        {
            double a = A > 0 ? A : 0, b = B > 0 ? B : 0, c = C > 0 ? C : 0, sum = a + b + c;
            return sum > 0 && sum <= double.MaxValue
                ? new Weights(a / sum, b / sum, c / sum, 0)
                : new Weights(1, 0, 0, 0);
        }
    }

    public Double3 PointOf(in Double3 a, in Double3 b, in Double3 c, in Double3 d) => a * A + b * B + c * C + d * D;
}
