namespace Gjk.Core;

/// <summary>The slab of a flat mesh: two parallel planes with all vertices between them, and a cylinder across them
/// that holds all vertices. It bounds the mesh's reach along directions nearly across, without reading the
/// vertices.</summary>
internal sealed class MeshSlab(in Double3 normal, in Double3 middle, double low, double high, double radius)
{
    /// <summary>Ratio of the thickness to the tree's radius: a thicker mesh is not flat, and its planes would prove
    /// little. A matter of speed only.</summary>
    private const double Flat = 1e-3;

    /// <summary>Ratio to the lengths: 2^-49, 16 roundings, at least those of the products and sums below. It only
    /// increases the reach.</summary>
    private const double Error = 1.0 / (1L << 49);

    private readonly Double3 _middle = middle;

    /// <summary>A normal of the planes, a unit vector.</summary>
    public readonly Double3 Normal = normal;

    /// <summary>The slab of a mesh, or null where it is not flat.</summary>
    public static MeshSlab? Find(TriangleMesh mesh)
    {
        if (!TryGetNormal(mesh, out Double3 normal)) return null;
        Double3 middle = mesh.Tree.Origin;
        double most = Flat * mesh.Tree.Radius, low = double.PositiveInfinity, high = -low, radius = 0;
        for (int i = 0; i < mesh.VertexCount; i++)
        {
            Double3 vertex = mesh.GetScaledVertex(i);
            double along = Double3.Dot(normal, vertex);
            low = Math.Min(low, along);
            high = Math.Max(high, along);
            if (!(high - low <= most)) return null;
            radius = Math.Max(radius, (vertex - middle).Length);
        }

        return new MeshSlab(normal, middle, low, high, radius);
    }

    /// <summary>An upper bound of the mesh's reach along a direction of its frame.</summary>
    public double Reach(in Double3 direction)
    {
        double across = Double3.Dot(direction, Normal);
        Double3 rest = direction - Normal * across;
        double reach = Math.Max(across * low, across * high) + Double3.Dot(rest, _middle) + rest.Length * radius;
        return reach + Error * (Math.Abs(low) + Math.Abs(high) + _middle.SumOfMagnitudes + radius);
    }

    /// <summary>The normal of the first triangle with an area.</summary>
    private static bool TryGetNormal(TriangleMesh mesh, out Double3 normal)
    {
        for (int i = 0; i < mesh.TriangleCount; i++)
        {
            mesh.GetCorners(i, out Double3 a, out Double3 b, out Double3 c);
            normal = Double3.Cross(b - a, c - a);
            normal *= 1 / normal.Length;
            if (Guard.IsFinite(normal.SumOfMagnitudes)) return true;
        }

        normal = default;
        return false;
    }
}
