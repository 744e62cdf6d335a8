namespace Gjk.Demo.View;

/// <summary>One object as the eye sees it: the triangles that face the eye, the lines to draw, and the region that the
/// object hides.</summary>
internal sealed class PictureBody
{
    /// <summary>A mesh with more corners than this stands for something round. Drawing all its edges would cover it
    /// with a net, so only its outline is drawn.</summary>
    private const int MostEdges = 200;

    private readonly ShapeMesh _mesh;
    private readonly int[] _across;
    private readonly bool[] _faces;

    /// <param name="mesh">The surface of the object.</param>
    /// <param name="position">Converts a rotated vertex in world units to the units of the picture.</param>
    /// <param name="rotation">The rotation of the object in the world.</param>
    /// <param name="eye">The position of the eye in the units of the picture.</param>
    /// <param name="source">The object, and the triangle or part of it; -1 where it is convex.</param>
    public PictureBody(ShapeMesh mesh, Func<Double3, Double3> position, Quaternion rotation, in Double3 eye,
        (int Object, int Part) source)
    {
        Source = source;
        _mesh = mesh;
        Vertices = new Double3[mesh.Vertices.Length];
        for (int i = 0; i < Vertices.Length; i++) Vertices[i] = position(Rotated(mesh.Vertices[i], rotation));
        Center = default;
        foreach (Double3 v in Vertices) Center += v * (1.0 / Vertices.Length);
        foreach (Double3 v in Vertices) Radius = Math.Max(Radius, (v - Center).Length);
        EyeDistance = (Center - eye).Length;
        _across = mesh.Dimension > 1 ? mesh.Neighbours() : [];
        _faces = new bool[mesh.Triangles.Length / 3];
        for (int i = 0; i < _faces.Length; i++)
            _faces[i] = Double3.Dot(Normal(i), eye - Vertices[mesh.Triangles[3 * i]]) > 0;
        Shadow = new Shadow(Planes(eye));
    }

    /// <summary>The object, and the triangle or part of it.</summary>
    public (int Object, int Part) Source { get; }

    public Double3[] Vertices { get; }

    public Double3 Center { get; }

    /// <summary>The radius about the centre.</summary>
    public double Radius { get; }

    /// <summary>The distance from the eye to the centre.</summary>
    public double EyeDistance { get; }

    public Shadow Shadow { get; }

    public int Dimension => _mesh.Dimension;

    public int TriangleCount => _faces.Length;

    public bool FacesEye(int triangle) => _faces[triangle];

    public int Corner(int triangle, int corner) => _mesh.Triangles[3 * triangle + corner];

    /// <summary>The normal of a triangle. Its length is arbitrary.</summary>
    public Double3 Normal(int triangle)
    {
        Double3 a = Vertices[Corner(triangle, 0)];
        return Double3.Cross(Vertices[Corner(triangle, 1)] - a, Vertices[Corner(triangle, 2)] - a);
    }

    /// <summary>The lines to draw, each as two vertices: the outline, and the edges of a body that is not
    /// round.</summary>
    public IEnumerable<(int From, int To)> Lines()
    {
        if (_mesh.Dimension == 1) yield return (0, 1);
        var corners = new HashSet<(int, int)>();
        bool drawsEdges = _mesh.Edges.Length <= 2 * MostEdges;
        for (int i = 0; drawsEdges && i < _mesh.Edges.Length; i += 2)
            corners.Add((_mesh.Edges[i], _mesh.Edges[i + 1]));
        for (int i = 0; i < _across.Length; i++)
        {
            if (!_faces[i / 3]) continue;
            int from = _mesh.Triangles[i], to = _mesh.Triangles[ShapeMesh.Next(i)];
            bool isOutline = !_faces[_across[i]];
            if (isOutline || (from < to && corners.Contains((from, to)))) yield return (from, to);
        }
    }

    private IEnumerable<(Double3 Normal, double Value)> Planes(Double3 eye)
    {
        for (int i = 0; i < _across.Length; i++)
        {
            if (!_faces[i / 3] || _faces[_across[i]]) continue;
            Double3 from = Vertices[_mesh.Triangles[i]], to = Vertices[_mesh.Triangles[ShapeMesh.Next(i)]];
            yield return Plane(Double3.Cross(to - from, eye - from), eye);
        }

        for (int i = 0; i < _faces.Length; i++)
        {
            if (_faces[i]) yield return Plane(Normal(i), Vertices[Corner(i, 0)]);
        }
    }

    private static (Double3 Normal, double Value) Plane(in Double3 normal, in Double3 through)
    {
        Double3 unit = normal * (1 / normal.Length);
        return (unit, Double3.Dot(unit, through));
    }

    /// <summary>Rotates by a quaternion in double: v + 2 u × (u × v + w v).</summary>
    private static Double3 Rotated(Double3 v, Quaternion q)
    {
        var u = new Double3(q.X, q.Y, q.Z);
        double norm = u.LengthSquared + (double)q.W * q.W;
        return v + Double3.Cross(u, Double3.Cross(u, v) + v * (double)q.W) * (2 / norm);
    }
}
