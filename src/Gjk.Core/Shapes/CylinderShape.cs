namespace Gjk.Core;

/// <summary>A cylinder about the local y axis, centred at the local origin.</summary>
public readonly struct CylinderShape : ISupportMap, ILibraryShape
{
    /// <summary>The radius of the disc, at least 0.</summary>
    public readonly float Radius;

    /// <summary>Half the height, at least 0.</summary>
    public readonly float HalfHeight;

    /// <summary>Makes a cylinder.</summary>
    /// <exception cref="System.ArgumentOutOfRangeException">An argument is negative, NaN or infinite.</exception>
    public CylinderShape(float radius, float halfHeight)
    {
        Radius = Guard.NonNegative(radius, nameof(radius));
        HalfHeight = Guard.NonNegative(halfHeight, nameof(halfHeight));
    }

    /// <inheritdoc/>
    public Double3 Center => default;

    /// <inheritdoc/>
    public double Margin => 0;

    /// <inheritdoc/>
    public double BoundingRadius => new Double3(Radius, HalfHeight, 0).Length;

    object ILibraryShape.MakeTraits() => new LibraryTraits<CylinderShape>();

    bool ILibraryShape.TryGetTarget(out RayTarget target)
    {
        RayTarget.Of(RayForm.Cylinder, new Double3(Radius, HalfHeight, 0), out target);
        return true;
    }

    /// <inheritdoc/>
    public int Support(in Double3 direction, out Double3 point)
    {
        point = PrimitiveSupport.Cylinder(Radius, HalfHeight, direction);
        return -1;
    }

    /// <inheritdoc/>
    public void GetFace(in Double3 direction, ref FaceCorners corners) =>
        PrimitiveFaces.Cylinder(Radius, HalfHeight, direction, ref corners);

    /// <inheritdoc/>
    public bool TryGetVertex(int id, out Double3 point)
    {
        point = default;
        return false;
    }
}
