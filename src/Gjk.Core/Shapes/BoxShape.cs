using System.Numerics;

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
    public Vector3D Center => default;

    /// <inheritdoc/>
    public double Margin => 0;

    /// <inheritdoc/>
    public double BoundingRadius => ((Vector3D)HalfExtents).Length;

    /// <summary>This, as queries ask it.</summary>
    internal void Get(out BoxCore box) =>
        BoxCore.Make(HalfExtents, default, BoxCorners.Plain, BoundingRadius, 0, out box);

    object ILibraryShape.MakeTraits() => new PlainTraits<BoxShape>();

    bool ILibraryShape.TryGetTarget(out RayTarget target)
    {
        RayTarget.Of(RayForm.Box, HalfExtents, out target);
        return true;
    }

    RayForm IPlainBody.GetPlain(out Vector3D size)
    {
        size = HalfExtents;
        return RayForm.Box;
    }

    /// <inheritdoc/>
    public int Support(in Vector3D direction, out Vector3D point) =>
        BoxSupport.Furthest(HalfExtents, direction, out point);

    /// <inheritdoc/>
    public void GetFace(in Vector3D direction, ref FaceCorners corners) =>
        BoxSupport.Face(HalfExtents, direction, ref corners);

    /// <inheritdoc/>
    public bool TryGetVertex(int id, out Vector3D point) => BoxSupport.TryGetVertex(HalfExtents, id, out point);
}
