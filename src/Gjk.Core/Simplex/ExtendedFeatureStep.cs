namespace Gjk.Core;

/// <summary>The step of the distance solver in double-double (106 bits): every sub-simplex is tried, and the nearest
/// one that holds its own nearest point wins.</summary>
/// <remarks>Johnson's theorem (in Gilbert, Johnson and Keerthi 1988) says that this sub-simplex exists and is unique.
/// So no region is missed, and nothing rests on the order in which the points came, as it does in
/// <see cref="NextSimplex"/>. The determinants of three doubles need at most 160 bits. 106 leave an error of 1e-31 of
/// their size, which is 1e-16 of what the vertices' own rounding does.</remarks>
internal static class ExtendedFeatureStep
{
    /// <summary>Reduces the simplex to the sub-simplex nearest the origin; false when the origin is inside the
    /// tetrahedron.</summary>
    [MethodImpl(Jit.AtOnce)]
    public static bool TryReduce(ref Simplex simplex, out ClosestFeature feature, out DoubleDouble distanceSquared)
    {
        feature = default;
        distanceSquared = double.NaN;
        if (simplex.Count == 4 && Encloses(simplex)) return false;

        int best = 0;
        for (int subset = 1; subset < 1 << simplex.Count; subset++)
        {
            if (!TryFeature(simplex, subset, out VectorDD normal, out DoubleDouble height, out bool flipped)) continue;
            DoubleDouble normalSquared = VectorDD.Dot(normal, normal);
            DoubleDouble squared = (double)normalSquared == 0 ? 0.0 : height * height / normalSquared;
            if (best != 0 && (squared - distanceSquared).Sign >= 0) continue;
            best = flipped ? -subset : subset;
            distanceSquared = squared;
            feature.Normal = (Double3)normal;
            feature.Height = (double)height;
            feature.NormalSquared = (double)normalSquared;
        }

        Select(ref simplex, best);
        return true;
    }

    /// <summary>The subset's normal and height, when its nearest point is inside it.</summary>
    [MethodImpl(Jit.AtOnce)]
    private static bool TryFeature(
        in Simplex simplex, int subset, out VectorDD normal, out DoubleDouble height, out bool flipped)
    {
        int i = NextIn(subset, 0), j = NextIn(subset, i + 1), k = NextIn(subset, j + 1);
        NearestFirst(simplex, ref i, ref j, ref k);
        VectorDD a = simplex.W(simplex[i]);
        normal = a;
        height = VectorDD.Dot(a, a);
        flipped = false;
        if (j > 3) return true;

        VectorDD ab = (VectorDD)simplex.W(simplex[j]) - a;
        if (k > 3)
        {
            DoubleDouble along = VectorDD.Dot(ab, a);
            VectorDD moment = VectorDD.Cross(ab, a);
            normal = VectorDD.Cross(moment, ab);
            height = VectorDD.Dot(moment, moment);
            return along.Sign < 0 && (along + VectorDD.Dot(ab, ab)).Sign > 0;
        }

        if (subset == 15) return false;
        VectorDD b = simplex.W(simplex[j]), ac = (VectorDD)simplex.W(simplex[k]) - a;
        normal = VectorDD.Cross(ab, ac);
        height = VectorDD.Dot(normal, a);
        bool inside = VectorDD.Dot(VectorDD.Cross(ab, normal), a).Sign > 0
            && VectorDD.Dot(VectorDD.Cross(normal, ac), a).Sign > 0
            && VectorDD.Dot(VectorDD.Cross(ac - ab, normal), b).Sign > 0;
        flipped = height.Sign < 0;
        if (!flipped) return inside;
        normal = default(VectorDD) - normal;
        height = -height;
        return inside;
    }

    /// <summary>Goes round an edge or a triangle until the vertex nearest the origin comes first. Measured from a far
    /// one, a small height would be the difference of large products, and lose the digits that tell one feature from
    /// the next.</summary>
    private static void NearestFirst(in Simplex simplex, ref int i, ref int j, ref int k)
    {
        if (j > 3) return;
        double a = simplex.W(simplex[i]).LengthSquared, b = simplex.W(simplex[j]).LengthSquared;
        double c = k > 3 ? double.PositiveInfinity : simplex.W(simplex[k]).LengthSquared;
        if (a <= b && a <= c) return;
        if (k > 3) (i, j) = (j, i);
        else if (b <= c) (i, j, k) = (j, k, i);
        else (i, j, k) = (k, i, j);
    }

    /// <summary>The four volumes that the origin spans with the faces all have the sign of the whole.</summary>
    [MethodImpl(Jit.AtOnce)]
    private static bool Encloses(in Simplex simplex)
    {
        VectorDD a = simplex.WA, b = simplex.WB, c = simplex.WC, d = simplex.WD;
        VectorDD ab = b - a, ac = c - a, ad = d - a;
        int abc = -VectorDD.Dot(VectorDD.Cross(ab, ac), a).Sign, acd = -VectorDD.Dot(VectorDD.Cross(ac, ad), a).Sign;
        int adb = -VectorDD.Dot(VectorDD.Cross(ad, ab), a).Sign;
        int bcd = VectorDD.Dot(VectorDD.Cross(c - b, d - b), b).Sign;
        return abc != 0 && abc == acd && acd == adb && adb == bcd;
    }

    private static int NextIn(int subset, int from)
    {
        while (from < 4 && (subset >> from & 1) == 0) from++;
        return from;
    }

    /// <summary>Keeps the subset; a negative one is a triangle whose winding is to be turned round.</summary>
    private static void Select(ref Simplex simplex, int signedSubset)
    {
        int subset = Math.Abs(signedSubset);
        int i = NextIn(subset, 0), j = NextIn(subset, i + 1), k = NextIn(subset, j + 1);
        int a = simplex[i], b = simplex[j], c = simplex[k];
        simplex.Count = k <= 3 ? 3 : j <= 3 ? 2 : 1;
        simplex.A = a;
        simplex.B = signedSubset > 0 ? b : c;
        simplex.C = signedSubset > 0 ? c : b;
    }
}
