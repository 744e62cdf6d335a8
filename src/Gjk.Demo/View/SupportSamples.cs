namespace Gjk.Demo.View;

/// <summary>Support points of a shape, distributed so that their hull looks like the shape.</summary>
internal static class SupportSamples
{
    /// <summary>Directions about the axis. From pole to pole there are half as many. The steps are 7.5
    /// degrees.</summary>
    private const int Meridians = 48;

    /// <summary>The same in a scene of many objects, where each one is small. Steps of 15 degrees need a quarter of the
    /// triangles.</summary>
    private const int CoarseMeridians = 24;

    /// <summary>Radians. Two directions lie this far beside the equator. They find both ends of the side of a capsule
    /// or a cylinder.</summary>
    private const double BesideEquator = 1e-3;

    /// <summary>True if the surface is curved anywhere.</summary>
    public static bool IsCurved(in ConvexShape shape) =>
        shape.Margin > 0 || shape.Kind is ShapeKind.Cylinder or ShapeKind.Cone or ShapeKind.Ellipsoid
            || !shape.TryGetVertex(0, out _);

    /// <summary>All corners if the shape has only corners, otherwise a grid of support points.</summary>
    public static List<Vector3> Of(in ConvexShape shape, bool isCoarse)
    {
        var points = new List<Vector3>();
        if (!IsCurved(shape))
        {
            for (int id = 0; shape.TryGetVertex(id, out Double3 corner); id++)
                points.Add((Vector3)(shape.Center + corner));
            return points;
        }

        int meridians = isCoarse ? CoarseMeridians : Meridians;
        Double3 stretch = Stretch(shape);
        points.Add((Vector3)Support(shape, Double3.Multiply(stretch, new Double3(0, 1, 0))));
        points.Add((Vector3)Support(shape, Double3.Multiply(stretch, new Double3(0, -1, 0))));
        foreach (double latitude in Latitudes(shape, meridians / 2))
            AddRow(shape, stretch, latitude, meridians, points);
        return points;
    }

    /// <summary>The furthest point of all parts, including their margins.</summary>
    public static Double3 Support(in AnyShape shape, in Double3 direction)
    {
        if (shape.Kind == AnyShapeKind.Convex) return Support(shape.Convex, direction);
        Double3 best = default;
        double most = double.NegativeInfinity;
        for (int part = 0; part < (shape.Mesh?.VertexCount ?? shape.PartCount); part++)
        {
            Double3 point = shape.Mesh is TriangleMesh mesh
                ? Double3.Multiply(mesh.GetVertex(part), mesh.Scale)
                : Support(shape.Compound!.GetPart(part), direction);
            double along = Double3.Dot(direction, point);
            if (!(along > most)) continue;
            most = along;
            best = point;
        }

        return best;
    }

    /// <summary>The furthest point of the whole shape, including its margin.</summary>
    public static Double3 Support(in ConvexShape shape, in Double3 direction)
    {
        shape.Support(direction, out Double3 point);
        point += shape.Center;
        return shape.Margin > 0 ? point + direction * (shape.Margin / direction.Length) : point;
    }

    /// <summary>The rows of a grid from pole to pole. A shape with straight sides needs only its rims.</summary>
    private static IEnumerable<double> Latitudes(ConvexShape shape, int parallels)
    {
        ShapeKind kind = shape.IsDecorated ? ShapeKind.Ellipsoid : shape.Kind;
        bool isBall = kind is ShapeKind.Sphere or ShapeKind.Ellipsoid;
        bool isDisc = kind is ShapeKind.Cylinder or ShapeKind.Cone;
        for (int row = 1; row < parallels && !isDisc; row++)
        {
            if (row != parallels / 2 || isBall) yield return Math.PI * row / parallels - Math.PI / 2;
        }

        if (isBall) yield break;
        yield return -BesideEquator;
        if (kind != ShapeKind.Cone) yield return BesideEquator;
    }

    private static void AddRow(
        in ConvexShape shape, in Double3 stretch, double latitude, int meridians, List<Vector3> points)
    {
        (double up, double outward) = Math.SinCos(latitude);
        for (int i = 0; i < meridians; i++)
        {
            (double z, double x) = Math.SinCos(2 * Math.PI * i / meridians);
            var onBall = new Double3(outward * x, up, outward * z);
            Double3 point = Support(shape, Double3.Multiply(stretch, onBall));
            points.Add((Vector3)point);
        }
    }

    /// <summary>A scale for directions. It turns normals that are even on a ball into normals whose support points are
    /// even on the stretched shape.</summary>
    private static Double3 Stretch(in ConvexShape shape)
    {
        if (shape.IsDecorated) return new Double3(1, 1, 1);
        if (shape.Kind != ShapeKind.Ellipsoid)
            return new Double3(1 / shape.Scale.X, 1 / shape.Scale.Y, 1 / shape.Scale.Z);
        double x = Extent(shape, new Double3(1, 0, 0));
        double y = Extent(shape, new Double3(0, 1, 0));
        double z = Extent(shape, new Double3(0, 0, 1));
        double largest = Math.Max(x, Math.Max(y, z));
        return new Double3(Inverse(x, largest), Inverse(y, largest), Inverse(z, largest));
    }

    private static double Extent(in ConvexShape shape, in Double3 axis) => Double3.Dot(Support(shape, axis), axis);

    /// <summary>The scale for one radius. No spread is even along a radius of 0, so any value works there.</summary>
    private static double Inverse(double radius, double largest) => radius > 0 ? largest / radius : 1;
}
