namespace Gjk.Core;

/// <summary>The straight line between two points, both included; they may coincide.</summary>
public readonly struct SegmentShape : ISupportMap, ILibraryShape
{
    /// <summary>One end.</summary>
    public readonly Vector3 A;

    /// <summary>The other end.</summary>
    public readonly Vector3 B;

    /// <summary>Makes a segment.</summary>
    /// <exception cref="System.ArgumentOutOfRangeException">A coordinate is NaN or infinite.</exception>
    public SegmentShape(Vector3 a, Vector3 b)
    {
        A = Guard.Finite(a, nameof(a));
        B = Guard.Finite(b, nameof(b));
    }

    /// <inheritdoc/>
    public Double3 Center => ((Double3)A + B) * 0.5;

    /// <inheritdoc/>
    public double Margin => 0;

    /// <inheritdoc/>
    public double BoundingRadius => ((Double3)B - A).Length * 0.5;

    /// <summary>This, as queries ask it.</summary>
    internal void Get(out SegmentCore segment) => SegmentCore.Make(A, B, 2, Center, BoundingRadius, 0, out segment);

    object ILibraryShape.MakeTraits() => new LibraryTraits<SegmentShape>();

    bool ILibraryShape.TryGetForm(out ShapeForm form) => ShapeForm.Capsule(A, B, Center, 0, out form);

    /// <inheritdoc/>
    public int Support(in Double3 direction, out Double3 point)
    {
        int id = PrimitiveSupport.Segment(A, B, direction, out point);
        point -= Center;
        return id;
    }

    /// <inheritdoc/>
    public void GetFace(in Double3 direction, ref FaceCorners corners)
    {
        Double3 center = Center;
        PrimitiveFaces.Segment(A - center, B - center, direction, ref corners);
    }

    /// <inheritdoc/>
    public bool TryGetVertex(int id, out Double3 point)
    {
        bool found = PrimitiveSupport.Two(A, B, id, out point);
        point -= Center;
        return found;
    }
}
