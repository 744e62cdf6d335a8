using System;
using System.Collections.Generic;
using System.Globalization;
using System.Numerics;
using System.Text;

namespace Gjk.Unity.Pack;

/// <summary>Writes a scene as Unity's YAML: a document for each object and component, its class and its file id in the
/// header.</summary>
public sealed class SceneWriter
{
    /// <summary>File ids of a game object's parts follow its own; an object has fewer parts than this.</summary>
    private const int IdsPerObject = 10;

    private const string BuiltInMeshes = "0000000000000000e000000000000000";
    private const string BuiltInMaterials = "0000000000000000f000000000000000";
    private const int DefaultMaterial = 10303;

    private readonly StringBuilder _text = new("%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n");
    private readonly List<Node> _nodes = [];

    /// <summary>Unity's own meshes, by file id.</summary>
    public enum BuiltInMesh
    {
        Cube = 10202,
        Cylinder = 10206,
        Sphere = 10207,
        Capsule = 10208,
    }

    /// <summary>Adds a game object and returns its file id.</summary>
    public int Add(
        string name, Vector3 position, Quaternion rotation = default, int parent = 0, bool isActive = true,
        string tag = "Untagged")
    {
        var node = new Node
        {
            Id = (_nodes.Count + 1) * IdsPerObject,
            Name = name,
            Tag = tag,
            IsActive = isActive,
            Position = position,
            Rotation = rotation == default ? Quaternion.Identity : rotation,
            Parent = parent,
        };
        _nodes.Add(node);
        return node.Id;
    }

    /// <summary>Shows a mesh with the default material.</summary>
    public void AddMesh(int owner, BuiltInMesh mesh)
    {
        AddPart(owner, 33, "MeshFilter", $"  m_Mesh: {{fileID: {(int)mesh}, guid: {BuiltInMeshes}, type: 0}}\n");
        AddPart(
            owner, 23, "MeshRenderer",
            "  m_Enabled: 1\n  m_CastShadows: 1\n  m_ReceiveShadows: 1\n  m_Materials:\n"
            + $"  - {{fileID: {DefaultMaterial}, guid: {BuiltInMaterials}, type: 0}}\n");
    }

    public void AddCamera(int owner) =>
        AddPart(
            owner, 20, "Camera",
            "  m_Enabled: 1\n  serializedVersion: 2\n  m_ClearFlags: 2\n"
            + "  m_BackGroundColor: {r: 0.1, g: 0.1, b: 0.12, a: 0}\n"
            + "  near clip plane: 0.3\n  far clip plane: 1000\n  field of view: 60\n  orthographic: 0\n");

    public void AddLight(int owner) =>
        AddPart(
            owner, 108, "Light",
            "  m_Enabled: 1\n  serializedVersion: 10\n  m_Type: 1\n  m_Color: {r: 1, g: 1, b: 1, a: 1}\n"
            + "  m_Intensity: 1\n");

    /// <summary>Adds a script; its fields are lines of YAML without indentation.</summary>
    public void AddScript(int owner, string guid, params string[] fields)
    {
        string body = "  m_Enabled: 1\n  m_EditorHideFlags: 0\n"
            + $"  m_Script: {{fileID: 11500000, guid: {guid}, type: 3}}\n"
            + "  m_Name: \n  m_EditorClassIdentifier: \n";
        AddPart(owner, 114, "MonoBehaviour", body + string.Concat(Array.ConvertAll(fields, f => $"  {f}\n")));
    }

    public override string ToString()
    {
        for (int i = 0; i < _nodes.Count; i++) Write(_nodes[i], i);
        return _text.ToString();
    }

    private static string Text(Vector3 v) => string.Create(
        CultureInfo.InvariantCulture, $"{{x: {v.X}, y: {v.Y}, z: {v.Z}}}");

    private static string Text(Quaternion q) => string.Create(
        CultureInfo.InvariantCulture, $"{{x: {q.X}, y: {q.Y}, z: {q.Z}, w: {q.W}}}");

    private static int TransformOf(int owner) => owner == 0 ? 0 : owner + 1;

    private void AddPart(int owner, int kind, string type, string body)
    {
        Node node = _nodes[owner / IdsPerObject - 1];
        int id = TransformOf(owner) + 1 + node.Parts.Count;
        node.Parts.Add((id, $"--- !u!{kind} &{id}\n{type}:\n{Owned(owner)}{body}"));
    }

    private static string Owned(int owner) => $"{Common}  m_GameObject: {{fileID: {owner}}}\n";

    private const string Common =
        "  m_ObjectHideFlags: 0\n  m_CorrespondingSourceObject: {fileID: 0}\n  m_PrefabInstance: {fileID: 0}\n"
        + "  m_PrefabAsset: {fileID: 0}\n";

    private void Write(Node node, int order)
    {
        _text.Append($"--- !u!1 &{node.Id}\nGameObject:\n{Common}");
        _text.Append($"  serializedVersion: 6\n  m_Component:\n  - component: {{fileID: {TransformOf(node.Id)}}}\n");
        foreach ((int id, _) in node.Parts)
            _text.Append($"  - component: {{fileID: {id}}}\n");
        _text.Append(
            $"  m_Layer: 0\n  m_Name: {node.Name}\n  m_TagString: {node.Tag}\n  m_Icon: {{fileID: 0}}\n"
            + $"  m_NavMeshLayer: 0\n  m_StaticEditorFlags: 0\n  m_IsActive: {(node.IsActive ? 1 : 0)}\n");
        _text.Append(
            $"--- !u!4 &{TransformOf(node.Id)}\nTransform:\n{Owned(node.Id)}"
            + $"  m_LocalRotation: {Text(node.Rotation)}\n  m_LocalPosition: {Text(node.Position)}\n"
            + "  m_LocalScale: {x: 1, y: 1, z: 1}\n");
        List<Node> children = _nodes.FindAll(n => n.Parent == node.Id);
        _text.Append(children.Count == 0 ? "  m_Children: []\n" : "  m_Children:\n");
        foreach (Node child in children)
            _text.Append($"  - {{fileID: {TransformOf(child.Id)}}}\n");
        _text.Append(
            $"  m_Father: {{fileID: {TransformOf(node.Parent)}}}\n  m_RootOrder: {order}\n"
            + "  m_LocalEulerAnglesHint: {x: 0, y: 0, z: 0}\n");
        foreach ((_, string text) in node.Parts) _text.Append(text);
    }

    private sealed class Node
    {
        public required int Id { get; init; }

        public required string Name { get; init; }

        public required string Tag { get; init; }

        public required bool IsActive { get; init; }

        public required Vector3 Position { get; init; }

        public required Quaternion Rotation { get; init; }

        public required int Parent { get; init; }

        public List<(int Id, string Text)> Parts { get; } = [];
    }
}
