namespace Gjk.Core;

/// <summary>A convex part of a compound, in its place. Immutable.</summary>
[DebuggerDisplay("{" + nameof(Shape) + "} at {" + nameof(Pose) + "}")]
public readonly struct CompoundPart
{
    /// <summary>The part's shape.</summary>
    public readonly ConvexShape Shape;

    /// <summary>Where it is in the compound's frame.</summary>
    public readonly RigidPose Pose;

    /// <summary>Makes a part.</summary>
    /// <param name="shape">Any convex shape that ends.</param>
    /// <param name="pose">Where it is in the compound's frame.</param>
    /// <exception cref="ArgumentException">The shape is a <c>default</c> struct, or a half-space.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The pose is a <c>default</c> struct.</exception>
    public CompoundPart(in ConvexShape shape, in RigidPose pose)
    {
        if (shape.Kind == ShapeKind.None)
            throw new ArgumentException("A default ConvexShape is no part.", nameof(shape));
        if (shape.Kind == ShapeKind.HalfSpace)
            throw new ArgumentException("A half-space has no end, and cannot be a part.", nameof(shape));
        Shape = shape;
        Pose = Guard.Pose(pose, nameof(pose));
    }
}
