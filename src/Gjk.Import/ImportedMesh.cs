namespace Gjk.Import;

/// <summary>A mesh of a file. No two of its vertices are the same. Immutable.</summary>
public sealed class ImportedMesh
{
    private readonly Vector3[] _vertices;
    private readonly int[] _triangles;
    private ConvexHull? _hull;

    private ImportedMesh(string name, Vector3[] vertices, int[] triangles)
    {
        Name = name;
        _vertices = vertices;
        _triangles = triangles;
    }

    /// <summary>As the file names it, with a number behind it where another mesh has that name, too.</summary>
    public string Name { get; }

    /// <summary>At least one. In the frame of the mesh, all finite.</summary>
    public IReadOnlyList<Vector3> Vertices => _vertices;

    /// <summary>Three indices of vertices for each triangle. Empty if the file has only points.</summary>
    public IReadOnlyList<int> Triangles => _triangles;

    /// <summary>The hull of the vertices, built when it is first asked for.</summary>
    public ConvexHull Hull => _hull ??= new ConvexHull(_vertices);

    /// <summary>True if it has triangles that are not those of its hull, as far as can be told.</summary>
    internal bool IsConcave => _triangles.Length > 0 && Convexity.Warning(this) is not null;

    internal ImportedMesh Named(string name) => new(name, _vertices, _triangles) { _hull = _hull };

    /// <summary>The same triangles with other corners.</summary>
    internal ImportedMesh With(string name, Vector3[] vertices) => new(name, vertices, _triangles);

    /// <summary>Welds exact copies. Files repeat a vertex for every normal or texture coordinate that it has, and an
    /// STL for every triangle. Vertices that no triangle uses are dropped if there are triangles.</summary>
    /// <param name="name">The part's name.</param>
    /// <param name="vertices">As in the file.</param>
    /// <param name="triangles">Three indices each; may be empty.</param>
    internal static ImportedMesh Weld(string name, IReadOnlyList<Vector3> vertices, IReadOnlyList<int> triangles)
    {
        var distinct = new List<Vector3>();
        var known = new Dictionary<Vector3, int>();
        if (triangles.Count == 0)
        {
            foreach (Vector3 vertex in vertices) IndexOf(vertex, distinct, known);
            return new ImportedMesh(name, [.. distinct], []);
        }

        var welded = new int[triangles.Count];
        for (int i = 0; i < welded.Length; i++) welded[i] = IndexOf(vertices[triangles[i]], distinct, known);
        return new ImportedMesh(name, [.. distinct], welded);
    }

    private static int IndexOf(Vector3 vertex, List<Vector3> distinct, Dictionary<Vector3, int> known)
    {
        // -0 and 0 are equal and have one hash, so they are one vertex.
        if (known.TryGetValue(vertex, out int index)) return index;
        known.Add(vertex, distinct.Count);
        distinct.Add(vertex);
        return distinct.Count - 1;
    }
}
