namespace Gjk.Core.Tests.Shapes;

/// <summary>Contract 9: what scale and radius do to a shape; and that ConvexShape is the same shape as the
/// struct.</summary>
public class DecoratorTests
{
    [Fact]
    public void AUniformScaleMultipliesTheMargin()
    {
        var scaled = new Scaled<CapsuleShape>(new CapsuleShape(0.5f, 2), 3);
        Assert.Equal(1.5, scaled.Margin);
        Assert.Equal(0, scaled.Support(new Double3(0.25, 1, 0), out Double3 top));
        Assert.Equal(new Double3(0, 6, 0), top);
        Assert.Equal(7.5, scaled.BoundingRadius);
        Assert.Equal(1.5, ConvexShape.Capsule(0.5f, 2).Scaled(new Vector3(3)).Margin);
        Assert.Equal(1.5, ConvexShape.Sphere(0.5f).Scaled(new Vector3(-3, 3, 3)).Margin);
    }

    [Fact]
    public void ANonUniformScaleMovesTheMarginIntoTheSupport()
    {
        var scaled = new Scaled<CapsuleShape>(new CapsuleShape(0.5f, 2), new Vector3(1, 2, 4));
        Assert.Equal(0, scaled.Margin);
        Assert.Equal(-1, scaled.Support(new Double3(0, 0, 1), out Double3 side));
        Assert.Equal(2, side.Z, 1e-15);
        scaled.Support(new Double3(0, -1, 0), out Double3 bottom);
        Assert.Equal(-5, bottom.Y, 1e-15);
        Assert.False(scaled.TryGetVertex(0, out _));
        Assert.Equal(ShapeKind.Ellipsoid, ConvexShape.Sphere(1).Scaled(new Vector3(1, 2, 3)).Kind);
    }

    [Fact]
    public void ANegativeScaleMirrors()
    {
        var triangle = new TriangleShape(new Vector3(1, 2, 3), new Vector3(-1, 0, 0.5f), new Vector3(0, -3, 1));
        var mirrored = new Scaled<TriangleShape>(triangle, new Vector3(-1, 1, 2));
        mirrored.Support(new Double3(-1, 1, 0.25), out Double3 point);
        Assert.Equal(new Double3(-1, 2, 6), mirrored.Center + point);
        Assert.Equal(Double3.Multiply(new Double3(-1, 1, 2), triangle.Center), mirrored.Center);
    }

    [Fact]
    public void RoundingOnlyAddsToTheMargin()
    {
        var round = new Rounded<CapsuleShape>(new CapsuleShape(0.5f, 2), 0.25f);
        Assert.Equal(0.75, round.Margin);
        Assert.Equal(2.75, round.BoundingRadius);
        Assert.Equal(1, round.Support(new Double3(0, -1, 0), out Double3 point));
        Assert.Equal(new Double3(0, -2, 0), point);
        Assert.Equal(0.25f, round.Radius);
        Assert.Equal(2f, round.Inner.HalfHeight);
    }

    [Fact]
    public void AScaledShapesSupportIsTheBestOfItsScaledPoints()
    {
        for (ulong seed = 0; seed < 50; seed++)
        {
            var rng = new Rng(seed);
            foreach (string kind in Generators.CurvedKinds)
            {
                if (!kind.StartsWith("scaled", StringComparison.Ordinal)) continue;
                string plain = char.ToLowerInvariant(kind[6]) + kind[7..];
                TestShape inner = Generators.Shape(rng, plain);
                Vector3 s = rng.Vector(0.3, 2) * new Vector3(-1, 1, 1);
                ConvexShape scaled = inner.Scaled(s).Shape;
                Double3 d = rng.UnitVector();
                scaled.Support(d, out Double3 best);
                best += scaled.Center;
                for (int i = 0; i < 50; i++)
                {
                    Double3 u = rng.UnitVector();
                    inner.Shape.Support(u, out Double3 core);
                    core += inner.Shape.Center;
                    Double3 p = Double3.Multiply(core + u * (inner.Shape.Margin / u.Length), s);
                    Assert.True(
                        Double3.Dot(p, d) <= Double3.Dot(best, d) + 1e-14, $"seed {seed}: {inner} scaled {s} in {d}");
                    Assert.True(
                        (p - scaled.Center).Length <= scaled.BoundingRadius * (1 + 1e-14),
                        $"seed {seed}: {inner} scaled {s} leaves its bounding ball");
                }
            }
        }
    }

    [Fact]
    public void ConvexShapeIsTheStructBitForBit()
    {
        Vector3 a = new(0.1f, 0.2f, -0.3f), b = new(1.1f, -0.7f, 0.3f), c = new(-0.4f, 0.9f, 0.6f);
        var hull = new ConvexHull([a, b, c, new Vector3(0.3f, 0.3f, 2), new Vector3(-1, -1, -1)]);
        Same(new PointShape(), ConvexShape.Point());
        Same(new SegmentShape(a, b), ConvexShape.Segment(a, b));
        Same(new TriangleShape(a, b, c), ConvexShape.Triangle(a, b, c));
        Same(new SphereShape(0.7f), ConvexShape.Sphere(0.7f));
        Same(new CapsuleShape(0.3f, 0.7f), ConvexShape.Capsule(0.3f, 0.7f));
        Same(new BoxShape(new Vector3(0.3f, 0.7f, 1.1f)), ConvexShape.Box(new Vector3(0.3f, 0.7f, 1.1f)));
        Same(new CylinderShape(0.3f, 0.7f), ConvexShape.Cylinder(0.3f, 0.7f));
        Same(new ConeShape(0.3f, 0.7f), ConvexShape.Cone(0.3f, 0.7f));
        Same(new EllipsoidShape(new Vector3(0.3f, 0.7f, 1.1f)), ConvexShape.Ellipsoid(new Vector3(0.3f, 0.7f, 1.1f)));
        foreach (var (top, bottom) in new[] { (0.3f, 0.5f), (0.5f, 0.3f), (0.3f, 0.3f), (0.1f, 2), (2, 0.1f), (0, 1) })
            Same(new TaperedCapsuleShape(top, bottom, 0.7f), ConvexShape.TaperedCapsule(top, bottom, 0.7f));
        Same(new ConvexMesh(hull), ConvexShape.Mesh(hull));
        var scale = new Vector3(0.7f, -1.3f, 2.1f);
        Same(new Scaled<ConvexMesh>(new ConvexMesh(hull), scale), ConvexShape.Mesh(hull).Scaled(scale));
        Same(
            new Scaled<CylinderShape>(new CylinderShape(0.3f, 0.7f), scale),
            ConvexShape.Cylinder(0.3f, 0.7f).Scaled(scale));
        Same(
            new Scaled<TaperedCapsuleShape>(new TaperedCapsuleShape(0.3f, 0.1f, 0.7f), scale),
            ConvexShape.TaperedCapsule(0.3f, 0.1f, 0.7f).Scaled(scale));
        Same(
            new Scaled<CapsuleShape>(new CapsuleShape(0.3f, 0.7f), scale),
            ConvexShape.Capsule(0.3f, 0.7f).Scaled(scale));
    }

    private static void Same<T>(in T shape, in ConvexShape tagged)
        where T : struct, ISupportMap
    {
        Assert.Equal(shape.Center, tagged.Center);
        Assert.Equal(shape.Margin, tagged.Margin);
        Assert.Equal(shape.BoundingRadius, tagged.BoundingRadius);
        var rng = new Rng(9);
        for (int i = 0; i < 200; i++)
        {
            Double3 d = rng.UnitVector();
            Assert.Equal(shape.Support(d, out Double3 p), tagged.Support(d, out Double3 q));
            Assert.True(p == q, $"{typeof(T).Name} in {d}: {p}, ConvexShape {q}");
        }

        for (int id = -1; id < 10; id++)
        {
            Assert.Equal(shape.TryGetVertex(id, out Double3 p), tagged.TryGetVertex(id, out Double3 q));
            if (shape.TryGetVertex(id, out _)) Assert.Equal(p, q);
        }

        for (ulong i = 0; i < 20; i++)
        {
            TestPair other = Generators.Pair(i, ["hull"]);
            DistanceResult r = ConvexQuery.Distance(shape, other.PoseA, other.B.Shape, other.PoseB);
            DistanceResult s = ConvexQuery.Distance(tagged, other.PoseA, other.B.Shape, other.PoseB);
            Assert.Equal(ResultBits.Of(r), ResultBits.Of(s));
        }
    }
}
