namespace Gjk.Core;

/// <summary>A ball about the local origin: a point core with the radius as its margin.</summary>
public readonly struct SphereShape : ISupportMap, IPlainBody
{
    /// <summary>The radius, at least 0.</summary>
    public readonly float Radius;

    /// <summary>Makes a sphere.</summary>
    /// <exception cref="System.ArgumentOutOfRangeException">The radius is negative, NaN or infinite.</exception>
    public SphereShape(float radius) => Radius = Guard.NonNegative(radius, nameof(radius));

    /// <inheritdoc/>
    public Double3 Center => default;

    /// <inheritdoc/>
    public double Margin => Radius;

    /// <inheritdoc/>
    public double BoundingRadius => Radius;

    /// <summary>This, as queries ask it.</summary>
    internal void Get(out SegmentCore segment) =>
        SegmentCore.Make(default, default, 1, default, Radius, Radius, out segment);

    object ILibraryShape.MakeTraits() => new PlainTraits<SphereShape>();

    bool ILibraryShape.TryGetForm(out ShapeForm form) => ShapeForm.Ball(Radius, out form);

    FormKind IPlainBody.GetPlain(out Double3 size)
    {
        size = new Double3(1, 1, 1) * Radius;
        return FormKind.Ball;
    }

    /// <inheritdoc/>
    public int Support(in Double3 direction, out Double3 point) => PrimitiveSupport.Point(out point);

    /// <summary>Nothing: the shape has no faces.</summary>
    public void GetFace(in Double3 direction, ref FaceCorners corners)
    {
    }

    /// <inheritdoc/>
    public bool TryGetVertex(int id, out Double3 point) => PrimitiveSupport.Point(out point) == id;
}
