namespace Gjk.Core;

/// <summary>
/// A <see cref="ConvexShape"/> inside a decorator that its own numbers cannot express: it is placed, or was rounded
/// before it was scaled unevenly. Immutable. It holds the decorator that callers of the typed shapes use, so both give
/// the same bits.
/// </summary>
internal abstract class ShapeLayer
{
    /// <summary>The shape inside the decorator.</summary>
    public abstract ConvexShape Inner { get; }

    /// <inheritdoc cref="ISupportMap.Center"/>
    public abstract Double3 Center { get; }

    /// <inheritdoc cref="ISupportMap.Margin"/>
    public abstract double Margin { get; }

    /// <inheritdoc cref="ISupportMap.BoundingRadius"/>
    public abstract double BoundingRadius { get; }

    /// <inheritdoc cref="ISupportMap.Support"/>
    public abstract int Support(in Double3 direction, out Double3 point);

    /// <inheritdoc cref="ISupportMap.GetFace"/>
    public abstract void GetFace(in Double3 direction, ref FaceCorners corners);

    /// <inheritdoc cref="ISupportMap.TryGetVertex"/>
    public abstract bool TryGetVertex(int id, out Double3 point);

    /// <inheritdoc cref="ILibraryShape.TryGetTarget"/>
    public abstract bool TryGetTarget(out RayTarget target);

    /// <summary>Whether two layers do the same to equal shapes.</summary>
    public static bool AreEqual(ShapeLayer? a, ShapeLayer? b)
    {
        if (ReferenceEquals(a, b)) return true;
        if (a is null || b is null || !a.Inner.Equals(b.Inner)) return false;
        return a is PlacedLayer placed && b is PlacedLayer other
            ? placed.Shape.Pose == other.Shape.Pose
            : a is ScaledLayer scaled && b is ScaledLayer otherScaled
                && scaled.Shape.Factors == otherScaled.Shape.Factors;
    }
}

/// <inheritdoc/>
/// <typeparam name="T">The decorator.</typeparam>
internal abstract class ShapeLayer<T> : ShapeLayer
    where T : struct, ISupportMap, ILibraryShape
{
    private readonly T _shape;

    protected ShapeLayer(in T shape) => _shape = shape;

    /// <summary>The decorator.</summary>
    public ref readonly T Shape => ref _shape;

    public override Double3 Center => _shape.Center;

    public override double Margin => _shape.Margin;

    public override double BoundingRadius => _shape.BoundingRadius;

    public override int Support(in Double3 direction, out Double3 point) => _shape.Support(direction, out point);

    public override void GetFace(in Double3 direction, ref FaceCorners corners) =>
        _shape.GetFace(direction, ref corners);

    public override bool TryGetVertex(int id, out Double3 point) => _shape.TryGetVertex(id, out point);

    public override bool TryGetTarget(out RayTarget target) => _shape.TryGetTarget(out target);
}

/// <summary>A placed shape.</summary>
internal sealed class PlacedLayer : ShapeLayer<Placed<ConvexShape>>
{
    public PlacedLayer(in Placed<ConvexShape> shape)
        : base(shape)
    {
    }

    public override ConvexShape Inner => Shape.Inner;
}

/// <summary>A shape that was rounded or placed before it was scaled.</summary>
internal sealed class ScaledLayer : ShapeLayer<Scaled<ConvexShape>>
{
    public ScaledLayer(in Scaled<ConvexShape> shape)
        : base(shape)
    {
    }

    public override ConvexShape Inner => Shape.Inner;
}
