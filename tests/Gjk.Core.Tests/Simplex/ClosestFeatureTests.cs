using System.Collections.Generic;
using System.Linq;
using System.Numerics;

namespace Gjk.Core.Tests;

public class ClosestFeatureTests
{
    /// <summary>
    /// The cases in which the newest vertex, A, is part of the nearest feature, and on the origin's side of the older
    /// ones: the step's own preconditions.
    /// </summary>
    public static IEnumerable<object[]> WithNewest() =>
        new[] { 2, 3, 4 }.SelectMany(SimplexCase.All).Where(c => ((int)c[1] & 1) != 0 && IsReached(c));

    public static IEnumerable<object[]> Any() => new[] { 1, 2, 3, 4 }.SelectMany(n => n == 1 ? [] : SimplexCase.All(n));

    [Theory]
    [MemberData(nameof(WithNewest))]
    public void ReduceKeepsTheNearestFeature(int n, int subset, double distance, int side)
    {
        SimplexCase c = SimplexCase.Make(n, subset, distance, side);
        Simplex simplex = Wound(c.Vertices);
        ClosestFeature feature = default;
        Assert.Equal(subset != 15, ClosestFeatureStep.Reduce(ref simplex, ref feature));
        if (subset != 15) Check(c, simplex, feature, subset);
    }

    /// <summary>None of the kinds of simplex has lost all its cases to the preconditions.</summary>
    [Theory]
    [InlineData(2, 6)]
    [InlineData(3, 24)]
    [InlineData(4, 13)]
    public void TheStepIsTriedOnEveryKindOfSimplex(int n, int least) =>
        Assert.InRange(WithNewest().Count(c => (int)c[0] == n), least, int.MaxValue);

    [Theory]
    [MemberData(nameof(Any))]
    public void ReduceAnyNeedsNoPrecondition(int n, int subset, double distance, int side)
    {
        SimplexCase c = SimplexCase.Make(n, subset, distance, side);
        Simplex simplex = Filled(c.Vertices);
        ClosestFeature feature = default;
        Assert.Equal(subset != 15, ClosestFeatureStep.ReduceAny(ref simplex, ref feature));
        if (subset != 15) Check(c, simplex, feature, subset);
    }

    [Theory]
    [MemberData(nameof(Any))]
    public void ExtendedPrecisionAgrees(int n, int subset, double distance, int side)
    {
        SimplexCase c = SimplexCase.Make(n, subset, distance, side);
        Simplex simplex = Filled(c.Vertices);
        Assert.Equal(
            subset != 15,
            ExtendedFeatureStep.TryReduce(ref simplex, out ClosestFeature feature, out DoubleDouble squared));
        if (subset == 15) return;
        Check(c, simplex, feature, subset);
        Assert.Equal(distance, System.Math.Sqrt((double)squared), 1e-9 * distance + 1e-15);
    }

    private static void Check(SimplexCase c, in Simplex simplex, in ClosestFeature feature, int subset)
    {
        Assert.Equal(BitOperations.PopCount((uint)subset), simplex.Count);
        double length = feature.Normal.Length;
        Assert.Equal(c.Distance, feature.Height / length, 1e-15 + 1e-9 * c.Distance);
        Assert.Equal(length * length, feature.NormalSquared, 1e-12 * length * length);

        // The direction of a distance of 3e-7 is known to 3e-16 / 3e-7, no better.
        Assert.Equal(0, (feature.Normal * (1 / length) - c.Normal).Length, c.Distance < 1e-3 ? 1e-8 : 1e-12);
        Weights w = ClosestPointWeights.OfFeature(simplex, feature);
        Assert.Equal(c.Distance, w.PointOf(simplex.WA, simplex.WB, simplex.WC, default).Length, 1e-12);
        for (int i = 0; i < simplex.Count; i++) Assert.Equal(simplex.W(simplex[i]), simplex.OnA(simplex[i]));
    }

    private static Simplex Filled(Vector3D[] vertices)
    {
        Simplex simplex = default;
        foreach (Vector3D w in vertices.Reverse()) simplex.Push(w, w, w, -1, -1);
        return simplex;
    }

    /// <summary>With the triangle of the older vertices wound away from the origin, as the solver leaves it.</summary>
    private static Simplex Wound(Vector3D[] v)
    {
        if (v.Length == 4 && Vector3D.Dot(Vector3D.Cross(v[2] - v[1], v[3] - v[1]), v[1]) < 0)
            v = [v[0], v[1], v[3], v[2]];
        return Filled(v);
    }

    private static bool IsReached(object[] c)
    {
        SimplexCase made = SimplexCase.Make((int)c[0], (int)c[1], (double)c[2], (int)c[3]);
        return made.Vertices.Length < 4 || IsBeyond(Wound(made.Vertices));
    }

    /// <summary>A lies on the origin's side of BCD: GJK would not have found it otherwise.</summary>
    private static bool IsBeyond(in Simplex s)
    {
        Vector3D normal = Vector3D.Cross(s.WC - s.WB, s.WD - s.WB);
        return Vector3D.Dot(normal, s.WA) < Vector3D.Dot(normal, s.WB);
    }
}
