namespace Gjk.Core;

/// <summary>What a <see cref="ConvexShape"/> is made of; the rest of it is computed from this.</summary>
internal struct ShapeParts
{
    public ShapeKind Kind;

    /// <summary>Segment and capsule: the ends. Triangle: the corners. Box: A, the half extents. Half-space: A, the
    /// normal, B, the offset, and C, the normal's rounding (<see cref="HalfSpaceCore"/>). A kind that is kept as a
    /// struct: A, what that is made from. They are doubles, because a scale may have been multiplied in.</summary>
    public Double3 A, B, C;

    /// <summary>What is applied to each support; null where it was multiplied in, or nothing is scaled.</summary>
    public ShapeScale? Scaling;

    /// <summary>The factors that are applied to each support; 1 where they were multiplied in.</summary>
    public Double3 Scale
    {
        readonly get => Scaling is null ? new Double3(1, 1, 1) : Scaling.Axes.Factors;
        set => Scaling = value == new Double3(1, 1, 1) ? null : new ShapeScale(value, default);
    }

    /// <summary>The radius of a sphere or capsule, the lesser one of a tapered capsule, before the scale.</summary>
    public double InnerMargin;

    /// <summary>What the shape was widened by, after the scale.</summary>
    public double Rounding;

    /// <summary>A mesh's hull.</summary>
    public ConvexHull? Hull;

    /// <summary>The shape struct of a kind that is kept as one, made from A; null for the others.</summary>
    public ICurve? Curve;

    /// <summary>A <see cref="ScaledLayer"/>, or the shape of a user, if there is one; then of the rest only the kind,
    /// the rounding and the placement are used.</summary>
    public ISupportMap? Layer;

    /// <summary>Where all that is in the shape's frame; null where it is not placed.</summary>
    public Placement? Placement;
}
