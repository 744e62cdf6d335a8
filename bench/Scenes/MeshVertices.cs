namespace Gjk.Bench.Scenes;

/// <summary>Vertex lists like those of a game engine's built-in meshes.</summary>
public static class MeshVertices
{
    /// <summary>The eight corners of a box.</summary>
    public static Vector3[] Box(Vector3 half)
    {
        var vertices = new Vector3[8];
        for (int i = 0; i < 8; i++)
            vertices[i] = half * new Vector3((i & 1) == 0 ? -1 : 1, (i & 2) == 0 ? -1 : 1, (i & 4) == 0 ? -1 : 1);
        return vertices;
    }

    /// <summary>24 vertices. Each corner appears three times, once per face that meets there.</summary>
    public static Vector3[] Cube(float half)
    {
        Vector3[] corners = Box(new Vector3(half));
        var vertices = new Vector3[24];
        for (int axis = 0, n = 0; axis < 3; axis++)
            for (int side = 0; side < 2; side++)
                for (int i = 0; i < 8; i++)
                    if ((i >> axis & 1) == side) vertices[n++] = corners[i];
        return vertices;
    }

    /// <summary>Two poles and rings between them, about the y axis. The report's 515 vertices are 19 rings of
    /// 27.</summary>
    public static Vector3[] Sphere(float radius, int rings = 19, int perRing = 27) =>
        Capsule(radius, 0, rings, perRing);

    /// <summary>A sphere whose halves are moved apart along y. With an even number of rings, no ring lies on the
    /// equator.</summary>
    public static Vector3[] Capsule(float radius, float halfHeight, int rings = 20, int perRing = 27)
    {
        var vertices = new Vector3[rings * perRing + 2];
        vertices[0] = new Vector3(0, radius + halfHeight, 0);
        for (int ring = 0, n = 1; ring < rings; ring++)
        {
            double polar = Math.PI * (ring + 1) / (rings + 1);
            for (int i = 0; i < perRing; i++)
            {
                double angle = 2 * Math.PI * i / perRing;
                double x = Math.Sin(polar) * Math.Cos(angle), z = Math.Sin(polar) * Math.Sin(angle);
                double y = radius * Math.Cos(polar) + (2 * ring < rings ? halfHeight : -halfHeight);
                vertices[n++] = new Vector3((float)(radius * x), (float)y, (float)(radius * z));
            }
        }

        vertices[vertices.Length - 1] = new Vector3(0, -radius - halfHeight, 0);
        return vertices;
    }

    /// <summary>Random points on an ellipsoid. Every one of them is a corner of the hull.</summary>
    public static Vector3[] OnEllipsoid(Prng prng, int count, Vector3 radii)
    {
        var vertices = new Vector3[count];
        for (int i = 0; i < count; i++) vertices[i] = radii * prng.UnitVector();
        return vertices;
    }
}
