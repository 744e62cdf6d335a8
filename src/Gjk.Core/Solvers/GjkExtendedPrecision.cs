using System;
using System.Runtime.CompilerServices;

namespace Gjk.Core;

/// <summary>
/// The distance solver that decides what double cannot: the same walk as <see cref="GjkDistance"/>, with the simplex step in double-double (106 bits) and
/// without its assumptions.
/// </summary>
/// <remarks>
/// The vertices of A - B are taken as their doubles, which lie within a few units in the last place of where they are; moving vertices by that much moves
/// the distance by no more. On these points every sub-simplex is tried and the nearest one that holds its own nearest point wins (Johnson's
/// theorem, in Gilbert, Johnson and Keerthi 1988: it exists and is unique), so no region is missed and nothing rests on the order in which the points
/// came. The determinants of three doubles need at most 160 bits; 106 leave an error of 1e-31 of their size, which is 1e-16 of what the vertices' own rounding
/// does.
/// Termination: the distance, compared in double-double, falls strictly, or the walk ends. When it ends with the bounds apart, the support function contradicts
/// itself. It is reached from the fast solver only, for about one pair in a thousand of the hard families and none of the ordinary ones, and costs some microseconds.
/// Verdicts: as GjkDistance; Undecided here is final.
/// </remarks>
internal static class GjkExtendedPrecision
{
    /// <summary>
    /// AggressiveOptimization, which netstandard2.0 has no name for: this code runs so seldom that the runtime would leave it unoptimised, some hundred times slower.
    /// </summary>
    private const MethodImplOptions OptimizeAtOnce = (MethodImplOptions)512;

    /// <summary>Solves from the beginning, in the first direction.</summary>
    [MethodImpl(OptimizeAtOnce | MethodImplOptions.NoInlining)]
    public static void Solve<TA, TB, TTrace>(
        ref TA a, ref TB b, in PairFrame frame, double maxDistance, ref SolverState state, ref TTrace trace)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
        where TTrace : struct, IGjkTrace
    {
        int limit = state.Iterations + GjkTolerances.MaxIterations;
        Vector3D normal = frame.FirstNormal;
        ClosestFeature feature = default;
        Simplex simplex = default;
        DoubleDouble distanceSquared = default;
        state.Plane.NormalSquared = 0;
        while (true)
        {
            MinkowskiDifference.Support(ref a, ref b, frame, normal, out int idA, out int idB, out Vector3D onA, out Vector3D onB, out Vector3D w);
            state.Iterations++;
            if (state.Matters<TA, TB>(idA | idB)) state.See(frame, onA, onB, idA | idB);
            if (trace.IsOn) trace.OnSupport(new TracedSupport(frame, normal, onA, w, idA, idB, isExtended: true));
            double plane = Vector3D.Dot(normal, w);
            if (simplex.Count > 0 && Ends(ref state, simplex, feature, plane, maxDistance, limit)) return;

            Simplex before = simplex;
            simplex.Push(w, onA, onB, idA, idB);
            bool outside = TryReduce(ref simplex, out ClosestFeature next, out DoubleDouble nextSquared);
            if (trace.IsOn) trace.OnReduced(new TracedSimplex(simplex, frame.Unit, isExtended: true));
            if (!outside || !((double)nextSquared > state.TouchSquared))
            {
                bool isNumber = !outside || (double)nextSquared >= 0;
                state.Verdict = isNumber ? Verdict.Enclosed : Verdict.Contradiction;
                state.Simplex = simplex;
                state.Feature = next;
                return;
            }

            if (before.Count > 0 && !((nextSquared - distanceSquared).Sign < 0))
            {
                state.Simplex = before;
                state.Feature = feature;
                Proofs.SettleStall(ref state, plane, feature.Height - plane);
                return;
            }

            distanceSquared = nextSquared;
            feature = next;
            normal = feature.Normal;
        }
    }

    /// <summary>Records the newest plane and says whether it settles the query.</summary>
    private static bool Ends(
        ref SolverState state, in Simplex simplex, in ClosestFeature feature, double plane, double maxDistance, int limit)
    {
        double gap = feature.Height - plane;
        state.Simplex = simplex;
        state.Feature = feature;
        if (state.Plane.NormalSquared == 0 || plane / Math.Sqrt(feature.NormalSquared) > state.Plane.Distance) state.Plane.Set(feature, plane);

        if (plane > 0 && plane * plane > maxDistance * maxDistance * feature.NormalSquared)
        {
            state.Verdict = Verdict.Beyond;
            return true;
        }

        if (Proofs.IsClosed(gap, feature, state.IsCurved, state.Noise))
        {
            state.Verdict = Verdict.Apart;
            return true;
        }

        if (!(gap > 0))
        {
            Proofs.SettleStall(ref state, plane, -gap);
            return true;
        }

        state.Verdict = Verdict.Undecided;
        return state.Iterations >= limit;
    }

    /// <summary>Reduces the simplex to the sub-simplex nearest the origin; false when the origin is inside the tetrahedron.</summary>
    [MethodImpl(OptimizeAtOnce)]
    internal static bool TryReduce(ref Simplex simplex, out ClosestFeature feature, out DoubleDouble distanceSquared)
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
            feature.Normal = (Vector3D)normal;
            feature.Height = (double)height;
            feature.NormalSquared = (double)normalSquared;
        }

        Select(ref simplex, best);
        return true;
    }

    /// <summary>The subset's normal and height, when its nearest point is inside it.</summary>
    [MethodImpl(OptimizeAtOnce)]
    private static bool TryFeature(in Simplex simplex, int subset, out VectorDD normal, out DoubleDouble height, out bool flipped)
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

    /// <summary>
    /// Goes round an edge or a triangle until the vertex nearest the origin comes first. Measured from a far one, a small height would be the difference of large products, and lose the
    /// digits that tell one feature from the next.
    /// </summary>
    private static void NearestFirst(in Simplex simplex, ref int i, ref int j, ref int k)
    {
        if (j > 3) return;
        double a = simplex.W(simplex[i]).LengthSquared, b = simplex.W(simplex[j]).LengthSquared, c = k > 3 ? double.PositiveInfinity : simplex.W(simplex[k]).LengthSquared;
        if (a <= b && a <= c) return;
        if (k > 3) (i, j) = (j, i);
        else if (b <= c) (i, j, k) = (j, k, i);
        else (i, j, k) = (k, i, j);
    }

    /// <summary>The four volumes that the origin spans with the faces all have the sign of the whole.</summary>
    [MethodImpl(OptimizeAtOnce)]
    private static bool Encloses(in Simplex simplex)
    {
        VectorDD a = simplex.WA, b = simplex.WB, c = simplex.WC, d = simplex.WD;
        VectorDD ab = b - a, ac = c - a, ad = d - a;
        int abc = -VectorDD.Dot(VectorDD.Cross(ab, ac), a).Sign, acd = -VectorDD.Dot(VectorDD.Cross(ac, ad), a).Sign;
        int adb = -VectorDD.Dot(VectorDD.Cross(ad, ab), a).Sign, bcd = VectorDD.Dot(VectorDD.Cross(c - b, d - b), b).Sign;
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
