namespace Gjk.Core.Tests.Shapes;

/// <summary>Support functions against formulas and against every point of the shape that sampling can name.</summary>
public class SupportTests
{
    private const int RandomDirections = 500;

    [Fact]
    public void PolytopesReturnTheirBestVertex()
    {
        foreach (string kind in (string[])[.. Generators.PolytopeKinds, "bigHull"])
        {
            for (ulong seed = 0; seed < 10; seed++)
            {
                TestShape shape = Generators.Shape(new Rng(seed), kind);
                EachDirection(seed, d =>
                {
                    shape.Shape.Support(d, out Double3 point);
                    point += shape.Shape.Center;
                    double best = double.NegativeInfinity;
                    foreach (Double3 v in shape.Vertices!) best = Math.Max(best, Double3.Dot(v, d));
                    Assert.True(
                        Double3.Dot(point, d) >= best - 1e-15 * d.Length * shape.LongestSide * 4,
                        $"{shape} in {d}: {point}");
                    Assert.Contains(shape.Vertices!, v => (v - point).Length <= 1e-15 * shape.LongestSide);
                });
            }
        }
    }

    [Fact]
    public void AnIdNamesTheVertexThatCameWithIt()
    {
        foreach (string kind in (string[])[.. Generators.AllKinds, "bigHull"])
        {
            ConvexShape shape = Generators.Shape(new Rng(3), kind).Shape;
            bool curved = Array.IndexOf(Generators.CurvedKinds, kind) >= 0 && kind != "scaledSphere";
            EachDirection(3, d =>
            {
                int id = shape.Support(d, out Double3 point);
                Assert.True(curved ? id == -1 : id >= 0 || kind == "scaledSphere", $"{kind}: id {id}");
                if (id < 0) return;
                Assert.True(shape.TryGetVertex(id, out Double3 vertex));
                Assert.Equal(point, vertex);
            });
            Assert.False(shape.TryGetVertex(-1, out _));
            Assert.False(shape.TryGetVertex(int.MinValue, out _));
            Assert.False(shape.TryGetVertex(int.MaxValue, out _));
        }
    }

    [Fact]
    public void TheLengthOfTheDirectionChangesNothing()
    {
        foreach (string kind in Generators.AllKinds)
        {
            ConvexShape shape = Generators.Shape(new Rng(5), kind).Shape;
            EachDirection(5, d =>
            {
                shape.Support(d, out Double3 point);
                foreach (double length in new[] { 1e-30, 1024.0, 1e30 })
                {
                    shape.Support(d * length, out Double3 same);
                    Assert.True((same - point).Length <= 1e-7, $"{kind}: {point} but {same} in {length} times {d}");
                }
            });
        }
    }

    [Fact]
    public void TheCylindersHeightIsItsFormula() => EachDirection(6, d =>
        AssertHeight(new CylinderShape(0.7f, 1.3f), d, 0.7f * Radial(d) + 1.3f * Math.Abs(d.Y)));

    [Fact]
    public void TheConesHeightIsItsFormula() => EachDirection(7, d =>
        AssertHeight(new ConeShape(0.7f, 1.3f), d, Math.Max(1.3f * d.Y, 0.7f * Radial(d) - 1.3f * d.Y)));

    [Fact]
    public void TheEllipsoidsHeightIsItsFormula() => EachDirection(8, d =>
        AssertHeight(new EllipsoidShape(new Vector3(0.25f, 1, 3)), d, new Double3(0.25 * d.X, d.Y, 3 * d.Z).Length));

    [Fact]
    public void TheBoxesHeightIsItsFormula() => EachDirection(9, d =>
        AssertHeight(
            new BoxShape(new Vector3(0.25f, 1, 3)), d, 0.25 * Math.Abs(d.X) + Math.Abs(d.Y) + 3 * Math.Abs(d.Z)));

    [Fact]
    public void TheHeightsOfCapsuleAndSphereAreTheirFormulas() => EachDirection(10, d =>
    {
        AssertHeight(new CapsuleShape(0.5f, 2), d, 2 * Math.Abs(d.Y) + 0.5 * d.Length);
        AssertHeight(new SphereShape(0.5f), d, 0.5 * d.Length);
        AssertHeight(new PointShape(), d, 0);
    });

    [Fact]
    public void EveryPointOfTheSurfaceIsBelowTheSupport()
    {
        // The other side of the closed forms: points made from the shapes' equations, none of them past the support
        // plane.
        var rng = new Rng(11);
        for (int i = 0; i < 2000; i++)
        {
            double angle = rng.Range(0, 2 * Math.PI), t = rng.Range(-1, 1), x = Math.Cos(angle), z = Math.Sin(angle);
            Double3 d = rng.UnitVector();
            AssertBelow(new CylinderShape(0.7f, 1.3f), d, new Double3(0.7f * x, t * 1.3f, 0.7f * z));
            AssertBelow(
                new ConeShape(0.7f, 1.3f), d, new Double3(0.7f * x * (1 - t) / 2, t * 1.3f, 0.7f * z * (1 - t) / 2));
            double ring = Math.Sqrt(1 - t * t);
            AssertBelow(
                new EllipsoidShape(new Vector3(0.25f, 1, 3)), d, new Double3(0.25 * ring * x, t, 3 * ring * z));
        }
    }

    [Fact]
    public void FlattenedShapesStayFinite()
    {
        Double3[] alongAxes =
            [new(1, 0, 0), new(0, 1, 0), new(0, 0, 1), new(0, -1, 0), new(1e-300, 0, 0), new(0, 5e-324, 0)];
        foreach (Double3 d in alongAxes)
        {
            Finite(new EllipsoidShape(new Vector3(1, 0, 1)), d);
            Finite(new EllipsoidShape(Vector3.Zero), d);
            Finite(new CylinderShape(0, 1), d);
            Finite(new CylinderShape(1, 0), d);
            Finite(new ConeShape(0, 0), d);
            Finite(new Scaled<SphereShape>(new SphereShape(1), new Vector3(1, 2, 3)), d);
        }
    }

    private static void Finite<T>(in T shape, in Double3 d)
        where T : struct, ISupportMap
    {
        shape.Support(d, out Double3 point);
        Assert.True(point.IsFinite, $"{typeof(T).Name} in {d}: {point}");
    }

    private static double Radial(in Double3 d) => Math.Sqrt(d.X * d.X + d.Z * d.Z);

    private static void AssertHeight<T>(in T shape, in Double3 d, double expected)
        where T : struct, ISupportMap
    {
        shape.Support(d, out Double3 point);
        double height = Double3.Dot(shape.Center + point, d) + shape.Margin * d.Length;
        Assert.True(
            Math.Abs(height - expected) <= 1e-14 * shape.BoundingRadius * d.Length,
            $"{typeof(T).Name} in {d}: {height:R}, not {expected:R}");
        Assert.True(
            point.Length + shape.Margin <= shape.BoundingRadius * (1 + 1e-15),
            $"{typeof(T).Name}: {point} outside of the bounding ball");
    }

    private static void AssertBelow<T>(in T shape, in Double3 d, in Double3 p)
        where T : struct, ISupportMap
    {
        shape.Support(d, out Double3 point);
        point += shape.Center;
        Assert.True(
            Double3.Dot(p, d) <= Double3.Dot(point, d) + 1e-14, $"{typeof(T).Name} in {d}: {p} is past {point}");
    }

    private static void EachDirection(ulong seed, Action<Double3> examine)
    {
        foreach (Double3 d in Directions.Many) examine(d);
        var rng = new Rng(seed);
        for (int i = 0; i < RandomDirections; i++) examine(rng.UnitVector());
    }
}
