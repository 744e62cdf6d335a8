using static Gjk.Core.MassForms;

namespace Gjk.Core;

/// <summary>A cone about the local y axis: the apex at +HalfHeight, the base's disc at -HalfHeight.</summary>
public readonly struct ConeShape : ISupportMap, ICurve
{
    private readonly double _radius, _halfHeight;

    /// <summary>Makes a cone.</summary>
    /// <exception cref="System.ArgumentOutOfRangeException">An argument is negative, NaN or infinite.</exception>
    public ConeShape(float radius, float halfHeight)
    {
        _radius = Guard.NonNegative(radius, nameof(radius));
        _halfHeight = Guard.NonNegative(halfHeight, nameof(halfHeight));
    }

    /// <summary>From a record, whose numbers may be doubles.</summary>
    internal ConeShape(in Double3 size) => (_radius, _halfHeight) = (size.X, size.Y);

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

    object ILibraryShape.MakeTraits() => new LibraryTraits<ConeShape>();

    bool ILibraryShape.TryGetForm(out ShapeForm form) =>
        ShapeForm.Of(FormKind.Cone, new Double3(_radius, _halfHeight, 0), out form);

    /// <summary>A frustum between the circles at which the side begins and ends, a rim below it and a cap on top. The
    /// sine is that of the side's normal over the level.</summary>
    MassProperties ICurve.GetMass(double rounding)
    {
        double side = Math.Sqrt(_radius * _radius + 4 * _halfHeight * _halfHeight);
        if (!(side > 0)) return Ball(rounding, default);
        double sine = _radius / side, wider = rounding * (2 * _halfHeight / side);
        return Moved(Frustum(_radius + wider, wider, 2 * _halfHeight), rounding * sine - _halfHeight, 1)
            + Moved(Rim(0, rounding, sine), _halfHeight, 1) + Moved(Rim(_radius, rounding, -sine), -_halfHeight, -1);
    }

    /// <inheritdoc/>
    public int Support(in Double3 direction, out Double3 point) =>
        PrimitiveSupport.Cone(_radius, _halfHeight, direction, out point);

    /// <inheritdoc/>
    public void GetFace(in Double3 direction, ref FaceCorners corners) =>
        PrimitiveFaces.Cone(_radius, _halfHeight, direction, ref corners);

    /// <inheritdoc/>
    public bool TryGetVertex(int id, out Double3 point) => PrimitiveSupport.NoVertex(out point);
}
