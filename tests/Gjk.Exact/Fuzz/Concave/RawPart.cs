namespace Gjk.Exact.Fuzz.Concave;

/// <summary>A convex shape in its place, by the numbers that it is made of.</summary>
/// <param name="Kind">Of those that a scene file knows.</param>
/// <param name="Sizes">Radius and half height, half sides, radii; a triangle's or mesh's corners; one vector for all
/// but the latter.</param>
/// <param name="Pose">Where it is in the compound.</param>
internal sealed record RawPart(ShapeKind Kind, Vector3[] Sizes, RigidPose Pose)
{
    public RawPart(ShapeKind kind, params Vector3[] sizes)
        : this(kind, sizes, RigidPose.Identity)
    {
    }

    public ConvexShape Build()
    {
        Vector3 s = Sizes[0];
        return Kind switch
        {
            ShapeKind.Point => ConvexShape.Point(),
            ShapeKind.Sphere => ConvexShape.Sphere(s.X),
            ShapeKind.Capsule => ConvexShape.Capsule(s.X, s.Y),
            ShapeKind.Cylinder => ConvexShape.Cylinder(s.X, s.Y),
            ShapeKind.Cone => ConvexShape.Cone(s.X, s.Y),
            ShapeKind.Box => ConvexShape.Box(s),
            ShapeKind.Ellipsoid => ConvexShape.Ellipsoid(s),
            ShapeKind.Triangle => ConvexShape.Triangle(s, Sizes[1], Sizes[2]),
            _ => ConvexShape.Mesh(Sizes),
        };
    }

    /// <summary>The fields of a scene file; the name is that of a mesh.</summary>
    public string Json(string name)
    {
        Vector3 s = Sizes[0];
        string fields = Kind switch
        {
            ShapeKind.Point => "",
            ShapeKind.Sphere => $",\"radius\":{RawJson.Number(s.X)}",
            ShapeKind.Capsule or ShapeKind.Cylinder or ShapeKind.Cone =>
                $",\"radius\":{RawJson.Number(s.X)},\"halfHeight\":{RawJson.Number(s.Y)}",
            ShapeKind.Box => $",\"halfExtents\":{RawJson.Of(s)}",
            ShapeKind.Ellipsoid => $",\"radii\":{RawJson.Of(s)}",
            ShapeKind.Triangle => string.Concat(Sizes.Select((p, i) => $",\"{"abc"[i]}\":{RawJson.Of(p)}")),
            _ => $",\"mesh\":\"{name}\"",
        };
        return $"{{\"type\":\"{Kind.ToString().ToLowerInvariant()}\"{fields}}}";
    }

    public RawPart Larger(float factor) => this with { Sizes = [.. Sizes.Select(s => s * factor)] };
}
