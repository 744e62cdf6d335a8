using System;
using System.Collections.Generic;
using System.Numerics;
using System.Text.Json;

namespace Gjk.Import;

/// <summary>
/// The meshes of a GLB file. Each primitive of a mesh is a part. They are read when they are first used.
/// </summary>
internal sealed class GlbMeshes
{
    /// <summary>
    /// What a primitive's indices form (glTF 2.0, section 3.7.2.1). Lower numbers are points and lines.
    /// </summary>
    private const int Triangles = 4, Strip = 5, Fan = 6;

    private readonly GlbFile _file;
    private readonly ImportLog _log;
    private readonly string _name;
    private readonly List<JsonElement> _meshes;
    private readonly Dictionary<int, List<ImportedMesh>> _read = [];

    public GlbMeshes(GlbFile file, string name, ImportLog log)
    {
        _file = file;
        _name = name;
        _log = log;
        _meshes = file.List("meshes");
    }

    public List<ImportedMesh> Parts(int index, string where)
    {
        if (_read.TryGetValue(index, out List<ImportedMesh>? known)) return known;
        JsonElement mesh = _meshes[_file.Checked(index, _meshes.Count, "mesh", where)];
        string path = $"meshes[{index}]";
        List<JsonElement> primitives = _file.List(mesh, "primitives", path);
        string name = _file.Text(mesh, "name") is { Length: > 0 } given ? given : $"mesh {index}";
        var parts = new List<ImportedMesh>();
        for (int i = 0; i < primitives.Count; i++)
        {
            string own = primitives.Count == 1 ? name : $"{name}/{i}";
            ImportedMesh? part = Part(primitives[i], own, $"{path}.primitives[{i}]");
            if (part is null) continue;
            parts.Add(part);
            _log.WarnOf(_name, part);
        }

        _read.Add(index, parts);
        return parts;
    }

    private ImportedMesh? Part(JsonElement primitive, string name, string where)
    {
        if (_file.TryObject(primitive, "extensions", where, out JsonElement extensions)
            && extensions.TryGetProperty("KHR_draco_mesh_compression", out _))
            throw _file.Refuse(where, "is compressed with KHR_draco_mesh_compression, which is not read");
        if (!_file.TryObject(primitive, "attributes", where, out JsonElement attributes)
            || _file.Index(attributes, "POSITION", where) is not { } positions)
        {
            _log.CannotRead($"{_name}: {where}", "it has no POSITION");
            return null;
        }

        if (primitive.TryGetProperty("targets", out _))
            _log.Warn(_name, $"{where} has morph targets: it is taken without them");
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
        return ImportedMesh.Weld(name, vertices, Faces(Indices(primitive, vertices.Length, where), mode));
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
        int step = mode == Triangles ? 3 : 1;
        for (int i = 0; mode is Triangles or Strip or Fan && i + 2 < indices.Length; i += step)
        {
            bool isOdd = mode == Strip && i % 2 == 1;
            faces.Add(mode == Fan ? indices[0] : indices[i]);
            faces.Add(indices[isOdd ? i + 2 : i + 1]);
            faces.Add(indices[isOdd ? i + 1 : i + 2]);
        }

        return faces;
    }
}
