using System.Globalization;

namespace Gjk.Core.Tests.Support;

/// <summary>A shape with what the tests know about it beside the library: its exact vertices, its extent, and the C#
/// text that makes it again.</summary>
internal sealed class TestShape
{
    private TestShape(string text, in ConvexShape shape, Double3[]? vertices, double margin, Double3 extent)
    {
        Text = text;
        Shape = shape;
        Vertices = vertices;
        Margin = margin;
        LongestSide = Math.Max(Math.Max(extent.X, extent.Y), extent.Z);
        Reach = shape.BoundingRadius;
    }

    public string Text { get; }

    public ConvexShape Shape { get; }

    /// <summary>The core's points, scale applied (exact: a product of two floats is a double); null where the core is
    /// curved.</summary>
    public Double3[]? Vertices { get; }

    public double Margin { get; }

    /// <summary>The longest side of the local bounding box, scale applied, margin included.</summary>
    public double LongestSide { get; }

    /// <summary>A generous bounding radius, by which the generators place pairs: scaled by the largest
    /// factor.</summary>
    public double Reach { get; private init; }

    public static TestShape Point() => Polytope("ConvexShape.Point()", ConvexShape.Point(), [Vector3.Zero], 0);

    public static TestShape Segment(Vector3 a, Vector3 b) =>
        Polytope($"ConvexShape.Segment({T(a)}, {T(b)})", ConvexShape.Segment(a, b), [a, b], 0);

    public static TestShape Triangle(Vector3 a, Vector3 b, Vector3 c) =>
        Polytope($"ConvexShape.Triangle({T(a)}, {T(b)}, {T(c)})", ConvexShape.Triangle(a, b, c), [a, b, c], 0);

    public static TestShape Sphere(float r) =>
        Polytope($"ConvexShape.Sphere({T(r)})", ConvexShape.Sphere(r), [Vector3.Zero], r);

    public static TestShape Capsule(float r, float h) =>
        Polytope($"ConvexShape.Capsule({T(r)}, {T(h)})", ConvexShape.Capsule(r, h), [new(0, h, 0), new(0, -h, 0)], r);

    public static TestShape Box(Vector3 h) => Polytope($"ConvexShape.Box({T(h)})", ConvexShape.Box(h), Corners(h), 0);

    public static TestShape Mesh(params Vector3[] points) =>
        Polytope($"ConvexShape.Mesh([{string.Join(", ", points.Select(T))}])", ConvexShape.Mesh(points), points, 0);

    public static TestShape Mesh(string name, ConvexHull hull, Vector3[] points) =>
        Polytope(name, ConvexShape.Mesh(hull), points, 0);

    public static TestShape Cylinder(float r, float h) =>
        Curved($"Cylinder({T(r)}, {T(h)})", ConvexShape.Cylinder(r, h), new(r, h, r));

    public static TestShape Cone(float r, float h) =>
        Curved($"Cone({T(r)}, {T(h)})", ConvexShape.Cone(r, h), new(r, h, r));

    public static TestShape Ellipsoid(Vector3 r) => Curved($"Ellipsoid({T(r)})", ConvexShape.Ellipsoid(r), r);

    public static TestShape TaperedCapsule(float top, float bottom, float h)
    {
        double wide = Math.Max(top, bottom), least = -Math.Max(bottom + (double)h, top - (double)h);
        double most = Math.Max(top + (double)h, bottom - (double)h);
        return Curved(
            $"TaperedCapsule({T(top)}, {T(bottom)}, {T(h)})", ConvexShape.TaperedCapsule(top, bottom, h),
            new(wide, (most - least) / 2, wide));
    }

    /// <summary>A shape with a curved core and no margin, and half the sides of its local bounding box.</summary>
    public static TestShape Curved(string text, in ConvexShape shape, in Double3 half) =>
        new($"ConvexShape.{text}", shape, null, 0, half * 2);

    public TestShape Scaled(Vector3 s)
    {
        var factors = new Double3(Math.Abs(s.X), Math.Abs(s.Y), Math.Abs(s.Z));
        bool even = factors.X == factors.Y && factors.Y == factors.Z;
        string text = $"{Text}.Scaled({T(s)})";
        bool polytope = Vertices is not null && (Margin == 0 || even);
        double largest = Math.Max(Math.Max(factors.X, factors.Y), factors.Z);
        Double3[]? vertices = polytope ? [.. Vertices!.Select(v => Double3.Multiply(v, s))] : null;
        Double3 extent = polytope
            ? Extent(vertices!, Margin * factors.X)
            : new Double3(1, 1, 1) * (LongestSide * largest);
        double margin = polytope ? Margin * factors.X : Margin * (even ? factors.X : 0);
        ConvexShape scaled = Shape.Scaled(s);
        double reach = scaled.Scale != Vector3.One ? Reach * largest : scaled.BoundingRadius;
        return new(text, scaled, vertices, margin, extent) { Reach = reach };
    }

    /// <summary>A curved shape with something around it that makes no side longer than its own margin does.</summary>
    public TestShape Decorated(Func<ConvexShape, ConvexShape> by, string text) =>
        new($"{Text}.{text}", by(Shape), null, 0, new Double3(1, 1, 1) * (LongestSide + 2 * by(Shape).Margin));

    public override string ToString() => Text;

    public static Vector3[] Corners(Vector3 h) =>
    [
        .. from x in new[] { -h.X, h.X }
           from y in new[] { -h.Y, h.Y }
           from z in new[] { -h.Z, h.Z }
           select new Vector3(x, y, z)
    ];

    private static TestShape Polytope(string text, in ConvexShape shape, Vector3[] vertices, double margin) =>
        Polytope(text, shape, [.. vertices.Select(v => (Double3)v)], margin);

    private static TestShape Polytope(string text, in ConvexShape shape, Double3[] vertices, double margin) =>
        new(text, shape, vertices, margin, Extent(vertices, margin));

    private static Double3 Extent(Double3[] vertices, double margin) =>
        new Double3(
            Side(vertices.Select(v => v.X)), Side(vertices.Select(v => v.Y)),
            Side(vertices.Select(v => v.Z))) + new Double3(2, 2, 2) * margin;

    private static double Side(IEnumerable<double> values) => values.Max() - values.Min();

    public static string T(float x) => x.ToString("R", CultureInfo.InvariantCulture) + "f";

    public static string T(Vector3 v) => $"new({T(v.X)}, {T(v.Y)}, {T(v.Z)})";

    public static string T(in RigidPose p) =>
        $"new RigidPose(new({T(p.Rotation.X)}, {T(p.Rotation.Y)}, {T(p.Rotation.Z)}, {T(p.Rotation.W)}), "
        + $"{T(p.Position)})";
}
