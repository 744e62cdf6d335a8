namespace Gjk.Import;

/// <summary>The numbers of Unity's classes (Unity Manual, "YAML class ID reference").</summary>
internal static class UnityClass
{
    public const int GameObject = 1, Transform = 4, MeshFilter = 33, Mesh = 43, MeshCollider = 64, BoxCollider = 65,
        SphereCollider = 135, CapsuleCollider = 136, SkinnedMeshRenderer = 137, CharacterController = 143,
        RectTransform = 224, PrefabInstance = 1001;

    /// <summary>True for the classes whose bodies are read.</summary>
    public static bool IsRead(int id) =>
        id is GameObject or Transform or RectTransform or PrefabInstance || IsShape(id);

    /// <summary>True for a class that gives its object a shape, whether it can be read or not.</summary>
    public static bool IsShape(int id) => id == MeshFilter || IsCollider(id) || UnreadShape(id) is not null;

    public static bool IsCollider(int id) =>
        id is MeshCollider or BoxCollider or SphereCollider or CapsuleCollider or CharacterController;

    /// <summary>Why a class with a shape is not read, or null if it is read or has no shape.</summary>
    public static string? UnreadShape(int id) => id switch
    {
        SkinnedMeshRenderer => "a SkinnedMeshRenderer moves its vertices while it runs",
        146 => "a WheelCollider is not read",
        154 => "a TerrainCollider's heights are in a binary asset that only Unity reads; export the terrain as OBJ",
        58 or 60 or 61 or 66 or 68 or 70 or 19719996 => "a 2D collider has no volume",
        _ => null,
    };

    public static string NameOf(int id) => id switch
    {
        GameObject => nameof(GameObject),
        Transform => nameof(Transform),
        RectTransform => nameof(RectTransform),
        MeshFilter => nameof(MeshFilter),
        Mesh => nameof(Mesh),
        MeshCollider => nameof(MeshCollider),
        BoxCollider => nameof(BoxCollider),
        SphereCollider => nameof(SphereCollider),
        CapsuleCollider => nameof(CapsuleCollider),
        CharacterController => nameof(CharacterController),
        PrefabInstance => nameof(PrefabInstance),
        58 => "CircleCollider2D",
        60 => "PolygonCollider2D",
        61 => "BoxCollider2D",
        66 => "CompositeCollider2D",
        68 => "EdgeCollider2D",
        70 => "CapsuleCollider2D",
        SkinnedMeshRenderer => nameof(SkinnedMeshRenderer),
        146 => "WheelCollider",
        154 => "TerrainCollider",
        19719996 => "TilemapCollider2D",
        _ => "class " + id.ToString(System.Globalization.CultureInfo.InvariantCulture),
    };
}
