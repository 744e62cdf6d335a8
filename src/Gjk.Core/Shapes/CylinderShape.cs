using static Gjk.Core.MassForms;

namespace Gjk.Core;

/// <summary>A cylinder about the local y axis, centred at the local origin.</summary>
public readonly struct CylinderShape : ISupportMap, ICurve
{
    private readonly double _radius, _halfHeight;

    /// <summary>Makes a cylinder.</summary>
    /// <exception cref="System.ArgumentOutOfRangeException">An argument is negative, NaN or infinite.</exception>
    public CylinderShape(float radius, float halfHeight)
    {
        _radius = Guard.NonNegative(radius, nameof(radius));
        _halfHeight = Guard.NonNegative(halfHeight, nameof(halfHeight));
    }

    /// <summary>From a record, whose numbers may be doubles.</summary>
    internal CylinderShape(in Double3 size) => (_radius, _halfHeight) = (size.X, size.Y);

    /// <summary>The radius of the disc, at least 0.</summary>
    public float Radius => (float)_radius;

    /// <summary>Half the height, at least 0.</summary>
    public float HalfHeight => (float)_halfHeight;

    /// <inheritdoc/>
    public Double3 Center => default;

    /// <inheritdoc/>
    public double Margin => 0;

    /// <inheritdoc/>
    public double BoundingRadius => new Double3(_radius, _halfHeight, 0).Length;

    object ILibraryShape.MakeTraits() => new LibraryTraits<CylinderShape>();

    bool ILibraryShape.TryGetForm(out ShapeForm form) =>
        ShapeForm.Of(FormKind.Cylinder, new Double3(_radius, _halfHeight, 0), out form);

    /// <summary>A wider cylinder, and two rims.</summary>
    MassProperties ICurve.GetMass(double rounding)
    {
        MassProperties rim = Rim(_radius, rounding, 0);
        return Moved(Frustum(_radius + rounding, _radius + rounding, 2 * _halfHeight), -_halfHeight, 1)
            + Moved(rim, _halfHeight, 1) + Moved(rim, -_halfHeight, -1);
    }

    /// <inheritdoc/>
    public int Support(in Double3 direction, out Double3 point) =>
        PrimitiveSupport.Cylinder(_radius, _halfHeight, direction, out point);

    /// <inheritdoc/>
    public void GetFace(in Double3 direction, ref FaceCorners corners) =>
        PrimitiveFaces.Cylinder(_radius, _halfHeight, direction, ref corners);

    /// <inheritdoc/>
    public bool TryGetVertex(int id, out Double3 point) => PrimitiveSupport.NoVertex(out point);
}
