namespace Gjk.Import;

/// <summary>Says when a part is not what its hull is. A scene's mesh is the hull of its vertices, so a concave part
/// gets larger. The test compares the volume inside its triangles with the hull's.</summary>
internal static class Convexity
{
    /// <summary>Share of the hull's volume. A convex part with rounded vertices lacks less than this; ConvexityTests
    /// pins it.</summary>
    private const double Tolerance = 1e-4;

    /// <summary>A line for the user, or null if the part is convex.</summary>
    public static string? Warning(ImportedMesh part)
    {
        if (part.Triangles.Count == 0)
            return part.Vertices.Count < 4 ? null : "has no faces: it is taken as the hull of its points";
        ConvexHull hull = part.Hull;
        if (hull.Dimension < 3) return FlatWarning(part, hull);
        if (!IsClosed(part))
            return "is not closed, so whether it is convex is not known: "
                + "as a convex shape it is the hull of its points";

        double share = Math.Abs(Volume(part, hull.Center)) / Volume(hull);
        return share >= 1 - Tolerance && share <= 1 + Tolerance ? null : "is not convex: " + Shares(share);
    }

    private static string Shares(double share)
    {
        string percent = (share * 100).ToString("0.##", CultureInfo.InvariantCulture);
        return share > 1
            ? $"its triangles overlap and enclose {percent} % of its hull's volume; as a convex shape it is its hull"
            : $"it fills {percent} % of its hull's volume; as a convex shape it is its hull";
    }

    /// <summary>The area of one side stands for the volume.</summary>
    private static string? FlatWarning(ImportedMesh part, ConvexHull hull)
    {
        if (hull.Dimension < 2) return null;
        double area = 0, hullArea = 0;
        for (int i = 0; i < part.Triangles.Count; i += 3)
            area += Area(Corner(part, i), Corner(part, i + 1), Corner(part, i + 2));
        for (int i = 0; i < hull.TriangleCount; i++)
        {
            hull.GetTriangle(i, out int a, out int b, out int c);
            hullArea += Area(hull.GetVertex(a), hull.GetVertex(b), hull.GetVertex(c));
        }

        // The hull has both sides; a part has one of them or both.
        double share = 2 * area / hullArea;
        if (IsWhole(share) || IsWhole(share / 2)) return null;
        return "is flat, and its triangles do not fill its outline once: "
                + "as a convex shape it is the hull of its points";
    }

    private static bool IsWhole(double share) => Math.Abs(share - 1) <= Tolerance;

    /// <summary>True if every edge is used as often in one direction as in the other.</summary>
    private static bool IsClosed(ImportedMesh part)
    {
        var open = new Dictionary<(int, int), int>();
        for (int i = 0; i < part.Triangles.Count; i += 3)
        {
            for (int k = 0; k < 3; k++)
            {
                int a = part.Triangles[i + k], b = part.Triangles[i + (k + 1) % 3];
                if (a == b) continue;
                (int, int) edge = a < b ? (a, b) : (b, a);
                open[edge] = open.GetValueOrDefault(edge) + (a < b ? 1 : -1);
            }
        }

        foreach (int count in open.Values)
        {
            if (count != 0) return false;
        }

        return true;
    }

    /// <summary>The sum of signed tetrahedra about a point that lies near, so that far meshes lose nothing.</summary>
    private static double Volume(ImportedMesh part, Double3 near)
    {
        double six = 0;
        for (int i = 0; i < part.Triangles.Count; i += 3)
            six += Six(Corner(part, i) - near, Corner(part, i + 1) - near, Corner(part, i + 2) - near);
        return six / 6;
    }

    private static double Volume(ConvexHull hull)
    {
        double six = 0;
        for (int i = 0; i < hull.TriangleCount; i++)
        {
            hull.GetTriangle(i, out int a, out int b, out int c);
            six += Six(
                hull.GetVertex(a) - hull.Center, hull.GetVertex(b) - hull.Center, hull.GetVertex(c) - hull.Center);
        }

        return six / 6;
    }

    private static Double3 Corner(ImportedMesh part, int i) => part.Vertices[part.Triangles[i]];

    private static double Six(in Double3 a, in Double3 b, in Double3 c) => Double3.Dot(a, Double3.Cross(b, c));

    private static double Area(in Double3 a, in Double3 b, in Double3 c) => Double3.Cross(b - a, c - a).Length / 2;
}
