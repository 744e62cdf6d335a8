namespace Gjk.Exact.Scenes;

/// <summary>The mesh of the built-in spheres.</summary>
public enum SphereMesh
{
    /// <summary>515 distinct corners, evenly distributed.</summary>
    Even,

    /// <summary>515 vertices, of which 386 are distinct, as in the sphere that Unity brings along.</summary>
    Unity,
}

/// <summary>Generates spheres. Only uses additions, multiplications, divisions and square roots, whose rounding IEEE
/// 754 defines. So the bits are the same on every machine.</summary>
public static class SphereMeshes
{
    /// <summary>Vertices in the list of either mesh.</summary>
    private const int Count = 515;

    /// <summary>Squares along the edge of each of the cube's faces. Eight give the 386 corners and 768 triangles of
    /// Unity's sphere.</summary>
    private const int Squares = 8;

    public static Vector3[] Vertices(SphereMesh mesh, double radius) =>
        mesh == SphereMesh.Unity ? Cube(radius) : Spiral(Count, radius);

    /// <summary>A Fibonacci sphere. Each vertex lies one golden angle further about the axis and one equal slice lower
    /// (Swinbank and Purser 2006).</summary>
    public static Vector3[] Spiral(int count, double radius)
    {
        // Cosine and sine of the golden angle, pi (3 - sqrt 5). They are constants, because the sine of two machines
        // may differ in the last bit.
        const double cos = -0.7373688780783197, sin = 0.6754902942615238;
        var vertices = new Vector3[count];
        double x = 1, z = 0;
        for (int i = 0; i < vertices.Length; i++)
        {
            double y = 1 - (2 * i + 1) / (double)count, ring = Math.Sqrt(1 - y * y);
            vertices[i] = new Vector3((float)(radius * ring * x), (float)(radius * y), (float)(radius * ring * z));
            (x, z) = (x * cos - z * sin, x * sin + z * cos);
        }

        return vertices;
    }

    /// <summary>The corners of a cube's faces, cut into squares and brought to the sphere. Unity repeats 129 of its
    /// corners, where its texture has a seam. Which ones they are changes no answer, because a hull drops repeats. Here
    /// the first ones are repeated.</summary>
    private static Vector3[] Cube(double radius)
    {
        var vertices = new List<Vector3>(Count);
        for (int x = 0; x <= Squares; x++)
        {
            for (int y = 0; y <= Squares; y++)
            {
                bool isInside = x is > 0 and < Squares && y is > 0 and < Squares;
                for (int z = 0; z <= Squares; z += isInside ? Squares : 1)
                {
                    var corner = new Double3(2 * x - Squares, 2 * y - Squares, 2 * z - Squares);
                    vertices.Add((Vector3)(corner * (radius / corner.Length)));
                }
            }
        }

        for (int i = 0; vertices.Count < Count; i++) vertices.Add(vertices[i]);
        return [.. vertices];
    }
}
