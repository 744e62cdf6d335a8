namespace Gjk.Core;

/// <summary>Which corners share an edge of a triangle: the lists of neighbours in one array, each list
/// ascending.</summary>
internal static class HullAdjacency
{
    /// <param name="mesh">Corners and triangles.</param>
    /// <param name="start">The neighbours of corner i are those from start[i] up to, not including, start[i +
    /// 1].</param>
    /// <param name="neighbors">All lists, one after the other.</param>
    public static void Build(HullMesh mesh, out int[] start, out int[] neighbors)
    {
        int[] triangles = mesh.Triangles;
        start = new int[mesh.Corners.Length + 1];
        if (mesh.Dimension < 2)
        {
            // A point has no neighbour, the ends of a segment have each other.
            neighbors = mesh.Dimension == 0 ? [] : [1, 0];
            for (int i = 1; i < start.Length; i++) start[i] = mesh.Dimension * i;
            return;
        }

        // The surface is closed, so the edge from a to b is also an edge from b to a: each triangle tells each corner
        // of one neighbour.
        foreach (int corner in triangles) start[corner + 1]++;
        for (int i = 1; i < start.Length; i++) start[i] += start[i - 1];
        int[] filled = new int[mesh.Corners.Length];
        neighbors = new int[triangles.Length];
        for (int i = 0; i < triangles.Length; i++)
        {
            int corner = triangles[i];
            neighbors[start[corner] + filled[corner]++] = triangles[i % 3 == 2 ? i - 2 : i + 1];
        }

        SortAndCompact(start, ref neighbors);
    }

    /// <summary>In a flat hull a diagonal is an edge on both sides, and so appears twice.</summary>
    private static void SortAndCompact(int[] start, ref int[] neighbors)
    {
        int kept = 0;
        for (int i = 0; i + 1 < start.Length; i++)
        {
            int from = start[i], to = start[i + 1];
            Array.Sort(neighbors, from, to - from);
            start[i] = kept;
            for (int k = from; k < to; k++)
            {
                if (k == from || neighbors[k] != neighbors[k - 1]) neighbors[kept++] = neighbors[k];
            }
        }

        start[start.Length - 1] = kept;
        Array.Resize(ref neighbors, kept);
    }
}
