namespace Gjk.Core.Tests;

public class ClosestFeatureTests
{
    /// <summary>The cases in which the newest vertex, A, is part of the nearest feature, and on the origin's side of
    /// the older ones: the step's own preconditions.</summary>
    public static IEnumerable<object[]> WithNewest() =>
        new[] { 2, 3, 4 }.SelectMany(SimplexCase.All).Where(c => ((int)c[1] & 1) != 0 && IsReached(c));

    public static IEnumerable<object[]> Any() => new[] { 1, 2, 3, 4 }.SelectMany(n => n == 1 ? [] : SimplexCase.All(n));

    [Theory]
    [MemberData(nameof(WithNewest))]
    public void ReduceKeepsTheNearestFeature(int n, int subset, double distance, int side)
    {
        SimplexCase c = SimplexCase.Make(n, subset, distance, side);
        Simplex simplex = Filled(c.Vertices);
        FeatureVertices vertices = Older(simplex);
        ClosestFeature feature = default;
        var newest = new MinkowskiVertex(simplex.WA, simplex.A);
        Assert.Equal(subset != 15, NextSimplex.TryAdvance(ref vertices, newest, ref feature, nearest: true));
        if (subset != 15) Check(c, Selected(simplex, vertices), feature, subset);
    }

    /// <summary>The boolean's step may take any face that the origin sees; here it sees one.</summary>
    [Theory]
    [MemberData(nameof(WithNewest))]
    public void TheFirstFaceWillDoWhereThereIsNoOther(int n, int subset, double distance, int side)
    {
        SimplexCase c = SimplexCase.Make(n, subset, distance, side);
        if (n == 4 && (BitOperations.PopCount((uint)subset) < 3 || distance >= 1)) return;
        Simplex simplex = Filled(c.Vertices);
        FeatureVertices vertices = Older(simplex);
        ClosestFeature feature = default;
        var newest = new MinkowskiVertex(simplex.WA, simplex.A);
        Assert.Equal(subset != 15, NextSimplex.TryAdvance(ref vertices, newest, ref feature, nearest: false));
        if (subset != 15) Check(c, Selected(simplex, vertices), feature, subset);
    }

    /// <summary>Two vertices whose squared lengths round to the same, though the second is nearer: the origin lies
    /// beyond it, and the edge's line passes far nearer than the edge.</summary>
    [Fact]
    public void AnEdgeOfOneRoundingIsItsNearerVertex()
    {
        Double3 a = new(1, 1, 1), b = new(1 - 1.0 / (1L << 53), 1, 1);
        Assert.Equal(a.LengthSquared, b.LengthSquared);
        foreach (Double3[] vertices in new[] { new[] { a, b }, [b, a] })
        {
            Simplex simplex = Filled(vertices);
            Assert.True(ExtendedFeatureStep.TryReduce(ref simplex, out ClosestFeature feature, out _));
            Assert.Equal((1, b, b), (simplex.Count, simplex.WA, feature.Normal));
        }
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
    public void WeightsSelectWithoutAPrecondition(int n, int subset, double distance, int side)
    {
        SimplexCase c = SimplexCase.Make(n, subset, distance, side);
        Simplex simplex = Filled(c.Vertices);
        Assert.Equal(subset != 15, ClosestPointWeights.TrySelect(ref simplex));
        if (subset == 15) return;
        FeatureVertices vertices = All(simplex);
        ClosestFeature feature = default;
        NextSimplex.Reduce(ref vertices, ref feature);
        Check(c, Selected(simplex, vertices), feature, subset);
    }

    /// <summary>A simplex that is its own nearest feature is kept as a whole, any other one is not.</summary>
    [Theory]
    [MemberData(nameof(Any))]
    public void AllIsKeptWhereAllIsNearest(int n, int subset, double distance, int side)
    {
        SimplexCase c = SimplexCase.Make(n, subset, distance, side);
        if (n == 4) return;
        Simplex simplex = Filled(c.Vertices);
        FeatureVertices vertices = All(simplex);
        ClosestFeature feature = default;
        Assert.Equal(subset == (1 << n) - 1, NextSimplex.TryKeepAll(ref vertices, ref feature));
        if (subset == (1 << n) - 1) Check(c, Selected(simplex, vertices), feature, subset);
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

    private static Simplex Filled(Double3[] vertices)
    {
        Simplex simplex = default;
        foreach (Double3 w in vertices.Reverse()) simplex.Push(w, w, w, -1, -1);
        return simplex;
    }

    private static FeatureVertices All(in Simplex s) => new()
    {
        A = new MinkowskiVertex(s.WA, s.A),
        B = new MinkowskiVertex(s.WB, s.B),
        C = new MinkowskiVertex(s.WC, s.C),
        Count = s.Count,
    };

    /// <summary>All vertices but the newest, the way the solver leaves them.</summary>
    private static FeatureVertices Older(in Simplex s)
    {
        var older = new FeatureVertices
        {
            A = new MinkowskiVertex(s.WB, s.B),
            B = new MinkowskiVertex(s.WC, s.C),
            C = new MinkowskiVertex(s.WD, s.D),
            Count = s.Count - 1,
        };
        older.Winding = Double3.Dot(Double3.Cross(s.WC - s.WB, s.WD - s.WB), s.WB) < 0 ? -1 : 1;
        return older;
    }

    private static Simplex Selected(Simplex s, in FeatureVertices vertices)
    {
        bool turned = vertices.Count == 3 && vertices.Winding < 0;
        int b = (int)vertices.B.Slot, c = (int)vertices.C.Slot;
        s.Select(vertices.Count, (int)vertices.A.Slot, turned ? c : b, turned ? b : c, 0);
        return s;
    }

    private static bool IsReached(object[] c)
    {
        SimplexCase made = SimplexCase.Make((int)c[0], (int)c[1], (double)c[2], (int)c[3]);
        return made.Vertices.Length < 4 || IsBeyond(Filled(made.Vertices));
    }

    /// <summary>A lies on the origin's side of BCD: GJK would not have found it otherwise.</summary>
    private static bool IsBeyond(in Simplex s)
    {
        Double3 normal = Double3.Cross(s.WC - s.WB, s.WD - s.WB);
        if (Double3.Dot(normal, s.WB) < 0) normal = -normal;
        return Double3.Dot(normal, s.WA) < Double3.Dot(normal, s.WB);
    }
}
