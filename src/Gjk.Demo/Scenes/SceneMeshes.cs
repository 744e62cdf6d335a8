using Gjk.Demo.Replay;

namespace Gjk.Demo.Scenes;

/// <summary>The "meshes" of a scene, and the hulls and surfaces of those that its objects name.</summary>
internal sealed class SceneMeshes
{
    /// <summary>A mesh file of more vertices takes seconds to build, so that a terminal shows progress.</summary>
    private const int ManyVertices = 100_000;

    private readonly Dictionary<string, List<Vector3>> _vertices = [];
    private readonly Dictionary<string, List<int>> _triangles = [];
    private readonly Dictionary<string, ConvexShape> _hulls = [];
    private readonly Dictionary<string, TriangleMesh> _surfaces = [];

    /// <summary>Reads the field.</summary>
    public void Read(ref StrictJsonReader json)
    {
        var seen = new HashSet<string>();
        json.BeginObject("an object of vertex arrays");
        while (json.NextField(seen, out string mesh))
        {
            json.Value();
            if (json.IsArray) ReadVertices(ref json, mesh);
            else ReadMesh(ref json, mesh);
            json.EndField();
        }
    }

    /// <summary>Builds the hulls of all meshes that an object names. Many vertices take a while.</summary>
    /// <param name="names">The meshes whose hulls are needed; repeats and unknown names are fine.</param>
    /// <param name="title">What the progress is of.</param>
    public void BuildHulls(IEnumerable<string> names, string title)
    {
        string[] used = [.. names.Where(name => _vertices.ContainsKey(name) && !_hulls.ContainsKey(name)).Distinct()];
        long vertices = used.Sum(name => (long)_vertices[name].Count);
        if (vertices <= ManyVertices) Build(_ => { });
        else ProgressBar.Show(bars => Build(bars.Add($"{title}: hulls")));

        void Build(Action<double> progress)
        {
            long done = 0;
            foreach (string name in used)
            {
                _hulls.Add(name, ConvexShape.Mesh(_vertices[name]));
                done += _vertices[name].Count;
                progress((double)done / vertices);
            }
        }
    }

    /// <summary>The hull of a mesh; all objects that name it share it.</summary>
    /// <param name="json">At the shape.</param>
    /// <param name="name">The mesh's name.</param>
    public ConvexShape Hull(in StrictJsonReader json, string name)
    {
        if (_hulls.TryGetValue(name, out ConvexShape known)) return known;
        json.Path.Enter("mesh");
        throw json.Refuse($"there is no mesh \"{name}\" in \"meshes\"");
    }

    /// <summary>The triangles of a mesh; all objects that name it share them.</summary>
    /// <inheritdoc cref="Hull"/>
    public TriangleMesh Surface(in StrictJsonReader json, string name)
    {
        if (_surfaces.TryGetValue(name, out TriangleMesh? known)) return known;
        if (!_triangles.TryGetValue(name, out List<int>? triangles))
        {
            json.Path.Enter("mesh");
            throw json.Refuse(
                _vertices.ContainsKey(name)
                    ? $"the mesh \"{name}\" has no triangles"
                    : $"there is no mesh \"{name}\" in \"meshes\"");
        }

        var mesh = new TriangleMesh(_vertices[name], triangles);
        _surfaces.Add(name, mesh);
        return mesh;
    }

    private void ReadVertices(ref StrictJsonReader json, string mesh)
    {
        var vertices = new List<Vector3>();
        json.BeginArray("an array of vertices");
        while (json.NextElement(vertices.Count)) vertices.Add(json.Vector());
        if (vertices.Count == 0) throw json.Refuse("a mesh needs at least one vertex");
        _vertices.Add(mesh, vertices);
    }

    private void ReadMesh(ref StrictJsonReader json, string mesh)
    {
        var seen = new HashSet<string>();
        json.BeginObject("an array of vertices, or an object with \"vertices\" and \"triangles\"");
        while (json.NextField(seen, out string field))
        {
            if (field is not ("vertices" or "triangles")) throw json.Refuse("unknown field");
            json.Value();
            if (field == "vertices") ReadVertices(ref json, mesh);
            else ReadTriangles(ref json, mesh);
            json.EndField();
        }

        foreach (string required in (ReadOnlySpan<string>)["vertices", "triangles"])
        {
            if (seen.Contains(required)) continue;
            json.Path.Enter(required);
            throw json.Refuse("missing");
        }

        json.Path.Enter("triangles");
        CheckIndices(json, _triangles[mesh], _vertices[mesh].Count);
        json.Path.Leave();
    }

    private void ReadTriangles(ref StrictJsonReader json, string mesh)
    {
        const string what = "three vertex indices [i, j, k]";
        var triangles = new List<int>();
        json.BeginArray("an array of triangles");
        for (int i = 0; json.NextElement(i); i++)
        {
            json.BeginArray(what);
            int count = 0;
            for (; json.NextElement(count); count++)
            {
                if (count == 3)
                {
                    json.Path.Leave();
                    throw json.Refuse($"must be {what}, but has more elements");
                }

                triangles.Add(json.Whole("a vertex's index, a whole number"));
            }

            if (count < 3) throw json.Refuse($"must be {what}, but has {count} element{(count == 1 ? "" : "s")}");
        }

        if (triangles.Count == 0) throw json.Refuse("at least one triangle is needed");
        _triangles.Add(mesh, triangles);
    }

    private static void CheckIndices(in StrictJsonReader json, List<int> triangles, int vertices)
    {
        for (int i = 0; i < triangles.Count; i++)
        {
            if ((uint)triangles[i] < (uint)vertices) continue;
            json.Path.Enter(i / 3);
            json.Path.Enter(i % 3);
            throw json.Refuse(
                $"there is no vertex {triangles[i]}: the mesh has {vertices}, counted from 0");
        }
    }
}
