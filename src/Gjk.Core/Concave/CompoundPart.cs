namespace Gjk.Core;

/// <summary>A child of a compound: a convex shape, a surface, a solid or another compound, in its place.
/// Immutable.</summary>
[DebuggerDisplay("{" + nameof(Shape) + "} at {" + nameof(Pose) + "}")]
public readonly struct CompoundPart
{
    /// <summary>The shape in its own frame.</summary>
    public readonly AnyShape Shape;

    /// <summary>Where it is in the compound's frame.</summary>
    public readonly RigidPose Pose;

    /// <summary>A convex part.</summary>
    /// <param name="shape">Any convex shape that ends.</param>
    /// <param name="pose">Where it is in the compound's frame.</param>
    /// <exception cref="ArgumentException">The shape is a <c>default</c> struct, or a half-space.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The pose is a <c>default</c> struct.</exception>
    public CompoundPart(in ConvexShape shape, in RigidPose pose)
        : this(AnyShape.Of(shape), pose)
    {
    }

    /// <summary>All parts of a shape.</summary>
    /// <param name="shape">A convex shape that ends, a surface, a solid or a compound. The parts of a solid are its
    /// triangles; its inside is the compound's, too.</param>
    /// <param name="pose">Where it is in the compound's frame.</param>
    /// <exception cref="ArgumentException">The shape is a <c>default</c> struct, or a half-space.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The pose is a <c>default</c> struct.</exception>
    public CompoundPart(in AnyShape shape, in RigidPose pose)
    {
        if (shape.Kind == AnyShapeKind.None)
            throw new ArgumentException("A default AnyShape is no part.", nameof(shape));
        if (AnyShape.ConvexOf(shape).Kind == ShapeKind.HalfSpace)
            throw new ArgumentException("A half-space has no end, and cannot be a part.", nameof(shape));
        Shape = shape;
        Pose = Guard.Pose(pose, nameof(pose));
    }
}
