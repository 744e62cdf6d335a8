namespace Gjk.Core;

/// <summary>A box about the local origin, its faces square to the local axes.</summary>
public readonly struct BoxShape : ISupportMap, IPlainBody
{
    /// <summary>Half the side lengths, each at least 0.</summary>
    public readonly Vector3 HalfExtents;

    /// <summary>Makes a box.</summary>
    /// <exception cref="System.ArgumentOutOfRangeException">A half extent is negative, NaN or infinite.</exception>
    public BoxShape(Vector3 halfExtents) => HalfExtents = Guard.NonNegative(halfExtents, nameof(halfExtents));

    /// <inheritdoc/>
    public Double3 Center => default;

    /// <inheritdoc/>
    public double Margin => 0;

    /// <inheritdoc/>
    public double BoundingRadius => ((Double3)HalfExtents).Length;

    /// <summary>This, as queries ask it.</summary>
    internal void Get(out BoxCore box) =>
        BoxCore.Make(HalfExtents, default, BoxCorners.Plain, BoundingRadius, 0, out box);

    object ILibraryShape.MakeTraits() => new PlainTraits<BoxShape>();

    bool ILibraryShape.TryGetForm(out ShapeForm form) => ShapeForm.Of(FormKind.Box, HalfExtents, out form);

    FormKind IPlainBody.GetPlain(out Double3 size)
    {
        size = HalfExtents;
        return FormKind.Box;
    }

    /// <inheritdoc/>
    public int Support(in Double3 direction, out Double3 point) =>
        BoxSupport.Furthest(HalfExtents, direction, out point);

    /// <inheritdoc/>
    public void GetFace(in Double3 direction, ref FaceCorners corners) =>
        BoxSupport.Face(HalfExtents, direction, ref corners);

    /// <inheritdoc/>
    public bool TryGetVertex(int id, out Double3 point) => BoxSupport.TryGetVertex(HalfExtents, id, out point);
}
