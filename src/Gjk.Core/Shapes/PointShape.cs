namespace Gjk.Core;

/// <summary>A single point: the local origin.</summary>
public readonly struct PointShape : ISupportMap, ILibraryShape
{
    /// <inheritdoc/>
    public Double3 Center => default;

    /// <inheritdoc/>
    public double Margin => 0;

    /// <inheritdoc/>
    public double BoundingRadius => 0;

    /// <summary>This, as queries ask it.</summary>
    internal void Get(out SegmentCore segment) => SegmentCore.Make(default, default, 1, default, 0, 0, out segment);

    object ILibraryShape.MakeTraits() => new LibraryTraits<PointShape>();

    bool ILibraryShape.TryGetForm(out ShapeForm form) => ShapeForm.Ball(0, out form);

    /// <inheritdoc/>
    public int Support(in Double3 direction, out Double3 point) => PrimitiveSupport.Point(out point);

    /// <summary>Nothing: the shape has no faces.</summary>
    public void GetFace(in Double3 direction, ref FaceCorners corners)
    {
    }

    /// <inheritdoc/>
    public bool TryGetVertex(int id, out Double3 point) => PrimitiveSupport.Point(out point) == id;
}
