using System.Text.Json;

namespace Gjk.Import;

/// <summary>A primitive.</summary>
/// <param name="Mesh">Null if it cannot be read.</param>
/// <param name="Where">Its place in the file.</param>
/// <param name="Fault">Why it cannot be read, or null.</param>
internal sealed record GlbPart(ImportedMesh? Mesh, string Where, string? Fault);

/// <summary>The meshes of a GLB file. Each primitive of a mesh is a part. They are read when they are first
/// used.</summary>
internal sealed class GlbMeshes
{
    /// <summary>What a primitive's indices form (glTF 2.0, section 3.7.2.1). Lower numbers are points and
    /// lines.</summary>
    private const int Triangles = 4, Strip = 5, Fan = 6;

    private readonly GlbFile _file;
    private readonly ImportLog _log;
    private readonly string _name;
    private readonly List<JsonElement> _meshes;
    private readonly Dictionary<int, List<GlbPart>> _read = [];

    public GlbMeshes(GlbFile file, string name, ImportLog log)
    {
        _file = file;
        _name = name;
        _log = log;
        _meshes = file.List("meshes");
    }

    public List<GlbPart> Parts(int index, string where)
    {
        if (_read.TryGetValue(index, out List<GlbPart>? known)) return known;
        JsonElement mesh = _meshes[_file.Checked(index, _meshes.Count, "mesh", where)];
        string path = $"meshes[{index}]";
        List<JsonElement> primitives = _file.List(mesh, "primitives", path);
        string name = _file.Text(mesh, "name") is { Length: > 0 } given ? given : $"mesh {index}";
        var parts = new List<GlbPart>();
        for (int i = 0; i < primitives.Count; i++)
        {
            string own = primitives.Count == 1 ? name : $"{name}/{i}";
            GlbPart part = Part(primitives[i], own, $"{path}.primitives[{i}]");
            parts.Add(part);
            if (part.Mesh is { } read) _log.WarnOf(_name, read);
        }

        _read.Add(index, parts);
        return parts;
    }

    private GlbPart Part(JsonElement primitive, string name, string where)
    {
        if (!_file.TryObject(primitive, "attributes", where, out JsonElement attributes)
            || _file.Index(attributes, "POSITION", where) is not { } positions)
            return new GlbPart(null, where, "it has no POSITION");

        // A file that can be read without the extension has the plain numbers, too.
        if (_file.TryObject(primitive, "extensions", where, out JsonElement extensions)
            && extensions.TryGetProperty("KHR_draco_mesh_compression", out _)
            && !GlbAccessor.HasData(_file, positions, where))
            return new GlbPart(null, where, "it is compressed with KHR_draco_mesh_compression, which is not read");

        if (primitive.TryGetProperty("targets", out _))
            _log.Warn($"{_name}: {where}", "it has morph targets, and is taken without them");
        double[] numbers = GlbAccessor.Read(_file, positions, "VEC3");
        var vertices = new Vector3[numbers.Length / 3];
        if (vertices.Length == 0) throw _file.Refuse(where, "it has no vertices");
        for (int i = 0; i < vertices.Length; i++)
        {
            var vertex = new Vector3((float)numbers[3 * i], (float)numbers[3 * i + 1], (float)numbers[3 * i + 2]);
            int number = i;
            vertices[i] = MeshText.Checked(
                vertex, () => _file.Refuse(where, $"a coordinate of vertex {number} is not a finite number"));
        }

        int mode = _file.Index(primitive, "mode", where) ?? Triangles;
        int[] indices = Indices(primitive, vertices.Length, where);
        if (mode == Triangles && indices.Length % 3 != 0)
            _log.Warn($"{_name}: {where}", "its last indices make no whole triangle, and are passed over");
        return new GlbPart(ImportedMesh.Weld(name, vertices, Faces(indices, mode)), where, null);
    }

    private int[] Indices(JsonElement primitive, int vertices, string where)
    {
        if (_file.Index(primitive, "indices", where) is not { } accessor)
        {
            var all = new int[vertices];
            for (int i = 0; i < vertices; i++) all[i] = i;
            return all;
        }

        double[] numbers = GlbAccessor.Read(_file, accessor, "SCALAR");
        return Array.ConvertAll(
            numbers, n => n >= 0 && n < vertices && n == Math.Floor(n)
                ? (int)n
                : throw _file.Refuse(where, $"there is no vertex {n}: it has {vertices}"));
    }

    private static List<int> Faces(int[] indices, int mode)
    {
        var faces = new List<int>();
        if (mode == Strip) TriangleStrip.Append(indices, faces);
        int step = mode == Triangles ? 3 : 1;
        for (int i = 0; mode is Triangles or Fan && i + 2 < indices.Length; i += step)
        {
            faces.Add(mode == Fan ? indices[0] : indices[i]);
            faces.Add(indices[i + 1]);
            faces.Add(indices[i + 2]);
        }

        return faces;
    }
}
