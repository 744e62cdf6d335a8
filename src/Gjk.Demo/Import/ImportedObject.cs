using System.Numerics;
using Gjk.Demo.Import.Placing;

namespace Gjk.Demo.Import;

/// <summary>The shape of an imported object, in the words of the scene format.</summary>
/// <param name="Type">As the format names it.</param>
/// <param name="Radius">Of a sphere, a capsule or a cylinder.</param>
/// <param name="HalfHeight">Of a capsule, without its caps, or a cylinder.</param>
/// <param name="Sizes">The half extents of a box or the radii of an ellipsoid.</param>
/// <param name="Mesh">The name of a mesh.</param>
/// <param name="Rotation">Turns the shape before the object's scale.</param>
internal sealed record ImportedShape(
    string Type, double Radius, double HalfHeight, Vector3 Sizes, string Mesh, Quaternion Rotation)
{
    public static ImportedShape Sphere(double radius) => Of("sphere", radius);

    public static ImportedShape Capsule(double radius, double halfHeight) => Of("capsule", radius, halfHeight);

    public static ImportedShape Cylinder(double radius, double halfHeight) => Of("cylinder", radius, halfHeight);

    public static ImportedShape Box(Vector3 halfExtents) => Of("box") with { Sizes = halfExtents };

    public static ImportedShape Ellipsoid(Vector3 radii) => Of("ellipsoid") with { Sizes = radii };

    public static ImportedShape OfMesh(string name) => Of("mesh") with { Mesh = name };

    /// <summary>A float would overflow where the scene is read.</summary>
    public bool IsFinite =>
        float.IsFinite((float)Radius) && float.IsFinite((float)HalfHeight)
        && float.IsFinite(Sizes.X + Sizes.Y) && float.IsFinite(Sizes.Z);

    private static ImportedShape Of(string type, double radius = 0, double halfHeight = 0) =>
        new(type, radius, halfHeight, Vector3.Zero, "", Quaternion.Identity);
}

/// <summary>An object of the scene that is written.</summary>
/// <param name="Name">Unlike all others in the scene.</param>
/// <param name="Shape">The shape.</param>
/// <param name="Position">In the world.</param>
/// <param name="Rotation">In the world, of length 1.</param>
/// <param name="Scale">Along the object's own axes; not 0.</param>
internal sealed record ImportedObject(
    string Name, ImportedShape Shape, Vector3 Position, Quaternion Rotation, Vector3 Scale)
{
    public ImportedObject(string name, ImportedShape shape, in Affine world, in TurnD rotation)
        : this(name, shape, (Vector3)world.Origin, rotation.ToFloat(), Vector3.One)
    {
    }

    public bool IsFinite => Shape.IsFinite && IsFiniteVector(Position) && IsFiniteVector(Scale);

    private static bool IsFiniteVector(Vector3 v) => float.IsFinite(v.X) && float.IsFinite(v.Y) && float.IsFinite(v.Z);
}
