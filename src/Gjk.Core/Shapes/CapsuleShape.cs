namespace Gjk.Core;

/// <summary>A capsule along the local y axis: a segment core with the radius as its margin.</summary>
public readonly struct CapsuleShape : ISupportMap, ILibraryShape
{
    /// <summary>The radius, at least 0.</summary>
    public readonly float Radius;

    /// <summary>Half the length of the segment, the round caps not included; at least 0.</summary>
    public readonly float HalfHeight;

    /// <summary>Makes a capsule.</summary>
    /// <exception cref="System.ArgumentOutOfRangeException">An argument is negative, NaN or infinite.</exception>
    public CapsuleShape(float radius, float halfHeight)
    {
        Radius = Guard.NonNegative(radius, nameof(radius));
        HalfHeight = Guard.NonNegative(halfHeight, nameof(halfHeight));
    }

    /// <inheritdoc/>
    public Double3 Center => default;

    /// <inheritdoc/>
    public double Margin => Radius;

    /// <inheritdoc/>
    public double BoundingRadius => (double)Radius + HalfHeight;

    /// <summary>This, as queries ask it.</summary>
    internal void Get(out SegmentCore segment) =>
        SegmentCore.Make(
            new Double3(0, HalfHeight, 0), new Double3(0, -(double)HalfHeight, 0), 2, default, BoundingRadius, Radius,
            out segment);

    object ILibraryShape.MakeTraits() => new LibraryTraits<CapsuleShape>();

    bool ILibraryShape.TryGetForm(out ShapeForm form) =>
        ShapeForm.Capsule(
            new Double3(0, HalfHeight, 0), new Double3(0, -(double)HalfHeight, 0), default, Radius, out form);

    /// <inheritdoc/>
    public int Support(in Double3 direction, out Double3 point)
    {
        bool down = direction.Y < 0;
        point = new Double3(0, down ? -(double)HalfHeight : HalfHeight, 0);
        return down ? 1 : 0;
    }

    /// <inheritdoc/>
    public void GetFace(in Double3 direction, ref FaceCorners corners)
    {
        var top = new Double3(0, HalfHeight, 0);
        PrimitiveFaces.Segment(top, -top, direction, ref corners);
    }

    /// <inheritdoc/>
    public bool TryGetVertex(int id, out Double3 point) =>
        PrimitiveSupport.Two(new Double3(0, HalfHeight, 0), new Double3(0, -(double)HalfHeight, 0), id, out point);
}
