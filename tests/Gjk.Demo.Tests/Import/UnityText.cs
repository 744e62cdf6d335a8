using System.Globalization;
using System.Text;

namespace Gjk.Demo.Tests.Import;

/// <summary>Writes scenes and prefabs as Unity does, with only the fields that matter.</summary>
internal sealed class UnityText
{
    public const string BuiltIn = "0000000000000000e000000000000000";

    public const string Cube = "{fileID: 10202, guid: " + BuiltIn + ", type: 0}";

    public const string Sphere = "{fileID: 10207, guid: " + BuiltIn + ", type: 0}";

    private readonly StringBuilder _text = new("%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n");
    private long _last = 1000;

    public override string ToString() => _text.ToString();

    /// <summary>The line on which the next document begins.</summary>
    public int NextLine => _text.ToString().Count(c => c == '\n') + 1;

    public long NewId() => ++_last;

    public UnityText Add(int classId, long id, string body, bool stripped = false)
    {
        _text.Append(CultureInfo.InvariantCulture, $"--- !u!{classId} &{id}{(stripped ? " stripped" : "")}\n{body}\n");
        return this;
    }

    /// <summary>An object with its Transform, whose number follows that of the object.</summary>
    public UnityObject Object(
        string name, UnityObject? parent = null, Vector3? position = null, Quaternion? rotation = null,
        Vector3? scale = null, bool isActive = true)
    {
        long id = NewId();
        Add(1, id, $"GameObject:\n  serializedVersion: 6\n  m_Name: {name}\n  m_IsActive: {(isActive ? 1 : 0)}");
        return Transform(id, parent?.Transform ?? 0, position, rotation, scale);
    }

    public UnityObject Transform(
        long owner, long father, Vector3? position = null, Quaternion? rotation = null, Vector3? scale = null,
        int classId = 4)
    {
        long id = NewId();
        Quaternion q = rotation ?? Quaternion.Identity;
        string turn = $"{{x: {Text(q.X)}, y: {Text(q.Y)}, z: {Text(q.Z)}, w: {Text(q.W)}}}";
        Add(classId, id, $"""
            Transform:
              m_GameObject: {Ref(owner)}
              m_LocalRotation: {turn}
              m_LocalPosition: {Text(position ?? Vector3.Zero)}
              m_LocalScale: {Text(scale ?? Vector3.One)}
              m_Father: {Ref(father)}
            """);
        return new UnityObject(owner, id);
    }

    /// <summary>A component with these fields, one a line.</summary>
    public long Component(long owner, int classId, string type, params string[] fields)
    {
        long id = NewId();
        string lines = string.Concat(fields.Select(f => "\n  " + f.Replace("\n", "\n  ")));
        Add(classId, id, $"{type}:\n  m_GameObject: {Ref(owner)}\n  m_Enabled: 1{lines}");
        return id;
    }

    public long MeshFilter(UnityObject owner, string mesh) =>
        Component(owner.GameObject, 33, "MeshFilter", "m_Mesh: " + mesh);

    /// <summary>As the report's objects are: a mesh, a renderer and a script.</summary>
    public void ScriptCollider(UnityObject owner, string mesh)
    {
        Component(
            owner.GameObject, 114, "MonoBehaviour",
            "m_Script: " + Ref(11500000, "5d0d1ab15ea64d3f9ab8bf0a1b2c3d4e"), "m_Name: ", "radius: .inf");
        MeshFilter(owner, mesh);
        Component(owner.GameObject, 23, "MeshRenderer", "m_Materials:\n- {fileID: 10303, guid: " + BuiltIn + "}");
    }

    public long Box(UnityObject owner, Vector3? size = null, Vector3? center = null) => Component(
        owner.GameObject, 65, "BoxCollider", $"m_Size: {Text(size ?? Vector3.One)}",
        $"m_Center: {Text(center ?? Vector3.Zero)}");

    public long Ball(UnityObject owner, float radius, Vector3? center = null) => Component(
        owner.GameObject, 135, "SphereCollider", $"m_Radius: {Text(radius)}",
        $"m_Center: {Text(center ?? Vector3.Zero)}");

    public long Capsule(UnityObject owner, float radius, float height, int direction, Vector3? center = null) =>
        Component(
            owner.GameObject, 136, "CapsuleCollider", $"m_Radius: {Text(radius)}", $"m_Height: {Text(height)}",
            $"m_Direction: {direction}", $"m_Center: {Text(center ?? Vector3.Zero)}");

    /// <summary>A Mesh document with float positions and a normal, or half positions, and 16-bit triangles.</summary>
    public UnityText Mesh(
        long id, string name, Vector3[] vertices, int[] triangles, int format = 0, string fields = "")
    {
        byte[] bytes = [.. vertices.SelectMany(v => format == 0 ? Floats(v, Vector3.UnitY) : Halves(v))];
        byte[] indices = [.. triangles.SelectMany(i => BitConverter.GetBytes((ushort)i))];
        return Add(43, id, $"""
            Mesh:
              m_Name: {name}
              m_SubMeshes:
              - serializedVersion: 2
                firstByte: 0
                indexCount: {triangles.Length}
                topology: 0
                baseVertex: 0
                firstVertex: 0
                vertexCount: {vertices.Length}
              m_IndexFormat: 0
              m_IndexBuffer: {Convert.ToHexStringLower(indices)}
              m_VertexData:
                serializedVersion: 3
                m_VertexCount: {vertices.Length}
                m_Channels:
                - stream: 0
                  offset: 0
                  format: {format}
                  dimension: {(format == 0 ? 3 : 0x33)}
                - stream: 0
                  offset: {(format == 0 ? 12 : 6)}
                  format: 0
                  dimension: {(format == 0 ? 3 : 0)}
                m_DataSize: {bytes.Length}
                _typelessdata: {Convert.ToHexStringLower(bytes)}
              m_StreamData:
                offset: 0
                size: 0
                path: {fields}
            """);
    }

    /// <summary>An instance of a prefab.</summary>
    /// <param name="id">Its number.</param>
    /// <param name="guid">Of the prefab.</param>
    /// <param name="parent">A Transform, or 0.</param>
    /// <param name="changes">Target, field and value each.</param>
    /// <param name="more">More fields of m_Modification.</param>
    public UnityText Instance(
        long id, string guid, long parent, (long Target, string Path, string Value)[] changes, string more = "")
    {
        string lines = string.Concat(changes.Select(c => $"""

                - target: {Ref(c.Target, guid)}
                  propertyPath: {c.Path}
                  value: {(c.Value.StartsWith('{') ? "" : c.Value)}
                  objectReference: {(c.Value.StartsWith('{') ? c.Value : "{fileID: 0}")}
            """));
        string all = changes.Length == 0 ? " []" : lines;
        return Add(1001, id, $"""
            PrefabInstance:
              serializedVersion: 2
              m_Modification:
                m_TransformParent: {Ref(parent)}
                m_Modifications:{all}{more}
              m_SourcePrefab: {Ref(100100000, guid)}
            """);
    }

    public UnityText Stripped(int classId, long id, string type, long source, string guid, long instance) => Add(
        classId, id,
        $"{type}:\n  m_CorrespondingSourceObject: {Ref(source, guid)}\n  m_PrefabInstance: {Ref(instance)}",
        stripped: true);

    /// <summary>Writes the file and a .meta file with its GUID.</summary>
    public string Save(TempDirectory directory, string name, string guid = "")
    {
        string file = directory.File(name);
        Directory.CreateDirectory(Path.GetDirectoryName(file)!);
        if (guid.Length > 0) directory.Write(name + ".meta", $"fileFormatVersion: 2\nguid: {guid}\n");
        return directory.Write(name, ToString());
    }

    public static string Guid(int number) => number.ToString("x32", CultureInfo.InvariantCulture);

    public static string Ref(long id, string guid = "") =>
        guid.Length == 0
            ? FormattableString.Invariant($"{{fileID: {id}}}")
            : FormattableString.Invariant($"{{fileID: {id}, guid: {guid}, type: 3}}");

    public static string Text(Vector3 v) => $"{{x: {Text(v.X)}, y: {Text(v.Y)}, z: {Text(v.Z)}}}";

    public static string Text(float x) => x.ToString("R", CultureInfo.InvariantCulture);

    private static byte[] Floats(params Vector3[] vectors) =>
        [.. vectors.SelectMany(v => new[] { v.X, v.Y, v.Z }).SelectMany(BitConverter.GetBytes)];

    private static byte[] Halves(Vector3 v) =>
        [.. new[] { v.X, v.Y, v.Z }.SelectMany(x => BitConverter.GetBytes((Half)x))];
}

/// <summary>The numbers of an object and of its Transform.</summary>
internal sealed record UnityObject(long GameObject, long Transform);
