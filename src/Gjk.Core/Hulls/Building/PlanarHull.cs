namespace Gjk.Core;

/// <summary>The hull of points that lie in one plane: a strictly convex polygon, its triangles once for each
/// side.</summary>
/// <remarks>Andrew's monotone chain (1979) in a projection along a coordinate axis. Dropping a coordinate keeps a
/// plane's incidences as long as the plane is not parallel to that axis, and the projected coordinates are the given
/// floats, so exact turns in the projection are exact turns in the plane.</remarks>
internal static class PlanarHull
{
    /// <param name="predicates">Of the distinct points.</param>
    /// <param name="axisU">First axis of the projection.</param>
    /// <param name="axisV">Second axis of the projection.</param>
    public static HullMesh Build(HullPredicates predicates, int axisU, int axisV)
    {
        int count = predicates.Points.Length;
        int[] order = new int[count];
        for (int i = 0; i < count; i++) order[i] = i;
        Array.Sort(order, (i, j) =>
        {
            int byU = predicates.Coordinate(i, axisU).CompareTo(predicates.Coordinate(j, axisU));
            return byU != 0 ? byU : predicates.Coordinate(i, axisV).CompareTo(predicates.Coordinate(j, axisV));
        });

        var loop = new List<int>();
        AppendChain(predicates, order, axisU, axisV, loop);
        Array.Reverse(order);
        AppendChain(predicates, order, axisU, axisV, loop);

        int[] corners = loop.ToArray();
        Array.Sort(corners);
        return new HullMesh(2, corners, BothSides(loop), count);
    }

    /// <summary>The half of the polygon to the right of the way from the first point to the last, the last left
    /// out.</summary>
    private static void AppendChain(HullPredicates predicates, int[] order, int axisU, int axisV, List<int> loop)
    {
        int start = loop.Count;
        foreach (int p in order)
        {
            while (loop.Count >= start + 2)
            {
                int turn = predicates.Orientation(loop[loop.Count - 2], loop[loop.Count - 1], p, axisU, axisV);
                if (turn > 0) break;
                loop.RemoveAt(loop.Count - 1);
            }

            loop.Add(p);
        }

        loop.RemoveAt(loop.Count - 1);
    }

    private static int[] BothSides(List<int> loop)
    {
        var triangles = new List<int>();
        PolygonTriangles.Append(loop, triangles);
        int front = triangles.Count;
        for (int i = 0; i < front; i += 3)
        {
            triangles.Add(triangles[i]);
            triangles.Add(triangles[i + 2]);
            triangles.Add(triangles[i + 1]);
        }

        return triangles.ToArray();
    }
}
