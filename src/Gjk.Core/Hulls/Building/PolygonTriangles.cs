namespace Gjk.Core;

/// <summary>Cuts a strictly convex polygon into triangles.</summary>
/// <remarks>Every other corner is cut off, then every other one of those that remain, and so on. A fan would do, but
/// its centre would neighbour all corners; here no corner has more than two neighbours per round, and a walk over the
/// edges reaches any corner in a logarithmic number of steps.</remarks>
internal static class PolygonTriangles
{
    /// <summary>Appends n - 2 triangles with the polygon's sense of rotation. The loop is consumed.</summary>
    public static void Append(List<int> loop, List<int> triangles)
    {
        int count = loop.Count;
        while (count > 2)
        {
            int kept = 0;
            int first = loop[0];
            for (int i = 0; i < count; i += 2)
            {
                int corner = loop[i];
                if (i + 1 < count)
                {
                    triangles.Add(corner);
                    triangles.Add(loop[i + 1]);
                    triangles.Add(i + 2 < count ? loop[i + 2] : first);
                }

                loop[kept++] = corner;
            }

            count = kept;
        }

        loop.Clear();
    }
}
