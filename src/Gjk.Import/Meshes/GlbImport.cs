using System.Text.Json;

namespace Gjk.Import;

/// <summary>Imports a GLB or .gltf file: every mesh of its scene's visible nodes, in its place. Materials, animations
/// and the like are no shapes.</summary>
internal sealed class GlbImport
{
    /// <summary>Extensions that do not change where the vertices are, or whose change is read.</summary>
    private static readonly string[] Harmless =
        [
        "KHR_materials_", "KHR_texture_", "KHR_lights_punctual", "KHR_mesh_quantization", "KHR_node_visibility",
        "KHR_xmp", "EXT_texture_",
    ];

    private readonly GlbFile _file;
    private readonly string _name;
    private readonly SceneBuilder _scene;
    private readonly ImportLog _log;
    private readonly CancellationToken _cancel;
    private readonly List<JsonElement> _nodes;
    private readonly HashSet<int> _seen = [];
    private readonly GlbMeshes _meshes;

    private GlbImport(GlbFile file, string name, SceneBuilder scene, ImportLog log, CancellationToken cancel)
    {
        _file = file;
        _name = name;
        _scene = scene;
        _log = log;
        _cancel = cancel;
        _nodes = file.List("nodes");
        _meshes = new GlbMeshes(file, name, log);
    }

    public static void Import(string file, GlbFile glb, SceneBuilder scene, ImportLog log, CancellationToken cancel)
    {
        var import = new GlbImport(glb, file, scene, log, cancel);
        import.CheckExtensions();
        import.Walk();
    }

    /// <summary>A file says itself which extensions it cannot be read without.</summary>
    private void CheckExtensions()
    {
        foreach (JsonElement extension in _file.List("extensionsRequired"))
        {
            string name = _file.TextOf(extension, "extensionsRequired");
            if (!Array.Exists(Harmless, h => name.StartsWith(h, StringComparison.Ordinal)))
                throw _file.Refuse("extensionsRequired", $"{name} is not read");
        }
    }

    private void Walk()
    {
        var open = new Stack<(int Node, Affine Parent)>();
        List<int> roots = Roots();
        for (int i = roots.Count - 1; i >= 0; i--) open.Push((roots[i], Affine.Identity));
        while (open.TryPop(out (int Node, Affine Parent) next))
        {
            _cancel.ThrowIfCancellationRequested();
            string where = $"nodes[{next.Node}]";
            _file.Checked(next.Node, _nodes.Count, "node", where);
            if (!_seen.Add(next.Node)) throw _file.Refuse(where, "it is reached twice");
            JsonElement node = _nodes[next.Node];
            if (node.ValueKind != JsonValueKind.Object) throw _file.Refuse(where, "must be an object");
            if (IsInvisible(node, where)) continue;
            Affine world = next.Parent * Local(node, where);
            AddMesh(node, next.Node, world, where);
            List<JsonElement> children = _file.List(node, "children", where);
            for (int i = children.Count - 1; i >= 0; i--) open.Push((Index(children[i], where), world));
        }
    }

    /// <summary>The nodes of the default scene. Without a scene, all nodes that are no children.</summary>
    private List<int> Roots()
    {
        var roots = new List<int>();
        List<JsonElement> scenes = _file.List("scenes");
        if (scenes.Count > 0)
        {
            int scene = _file.Checked(_file.Index(_file.Root, "scene", "scene") ?? 0, scenes.Count, "scene", "scene");
            string where = $"scenes[{scene}]";
            foreach (JsonElement node in _file.List(scenes[scene], "nodes", where)) roots.Add(Index(node, where));
            return roots;
        }

        var children = new HashSet<int>();
        for (int i = 0; i < _nodes.Count; i++)
        {
            string where = $"nodes[{i}]";
            foreach (JsonElement child in _file.List(_nodes[i], "children", where)) children.Add(Index(child, where));
        }

        for (int i = 0; i < _nodes.Count; i++)
        {
            if (!children.Contains(i)) roots.Add(i);
        }

        return roots;
    }

    private int Index(JsonElement value, string where) =>
        value.ValueKind == JsonValueKind.Number && value.TryGetInt32(out int index) && index >= 0
            ? index
            : throw _file.Refuse(where, "must name nodes by whole numbers, at least 0");

    private Affine Local(JsonElement node, string where)
    {
        if (_file.Numbers(node, "matrix", 16, where) is { } m)
            return new Affine(
                new(m[0], m[1], m[2]), new(m[4], m[5], m[6]), new(m[8], m[9], m[10]), new(m[12], m[13], m[14]));
        double[] t = _file.Numbers(node, "translation", 3, where) ?? [0, 0, 0];
        double[] r = _file.Numbers(node, "rotation", 4, where) ?? [0, 0, 0, 1];
        double[] s = _file.Numbers(node, "scale", 3, where) ?? [1, 1, 1];
        TurnD turn = new TurnD(r[0], r[1], r[2], r[3]).Normalized();
        if (!double.IsFinite(turn.W)) throw _file.Refuse($"{where}.rotation", "a quaternion of length 0");
        return Affine.Of(new(t[0], t[1], t[2]), turn, new(s[0], s[1], s[2]));
    }

    /// <summary>An invisible node hides all below it, as an inactive object does in Unity.</summary>
    private bool IsInvisible(JsonElement node, string where)
    {
        bool isInvisible = _file.TryObject(node, "extensions", where, out JsonElement extensions)
            && _file.TryObject(extensions, "KHR_node_visibility", where, out JsonElement visibility)
            && visibility.TryGetProperty("visible", out JsonElement visible)
            && visible.ValueKind == JsonValueKind.False;
        if (isInvisible)
            _log.Warn($"{_name}: {where}", "it is not visible, so it is left out with all below it");
        return isInvisible;
    }

    private void AddMesh(JsonElement node, int number, Affine world, string where)
    {
        if (_file.TryObject(node, "extensions", where, out JsonElement extensions)
            && extensions.TryGetProperty("EXT_mesh_gpu_instancing", out _))
            _log.CannotRead($"{_name}: {where}", "the copies of EXT_mesh_gpu_instancing are not read");
        if (_file.Index(node, "mesh", where) is not { } mesh) return;
        if (_file.Index(node, "skin", where) is not null)
        {
            // The node's own place does not move a skinned mesh (glTF 2.0, section 3.7.3.3).
            _log.Warn($"{_name}: {where}", "it is a skinned mesh, taken in its bind pose");
            world = Affine.Identity;
        }

        string name = _file.Text(node, "name") is { Length: > 0 } given
            ? given
            : "node " + number.ToString(CultureInfo.InvariantCulture);
        List<GlbPart> parts = _meshes.Parts(mesh, where);
        bool isSingle = parts.FindAll(p => p.Mesh is not null).Count == 1;
        for (int i = 0; i < parts.Count; i++)
        {
            try
            {
                string own = isSingle ? name : $"{name}/{i}";
                if (parts[i].Mesh is { } part) _scene.AddMesh(own, part, world, world.Rotation());
                else _log.CannotRead($"{_name}: {where}: {parts[i].Where}", parts[i].Fault!);
            }
            catch (UnreadableException e)
            {
                _log.CannotRead($"{_name}: {where}", e.Message);
            }
        }
    }
}
