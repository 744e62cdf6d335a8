using System;
using System.Numerics;

namespace Gjk.Core;

/// <summary>An ellipsoid about the local origin, its axes along the local ones. A radius of 0 flattens it.</summary>
public readonly struct EllipsoidShape : ISupportMap, ILibraryShape
{
    /// <summary>The semi-axes, each at least 0.</summary>
    public readonly Vector3 Radii;

    /// <summary>Makes an ellipsoid.</summary>
    /// <exception cref="ArgumentOutOfRangeException">A radius is negative, NaN or infinite.</exception>
    public EllipsoidShape(Vector3 radii) => Radii = Guard.NonNegative(radii, nameof(radii));

    /// <inheritdoc/>
    public Double3 Center => default;

    /// <inheritdoc/>
    public double Margin => 0;

    /// <inheritdoc/>
    public double BoundingRadius => Math.Max(Math.Max(Radii.X, Radii.Y), Radii.Z);

    object ILibraryShape.MakeTraits() => new LibraryTraits<EllipsoidShape>();

    bool ILibraryShape.TryGetTarget(out RayTarget target)
    {
        RayTarget.Of(RayForm.Ellipsoid, Radii, out target);
        return true;
    }

    /// <inheritdoc/>
    public int Support(in Double3 direction, out Double3 point)
    {
        point = PrimitiveSupport.Ellipsoid(Radii, direction);
        return -1;
    }

    /// <summary>Nothing: the shape has no faces.</summary>
    public void GetFace(in Double3 direction, ref FaceCorners corners)
    {
    }

    /// <inheritdoc/>
    public bool TryGetVertex(int id, out Double3 point)
    {
        point = default;
        return false;
    }
}
