using Gjk.Demo.View;

namespace Gjk.Demo.Trace;

/// <summary>The surface of the Minkowski difference of two cores, as a mesh to draw. With few corners it is the hull of
/// all differences of corners. Otherwise it is the hull of support points in many directions, including all directions
/// that the query asked for.</summary>
internal static class DifferenceMesh
{
    /// <summary>The most differences of corners of which all are hulled.</summary>
    private const int MostCorners = 4096;

    /// <summary>Directions about an axis, and from pole to pole. The steps are 7.5 degrees.</summary>
    private const int Meridians = 48, Parallels = 24;

    /// <param name="a">The first shape.</param>
    /// <param name="b">The second shape.</param>
    /// <param name="bInA">The frame of the second shape, seen from the first.</param>
    /// <param name="unit">The factor by which points are multiplied, so that they fit into floats at any size.</param>
    /// <param name="known">Points of the difference that the query found.</param>
    public static ShapeMesh Of(
        in ConvexShape a, in ConvexShape b, in RelativeFrame bInA, double unit, IEnumerable<Double3> known)
    {
        List<Double3>? cornersA = Corners(a), cornersB = Corners(b);
        var points = new List<Vector3>();
        bool isExact = cornersA is not null && cornersB is not null && cornersA.Count * cornersB.Count <= MostCorners;
        if (isExact)
        {
            foreach (Double3 corner in cornersA!)
            {
                foreach (Double3 other in cornersB!) points.Add((Vector3)((corner - bInA.Place(other)) * unit));
            }
        }
        else
        {
            for (int row = 0; row <= Parallels; row++)
            {
                (double up, double outward) = Math.SinCos(Math.PI * row / Parallels - Math.PI / 2);
                for (int i = 0; i < Meridians; i++)
                {
                    (double z, double x) = Math.SinCos(2 * Math.PI * i / Meridians);
                    points.Add((Vector3)(Support(a, b, bInA, new Double3(outward * x, up, outward * z)) * unit));
                }
            }
        }

        foreach (Double3 vertex in known) points.Add((Vector3)(vertex * unit));
        return ShapeMesh.Of(new ConvexHull(points), isSmooth: !isExact && (cornersA is null || cornersB is null));
    }

    private static Double3 Support(in ConvexShape a, in ConvexShape b, in RelativeFrame bInA, in Double3 direction)
    {
        a.Support(direction, out Double3 onA);
        b.Support(-bInA.InverseTurn(direction), out Double3 onB);
        return a.Center + onA - bInA.Place(b.Center + onB);
    }

    /// <summary>The vertices of the core, or null if it has none.</summary>
    private static List<Double3>? Corners(in ConvexShape shape)
    {
        var corners = new List<Double3>();
        for (int id = 0; shape.TryGetVertex(id, out Double3 corner); id++) corners.Add(shape.Center + corner);
        return corners.Count > 0 ? corners : null;
    }
}
