namespace Gjk.Core.Tests;

public class ClosestPointWeightsTests
{
    /// <summary>Of an equilateral triangle about the z axis, with corners at 1.</summary>
    private static readonly double Side = Math.Sqrt(0.75);

    public static IEnumerable<object[]> Segments() => SimplexCase.All(2);

    public static IEnumerable<object[]> Triangles() => SimplexCase.All(3);

    public static IEnumerable<object[]> Tetrahedra() => SimplexCase.All(4);

    [Theory]
    [MemberData(nameof(Segments))]
    [MemberData(nameof(Triangles))]
    [MemberData(nameof(Tetrahedra))]
    public void EveryRegionGivesItsOwnWeights(int n, int subset, double distance, int side)
    {
        SimplexCase c = SimplexCase.Make(n, subset, distance, side);
        Double3[] v = c.Vertices;
        Weights w = n == 2 ? ClosestPointWeights.Segment(v[0], v[1])
            : n == 3 ? ClosestPointWeights.Triangle(v[0], v[1], v[2])
            : ClosestPointWeights.Tetrahedron(v[0], v[1], v[2], v[3]);
        for (int i = 0; i < 4; i++) Assert.Equal(c.Weights[i], w[i], 1e-13);
        Assert.True(w.IsInside);
        Assert.Equal(1, w.A + w.B + w.C + w.D, 1e-15);
    }

    [Fact]
    public void RepeatedPointsFallBackToThePoint()
    {
        var p = new Double3(0.4, -1.3, 2.2);
        Assert.Equal(1, ClosestPointWeights.Segment(p, p).A);
        Weights w = ClosestPointWeights.Triangle(p, p, p);
        Assert.True(w.IsInside);
        Assert.Equal(p, w.PointOf(p, p, p, default));
        w = ClosestPointWeights.Tetrahedron(p, p, p, p);
        Assert.True(w.IsInside);
        Assert.Equal(p, w.PointOf(p, p, p, p));
    }

    [Fact]
    public void ACollinearTriangleFallsBackToItsBestEdge()
    {
        // The line through (1, 2, 3) along (2, -1, 0.5); the origin's nearest point on it is inside the long edge.
        Double3 start = new(1, 2, 3), along = new(2, -1, 0.5);
        Double3 a = start + along * -2, b = start + along * 1.5, c = start + along * 0.25;
        double t = -Double3.Dot(start, along) / along.LengthSquared;
        Double3 expected = start + along * t;
        Weights w = ClosestPointWeights.Triangle(a, b, c);
        Assert.True(w.IsInside);
        Assert.Equal(0, (w.PointOf(a, b, c, default) - expected).Length, 1e-14);
    }

    [Fact]
    public void AFlatTetrahedronFallsBackToItsBestFace()
    {
        // Four points of the plane x + 2 y - z = 3; the origin's foot (0.5, 1, -0.5) is inside their quadrilateral.
        static Double3 Plane(double x, double y) => new(x, y, x + 2 * y - 3);
        Double3 a = Plane(-2, 0.5), b = Plane(3, -0.25), c = Plane(1.5, 4), d = Plane(-1, 3.5);
        Weights w = ClosestPointWeights.Tetrahedron(a, b, c, d);
        Assert.True(w.IsInside);
        Assert.Equal(0, (w.PointOf(a, b, c, d) - new Double3(0.5, 1, -0.5)).Length, 1e-14);
    }

    /// <summary>Four points nearly on a line through the origin, which they enclose: the weighted point must be the
    /// origin however thin they are.</summary>
    [Fact]
    public void NeedleTetrahedra()
    {
        for (ulong seed = 0; seed < 4000; seed++)
        {
            var rng = new Rng(seed);
            double width = Math.Pow(10, -rng.Range(2, 14));
            Double3 along = Vector(rng, 1);
            Double3 a = along * rng.Range(0.5, 1) + Vector(rng, width);
            Double3 b = along * -rng.Range(0.5, 1) + Vector(rng, width);
            Double3 c = along * rng.Range(-1, 1) + Vector(rng, width);
            Double3 weights = new(rng.Range(0.1, 1), rng.Range(0.1, 1), rng.Range(0.1, 1));
            Double3 d = a * -weights.X + b * -weights.Y + c * -weights.Z;
            Weights w = ClosestPointWeights.Tetrahedron(a, b, c, d);
            Assert.True(w.IsInside, $"seed {seed}");
            double error = w.PointOf(a, b, c, d).Length;
            double size = Math.Sqrt(a.LengthSquared + b.LengthSquared + c.LengthSquared + d.LengthSquared);
            Assert.True(
                error <= 1.001e-9 * size, $"seed {seed}, width {width:R}: the weighted point is {error:R} off");
        }
    }

    /// <summary>Three points nearly on a line that passes the origin at a distance below or above their width: no point
    /// of an edge may be nearer than the answer.</summary>
    [Fact]
    public void NeedleTriangles()
    {
        for (ulong seed = 0; seed < 4000; seed++)
        {
            var rng = new Rng(seed);
            double width = Math.Pow(10, -rng.Range(2, 16));
            Double3 along = Vector(rng, 1), start = Vector(rng, Math.Pow(10, -rng.Range(0, 16)));
            Double3 a = start + along + Vector(rng, width), b = start - along + Vector(rng, width);
            Double3 c = start + along * rng.Range(-1, 1) + Vector(rng, width);
            double nearest = ClosestPointWeights.Triangle(a, b, c).PointOf(a, b, c, default).Length;
            foreach ((Double3 p, Double3 q) in new[] { (a, b), (b, c), (c, a) })
            {
                double edge = ClosestPointWeights.Segment(p, q).PointOf(p, q, default, default).Length;
                Assert.True(nearest <= edge + 1e-9, $"seed {seed}, width {width:R}: {nearest:R}, an edge {edge:R}");
            }
        }
    }

    /// <summary>Triangles just below the limit at which a face counts as a needle have their weights to nearly all
    /// digits.</summary>
    [Fact]
    public void NeedlesAreWeighedInExtendedPrecision()
    {
        const double sine = 0.35 / (1 << 20);
        for (ulong seed = 0; seed < 200; seed++)
        {
            var rng = new Rng(seed);
            Double3 along = Vector(rng, 1), across = Double3.Cross(along, Vector(rng, 1));
            Double3 normal = Double3.Cross(along, across);
            across *= along.Length * sine / across.Length;
            double wb = rng.Range(0.2, 0.4), wc = rng.Range(0.2, 0.4);
            Double3 foot = normal * (-0.5 / normal.Length), a = foot - along * wb - (along * 0.5 + across) * wc;
            Double3 b = a + along, c = a + along * 0.5 + across;
            Weights w = ClosestPointWeights.Triangle(a, b, c);
            Assert.True(IsExact(w, a, b, c), $"seed {seed}: {w.B:R} {w.C:R}");
        }
    }

    /// <summary>A solver's feature whose nearest point rounding has put beside it: the end of it is given.</summary>
    [Fact]
    public void AFeatureThatTheOriginIsNotBesideGivesItsEnd()
    {
        Double3 near = new(1, 0, 0), far = new(2, 0, 0);
        Assert.Equal(1, ClosestPointWeights.OfFeature(Filled(near, far), default).A);
        Assert.Equal(1, ClosestPointWeights.OfFeature(Filled(far, near), default).B);
        Assert.Equal(1, ClosestPointWeights.OfFeature(Filled(near, far, far), default).A);

        // An area that is too small for a double, so that the weights are infinite.
        var tiny = new Double3(0, 1e-120, 1e-100);
        Weights w = ClosestPointWeights.OfFeature(Filled(near, near + tiny, near - tiny), default);
        Assert.Equal((1.0, 0.0, 0.0), (w.A, w.B, w.C));
    }

    /// <summary>Four points of one plane through the origin, so that the volumes are what rounding leaves in any
    /// precision.</summary>
    [Fact]
    public void FlatTetrahedraThroughTheOrigin()
    {
        for (ulong seed = 0; seed < 300; seed++)
        {
            var rng = new Rng(seed);
            Double3[] v = new Double3[4];
            for (int i = 0; i < 4; i++)
            {
                double x = Math.Round(rng.Range(-1, 1) * (1L << 48)), y = Math.Round(rng.Range(-1, 1) * (1L << 48));
                v[i] = new(x / (1L << 48), y / (1L << 48), (x + 2 * y) / (1L << 48));
            }

            Double3 nearest = ClosestPointWeights.Tetrahedron(v[0], v[1], v[2], v[3]).PointOf(v[0], v[1], v[2], v[3]);
            double least = double.PositiveInfinity;
            foreach ((int i, int j, int k) in new[] { (0, 1, 2), (0, 1, 3), (0, 2, 3), (1, 2, 3) })
            {
                Weights w = ClosestPointWeights.Triangle(v[i], v[j], v[k]);
                least = Math.Min(least, w.PointOf(v[i], v[j], v[k], default).Length);
            }

            Assert.True(nearest.Length <= least + 1e-8, $"seed {seed}: {nearest.Length:R}, a face {least:R}");
        }
    }

    /// <summary>The ratio of a tetrahedron's least volume to the cube of the root of its squared lengths is 2.6 / 8
    /// times the height at which a face passes the origin.</summary>
    [Theory]
    [InlineData(2, false)]
    [InlineData(8, true)]
    public void AVolumeIsClearFromFourRoundingsOn(double roundings, bool isClear)
    {
        double h = roundings / (1L << 53) * 8 / (1.5 * Math.Sqrt(3));
        Assert.Equal(isClear, ClosestPointWeights.IsInside(
            new(1, 0, -h), new(-0.5, Side, -h), new(-0.5, -Side, -h), new(0, 0, 1)));
    }

    /// <summary>Nearly flat: the sum of the volumes is 2 h of the cube's root, and the origin is well inside.</summary>
    [Theory]
    [InlineData(5e-6, false)]
    [InlineData(2e-5, true)]
    public void ASumOfVolumesIsClearFromAHundredThousandthOn(double ratio, bool isClear)
    {
        double h = ratio / 2;
        Simplex simplex = Filled(new(1, 0, -h), new(-0.5, Side, -h), new(-0.5, -Side, -h), new(0, 0, 3 * h));
        Assert.Equal(isClear, ClosestPointWeights.TryInside(simplex, out _));
        Assert.True(ClosestPointWeights.IsInside(simplex.WA, simplex.WB, simplex.WC, simplex.WD));
    }

    /// <summary>Whether they are those of the origin's projection, in fractions, to 1e-15.</summary>
    private static bool IsExact(in Weights w, Double3 a, Double3 b, Double3 c)
    {
        Fraction[] ab = Minus(b, a), ac = Minus(c, a), p = Minus(default, a);
        Fraction bb = Dot(ab, ab), bc = Dot(ab, ac), cc = Dot(ac, ac), pb = Dot(p, ab), pc = Dot(p, ac);
        Fraction area = bb * cc - bc * bc, allowed = area * 1e-15;
        return (area * w.B - (pb * cc - pc * bc)).Absolute <= allowed
            && (area * w.C - (pc * bb - pb * bc)).Absolute <= allowed;

        static Fraction[] Minus(Double3 u, Double3 v) =>
            [(Fraction)u.X - v.X, (Fraction)u.Y - v.Y, (Fraction)u.Z - v.Z];
        static Fraction Dot(Fraction[] u, Fraction[] v) => u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
    }

    /// <summary>The first vertex is A.</summary>
    private static Simplex Filled(params Double3[] vertices)
    {
        Simplex simplex = default;
        for (int i = vertices.Length - 1; i >= 0; i--) simplex.Push(vertices[i], default, default, 0, 0);
        return simplex;
    }

    private static Double3 Vector(Rng rng, double size) =>
        new(rng.Range(-size, size), rng.Range(-size, size), rng.Range(-size, size));
}
