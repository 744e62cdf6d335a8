namespace Gjk.Core;

public readonly partial struct ConvexShape
{
    /// <summary>The local origin.</summary>
    public static ConvexShape Point() => Make(ShapeKind.Point, default);

    /// <summary>A segment between two points.</summary>
    /// <exception cref="ArgumentOutOfRangeException">A coordinate is NaN or infinite.</exception>
    public static ConvexShape Segment(Vector3 a, Vector3 b) =>
        Make(ShapeKind.Segment, Guard.Finite(a, nameof(a)), Guard.Finite(b, nameof(b)));

    /// <summary>A triangle.</summary>
    /// <exception cref="ArgumentOutOfRangeException">A coordinate is NaN or infinite.</exception>
    public static ConvexShape Triangle(Vector3 a, Vector3 b, Vector3 c) =>
        Make(ShapeKind.Triangle, Guard.Finite(a, nameof(a)), Guard.Finite(b, nameof(b)), Guard.Finite(c, nameof(c)));

    /// <summary>A sphere about the local origin.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The radius is negative, NaN or infinite.</exception>
    public static ConvexShape Sphere(float radius) =>
        Make(ShapeKind.Sphere, default, margin: Guard.NonNegative(radius, nameof(radius)));

    /// <summary>A capsule along the local y axis; the half height does not include the caps.</summary>
    /// <exception cref="ArgumentOutOfRangeException">An argument is negative, NaN or infinite.</exception>
    public static ConvexShape Capsule(float radius, float halfHeight)
    {
        double margin = Guard.NonNegative(radius, nameof(radius));
        double height = Guard.NonNegative(halfHeight, nameof(halfHeight));
        return Make(ShapeKind.Capsule, new Double3(0, height, 0), new Double3(0, -height, 0), margin: margin);
    }

    /// <summary>The hull of two balls on the local y axis, at +halfHeight and -halfHeight; where one holds the other,
    /// it is that ball.</summary>
    /// <exception cref="ArgumentOutOfRangeException">An argument is negative, NaN or infinite.</exception>
    public static ConvexShape TaperedCapsule(float topRadius, float bottomRadius, float halfHeight) =>
        Make(ShapeKind.TaperedCapsule, TaperedCapsuleShape.Sizes(topRadius, bottomRadius, halfHeight));

    /// <summary>A box about the local origin.</summary>
    /// <exception cref="ArgumentOutOfRangeException">A half extent is negative, NaN or infinite.</exception>
    public static ConvexShape Box(Vector3 halfExtents) =>
        Make(ShapeKind.Box, Guard.NonNegative(halfExtents, nameof(halfExtents)));

    /// <summary>A cylinder about the local y axis.</summary>
    /// <exception cref="ArgumentOutOfRangeException">An argument is negative, NaN or infinite.</exception>
    public static ConvexShape Cylinder(float radius, float halfHeight) =>
        Make(ShapeKind.Cylinder, RadiusAndHeight(radius, halfHeight));

    /// <summary>A cone about the local y axis, its apex at +halfHeight.</summary>
    /// <exception cref="ArgumentOutOfRangeException">An argument is negative, NaN or infinite.</exception>
    public static ConvexShape Cone(float radius, float halfHeight) =>
        Make(ShapeKind.Cone, RadiusAndHeight(radius, halfHeight));

    /// <summary>An ellipsoid about the local origin.</summary>
    /// <exception cref="ArgumentOutOfRangeException">A radius is negative, NaN or infinite.</exception>
    public static ConvexShape Ellipsoid(Vector3 radii) =>
        Make(ShapeKind.Ellipsoid, Guard.NonNegative(radii, nameof(radii)));

    /// <summary>A half-space: all points x with normal · x at most the offset. A floor is
    /// <c>HalfSpace(Vector3.UnitY, 0)</c>.</summary>
    /// <param name="normal">Points out of it; of any length but 0.</param>
    /// <param name="offset">What normal · x is on the plane, which so is offset / |normal| from the local
    /// origin.</param>
    /// <returns>A shape without end: <see cref="BoundingRadius"/> is infinite, and it has no support point. Every query
    /// of <see cref="ConvexQuery"/> answers for it and any shape that ends, in closed form; two half-spaces give
    /// <see cref="GjkStatus.InvalidShape"/>. Widened, scaled or placed it is another half-space; inside
    /// <c>Scaled&lt;T&gt;</c>, <c>Rounded&lt;T&gt;</c> or <c>Placed&lt;T&gt;</c> it gives
    /// <see cref="GjkStatus.InvalidInput"/>.</returns>
    /// <exception cref="ArgumentOutOfRangeException">An argument is NaN or infinite, or the normal is 0.</exception>
    public static ConvexShape HalfSpace(Vector3 normal, float offset)
    {
        Guard.Finite(normal, nameof(normal));
        if (normal == Vector3.Zero)
            throw new ArgumentOutOfRangeException(nameof(normal), normal, "Must not be zero.");
        return Make(ShapeKind.HalfSpace, normal, new Double3(Guard.Finite(offset, nameof(offset)), 0, 0));
    }

    /// <summary>A convex mesh from a hull that was built before.</summary>
    /// <exception cref="ArgumentNullException">The hull is null.</exception>
    public static ConvexShape Mesh(ConvexHull hull) =>
        new(new ShapeParts { Kind = ShapeKind.Mesh, Hull = Guard.NotNull(hull, nameof(hull)) });

    /// <summary>A convex mesh; builds the hull of the vertices.</summary>
    /// <exception cref="ArgumentNullException">The list is null.</exception>
    /// <exception cref="ArgumentException">The list is empty, or a coordinate is NaN or infinite.</exception>
    public static ConvexShape Mesh(IReadOnlyList<Vector3> vertices) => Mesh(new ConvexHull(vertices));

    /// <summary>A shape of your own, for scenes, batches and compounds. Each support costs an interface call.</summary>
    /// <param name="shape">It must not change; a struct is boxed once. Two such shapes are equal when they are made of
    /// the same object.</param>
    /// <exception cref="ArgumentNullException">There is no shape.</exception>
    /// <exception cref="ArgumentException">Its centre, margin or bounding radius is NaN or infinite, or one of the two
    /// is negative.</exception>
    public static ConvexShape Custom(ISupportMap shape)
    {
        if (Guard.NotNull(shape, nameof(shape)) is ConvexShape known) return known;
        double radius = shape.BoundingRadius, margin = shape.Margin;
        bool isValid = shape.Center.IsFinite && margin >= 0 && radius >= 0 && radius <= double.MaxValue
            && margin <= double.MaxValue;
        return isValid
            ? new(new ShapeParts { Kind = ShapeKind.Custom, Layer = shape })
            : throw new ArgumentException(
                "The centre, the margin and the bounding radius must be finite, and the two not negative.",
                nameof(shape));
    }

    private static ConvexShape Make(
        ShapeKind kind, in Double3 a, in Double3 b = default, in Double3 c = default, double margin = 0) =>
        new(new ShapeParts { Kind = kind, A = a, B = b, C = c, InnerMargin = margin });

    private static ConvexShape Make(in HalfSpaceCore halfSpace) =>
        Make(ShapeKind.HalfSpace, halfSpace.Normal, halfSpace.Offset, halfSpace.NormalError);

    /// <summary>The shape struct of a kind that is kept as one.</summary>
    private static ICurve? CurveOf(in ShapeParts parts) => parts.Kind switch
    {
        ShapeKind.Cylinder => new CylinderShape(parts.A),
        ShapeKind.Cone => new ConeShape(parts.A),
        ShapeKind.Ellipsoid => new EllipsoidShape(parts.A),
        ShapeKind.TaperedCapsule => new TaperedCapsuleShape(parts.A),
        _ => null,
    };

    private static Double3 RadiusAndHeight(float radius, float halfHeight) =>
        new(Guard.NonNegative(radius, nameof(radius)), Guard.NonNegative(halfHeight, nameof(halfHeight)), 0);
}
