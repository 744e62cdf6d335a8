namespace Gjk.Core;

/// <summary>Joins the coplanar triangles of a solid hull into facets, leaves out what is not a strict corner, and cuts
/// the facets into triangles again.</summary>
/// <remarks>An edge is sharp when the faces on both sides are not coplanar. Sharp edges are the edges of the polytope,
/// or pieces of them, so a vertex with none lies inside a facet, with two it lies on an edge between two others, and
/// with three or more it is a strict corner. The sharp edges around a facet are one loop, because a facet is convex;
/// without the points that are no corners the loop is a strictly convex polygon.</remarks>
internal static class HullFacets
{
    private const int SharpEdgesOfCorner = 3;

    public static HullMesh Build(HullSurface hull, int pointCount)
    {
        bool[] isSharp = new bool[hull.HalfEdgeLimit];
        int[] sharpEdges = new int[pointCount];
        for (int h = 0; h < isSharp.Length; h++)
        {
            if (!hull.IsAlive(h)) continue;
            int twin = hull.Twin(h);
            isSharp[h] = twin < h ? isSharp[twin] : !hull.IsFlat(h);
            if (isSharp[h]) sharpEdges[hull.Origin(h)]++;
        }

        var corners = new List<int>();
        for (int i = 0; i < pointCount; i++)
        {
            if (sharpEdges[i] >= SharpEdgesOfCorner) corners.Add(i);
        }

        return new HullMesh(3, corners.ToArray(), Triangulate(hull, isSharp, sharpEdges), pointCount);
    }

    private static int[] Triangulate(HullSurface hull, bool[] isSharp, int[] sharpEdges)
    {
        var triangles = new List<int>();
        var loop = new List<int>();
        bool[] isDone = new bool[isSharp.Length];
        for (int h = 0; h < isSharp.Length; h++)
        {
            if (!isSharp[h] || isDone[h]) continue;
            int edge = h;
            do
            {
                isDone[edge] = true;
                int origin = hull.Origin(edge);
                if (sharpEdges[origin] >= SharpEdgesOfCorner) loop.Add(origin);
                edge = HullSurface.Next(edge);
                while (!isSharp[edge]) edge = HullSurface.Next(hull.Twin(edge));
            }
            while (edge != h);

            PolygonTriangles.Append(loop, triangles);
        }

        return triangles.ToArray();
    }
}
