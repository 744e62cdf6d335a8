using System;
using Gjk.Core.Tests.Support;

namespace Gjk.Core.Tests;

/// <summary>
/// Directions in which a look-up can go wrong: normals of faces and edges, borders of cells, axes, tiny and missing
/// components, and everything close to these.
/// </summary>
internal sealed class LookupDirections(ConvexHull hull, Rng rng)
{
    private const int Kinds = 8;

    public Vector3D Next()
    {
        Vector3D d = Plain();
        if (rng.Below(3) == 0) d = Near(d);
        if (rng.Below(6) == 0) d = WithoutSome(d);
        return rng.Below(8) == 0 ? d * Math.Pow(2, rng.Below(1400) - 700) : d;
    }

    private Vector3D Plain() => rng.Below(Kinds) switch
    {
        0 => Axis(),
        1 => FaceNormal(),
        2 => AcrossAnEdge(),
        3 => OnACellBorder(),
        4 => AlongAnEdge(),
        5 => new Vector3D(rng.Below(7) - 3, rng.Below(7) - 3, rng.Below(7) - 3),
        _ => (Vector3D)rng.Direction(),
    };

    private Vector3D Axis()
    {
        double s = rng.Below(2) == 0 ? 1 : -1;
        int axis = rng.Below(3);
        return new Vector3D(axis == 0 ? s : 0, axis == 1 ? s : 0, axis == 2 ? s : 0);
    }

    private Vector3D FaceNormal()
    {
        if (hull.TriangleCount == 0) return Axis();
        hull.GetTriangle(rng.Below(hull.TriangleCount), out int a, out int b, out int c);
        return Unit(Vector3D.Cross(Edge(a, b), Edge(a, c)));
    }

    private Vector3D AlongAnEdge()
    {
        int i = rng.Below(hull.VertexCount);
        int neighbors = hull.NeighborCount(i);
        return neighbors == 0 ? Axis() : Unit(Edge(i, hull.GetNeighbor(i, rng.Below(neighbors))));
    }

    /// <summary>A direction orthogonal to an edge: both ends are level.</summary>
    private Vector3D AcrossAnEdge() => Unit(Vector3D.Cross(AlongAnEdge(), (Vector3D)rng.Direction()));

    /// <summary>
    /// A direction whose stretched components are exactly between two cells, or on the edge of the cube.
    /// </summary>
    private Vector3D OnACellBorder()
    {
        int side = Math.Max(1, hull.Cells.Side);
        double u = 2.0 * rng.Below(side + 1) / side - 1, w = rng.Below(2) == 0 ? 1 : -1;
        double v = rng.Below(2) == 0 ? rng.Range(-1, 1) : 2.0 * rng.Below(side + 1) / side - 1;
        Vector3D s = rng.Below(3) switch
        {
            0 => new Vector3D(w, u, v),
            1 => new Vector3D(u, w, v),
            _ => new Vector3D(u, v, w),
        };
        Vector3D stretch = hull.Cells.Stretch;
        return new Vector3D(Over(s.X, stretch.X), Over(s.Y, stretch.Y), Over(s.Z, stretch.Z));
    }

    private Vector3D Near(in Vector3D d) =>
        d + (Vector3D)rng.Direction() * (d.Length * Math.Pow(10, rng.Range(-18, -1)));

    /// <summary>Some components 0, 1e-20 of the length, or denormal.</summary>
    private Vector3D WithoutSome(in Vector3D d) => new(Less(d.X), Less(d.Y), Less(d.Z));

    private double Less(double x) => rng.Below(6) switch
    {
        0 => 0,
        1 => x * 1e-20,
        2 => Math.CopySign(5e-324 * (1 + rng.Below(9)), x),
        _ => x,
    };

    private static double Over(double x, double stretch) => stretch > 0 ? x / stretch : x;

    private Vector3D Edge(int a, int b)
    {
        hull.GetVertex(a, out Vector3D p);
        hull.GetVertex(b, out Vector3D q);
        return q - p;
    }

    private static Vector3D Unit(in Vector3D v)
    {
        // Edges of the longest and shortest floats: their squares are doubles, products of two cross products are not.
        double largest = Math.Max(Math.Max(Math.Abs(v.X), Math.Abs(v.Y)), Math.Abs(v.Z));
        if (!(largest > 0)) return new Vector3D(1, 0, 0);
        Vector3D d = v * (1 / largest);
        return d * (1 / d.Length);
    }
}
