namespace Gjk.Core.Tests;

/// <summary>Directions in which a look-up can go wrong: normals of faces and edges, borders of cells, axes, tiny and
/// missing components, and everything close to these.</summary>
internal sealed class LookupDirections(ConvexHull hull, Rng rng)
{
    private const int Kinds = 8;

    public Double3 Next()
    {
        Double3 d = Plain();
        if (rng.Below(3) == 0) d = Near(d);
        if (rng.Below(6) == 0) d = WithoutSome(d);
        return rng.Below(8) == 0 ? d * Math.Pow(2, rng.Below(1400) - 700) : d;
    }

    private Double3 Plain() => rng.Below(Kinds) switch
    {
        0 => Axis(),
        1 => FaceNormal(),
        2 => AcrossAnEdge(),
        3 => OnACellBorder(),
        4 => AlongAnEdge(),
        5 => new Double3(rng.Below(7) - 3, rng.Below(7) - 3, rng.Below(7) - 3),
        _ => (Double3)rng.UnitVector(),
    };

    private Double3 Axis()
    {
        double s = rng.Below(2) == 0 ? 1 : -1;
        int axis = rng.Below(3);
        return new Double3(axis == 0 ? s : 0, axis == 1 ? s : 0, axis == 2 ? s : 0);
    }

    private Double3 FaceNormal()
    {
        if (hull.TriangleCount == 0) return Axis();
        hull.GetTriangle(rng.Below(hull.TriangleCount), out int a, out int b, out int c);
        return Unit(Double3.Cross(Edge(a, b), Edge(a, c)));
    }

    private Double3 AlongAnEdge()
    {
        int i = rng.Below(hull.VertexCount);
        int neighbors = hull.NeighborCount(i);
        return neighbors == 0 ? Axis() : Unit(Edge(i, hull.GetNeighbor(i, rng.Below(neighbors))));
    }

    /// <summary>A direction orthogonal to an edge: both ends are level.</summary>
    private Double3 AcrossAnEdge() => Unit(Double3.Cross(AlongAnEdge(), (Double3)rng.UnitVector()));

    /// <summary>A direction whose stretched components are exactly between two cells, or on the edge of the
    /// cube.</summary>
    private Double3 OnACellBorder()
    {
        int side = Math.Max(1, hull.Cells.Side);
        double u = 2.0 * rng.Below(side + 1) / side - 1, w = rng.Below(2) == 0 ? 1 : -1;
        double v = rng.Below(2) == 0 ? rng.Range(-1, 1) : 2.0 * rng.Below(side + 1) / side - 1;
        Double3 s = rng.Below(3) switch
        {
            0 => new Double3(w, u, v),
            1 => new Double3(u, w, v),
            _ => new Double3(u, v, w),
        };
        Double3 stretch = hull.Cells.Stretch;
        return new Double3(Over(s.X, stretch.X), Over(s.Y, stretch.Y), Over(s.Z, stretch.Z));
    }

    private Double3 Near(in Double3 d) =>
        d + (Double3)rng.UnitVector() * (d.Length * Math.Pow(10, rng.Range(-18, -1)));

    /// <summary>Some components 0, 1e-20 of the length, or denormal.</summary>
    private Double3 WithoutSome(in Double3 d) => new(Less(d.X), Less(d.Y), Less(d.Z));

    private double Less(double x) => rng.Below(6) switch
    {
        0 => 0,
        1 => x * 1e-20,
        2 => Math.CopySign(5e-324 * (1 + rng.Below(9)), x),
        _ => x,
    };

    private static double Over(double x, double stretch) => stretch > 0 ? x / stretch : x;

    private Double3 Edge(int a, int b)
    {
        hull.GetVertex(a, out Double3 p);
        hull.GetVertex(b, out Double3 q);
        return q - p;
    }

    private static Double3 Unit(in Double3 v)
    {
        // Edges of the longest and shortest floats: their squares are doubles, products of two cross products are not.
        double largest = Math.Max(Math.Max(Math.Abs(v.X), Math.Abs(v.Y)), Math.Abs(v.Z));
        if (!(largest > 0)) return new Double3(1, 0, 0);
        Double3 d = v * (1 / largest);
        return d * (1 / d.Length);
    }
}
