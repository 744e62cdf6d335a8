namespace Gjk.Core;

// The numbers that it was made from, in world units; of a decorated shape (IsDecorated) those of what is
// inside, before Scale. What a kind does not have is 0.
public readonly partial struct ConvexShape
{
    /// <summary>The radius of a sphere, capsule, cylinder or cone.</summary>
    public float Radius => Innermost(out ShapeParts parts) switch
    {
        ShapeKind.Sphere or ShapeKind.Capsule => (float)parts.InnerMargin,
        ShapeKind.Cylinder or ShapeKind.Cone => (float)parts.A.X,
        _ => 0,
    };

    /// <summary>The radius of a tapered capsule's ball at +HalfHeight.</summary>
    public float TopRadius => Innermost(out ShapeParts parts) == ShapeKind.TaperedCapsule ? (float)parts.A.X : 0;

    /// <summary>The radius of a tapered capsule's ball at -HalfHeight.</summary>
    public float BottomRadius => Innermost(out ShapeParts parts) == ShapeKind.TaperedCapsule ? (float)parts.A.Y : 0;

    /// <summary>Half the height of a cylinder or cone; of a capsule or tapered capsule without its caps.</summary>
    public float HalfHeight => Innermost(out ShapeParts parts) switch
    {
        ShapeKind.Capsule => (float)(parts.A - parts.B).Length / 2,
        ShapeKind.Cylinder or ShapeKind.Cone => (float)parts.A.Y,
        ShapeKind.TaperedCapsule => (float)parts.A.Z,
        _ => 0,
    };

    /// <summary>Half the sides of a box; the radii of an ellipsoid.</summary>
    public Vector3 HalfExtents =>
        Innermost(out ShapeParts parts) is ShapeKind.Box or ShapeKind.Ellipsoid ? (Vector3)parts.A : Vector3.Zero;

    /// <summary>A half-space's outward normal, of unit length.</summary>
    public Vector3 Normal => Kind == ShapeKind.HalfSpace ? (Vector3)AsHalfSpace.Unit : Vector3.Zero;

    /// <summary>How far a half-space's plane is from the local origin, along <see cref="Normal"/>.</summary>
    public float Offset => Kind == ShapeKind.HalfSpace ? (float)AsHalfSpace.PlaneDistance : 0;

    /// <summary>What it was widened by, last of all.</summary>
    public float Rounding => (float)_parts.Rounding;

    /// <summary>The kind and the parts of the innermost shape.</summary>
    private ShapeKind Innermost(out ShapeParts parts)
    {
        parts = _parts;
        while (parts.Layer is ScaledLayer scaled) parts = scaled.Inner._parts;
        return parts.Kind;
    }
}
