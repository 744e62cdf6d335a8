namespace Gjk.Import;

/// <summary>The meshes that Unity brings along, by the number under which scenes name them.</summary>
internal static class BuiltInMesh
{
    /// <summary>Of the file in the Editor that they lie in.</summary>
    public const string Guid = "0000000000000000e000000000000000";

    public const long Cube = 10202, Cylinder = 10206, Sphere = 10207, Capsule = 10208, Plane = 10209, Quad = 10210;

    /// <summary>Half the edge of the cube and the quad, and the radius of the round ones.</summary>
    public const float Half = 0.5f;

    /// <summary>Half the edge of the plane.</summary>
    public const float PlaneHalf = 5;

    /// <summary>Half the height of the cylinder.</summary>
    public const float CylinderHalfHeight = 1;

    /// <summary>Half the height of the capsule, without its caps.</summary>
    public const float CapsuleHalfHeight = 0.5f;

    /// <summary>The corners of the cube.</summary>
    public static ImportedMesh CubeCorners()
    {
        var corners = new Vector3[8];
        for (int i = 0; i < corners.Length; i++)
            corners[i] = Half * new Vector3((i & 1) * 2 - 1, (i & 2) - 1, (i & 4) / 2 - 1);
        return ImportedMesh.Weld("cube", corners, []);
    }

    /// <summary>A plane lies across y.</summary>
    public static ImportedMesh PlaneCorners() => ImportedMesh.Weld(
        "plane",
        [
            new(-PlaneHalf, 0, -PlaneHalf), new(PlaneHalf, 0, -PlaneHalf),
            new(PlaneHalf, 0, PlaneHalf), new(-PlaneHalf, 0, PlaneHalf),
        ],
        []);

    /// <summary>A quad lies across z.</summary>
    public static ImportedMesh QuadCorners() => ImportedMesh.Weld(
        "quad", [new(-Half, -Half, 0), new(Half, -Half, 0), new(Half, Half, 0), new(-Half, Half, 0)], []);
}
