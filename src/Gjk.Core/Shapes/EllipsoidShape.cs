using static Gjk.Core.MassForms;

namespace Gjk.Core;

/// <summary>An ellipsoid about the local origin, its axes along the local ones. A radius of 0 flattens it.</summary>
public readonly struct EllipsoidShape : ISupportMap, ICurve
{
    private readonly Double3 _radii;

    /// <summary>Makes an ellipsoid.</summary>
    /// <exception cref="ArgumentOutOfRangeException">A radius is negative, NaN or infinite.</exception>
    public EllipsoidShape(Vector3 radii) => _radii = Guard.NonNegative(radii, nameof(radii));

    /// <summary>Of radii that a scale may have been multiplied into.</summary>
    internal EllipsoidShape(in Double3 radii) => _radii = radii;

    /// <summary>The semi-axes, each at least 0.</summary>
    public Vector3 Radii => (Vector3)_radii;

    /// <inheritdoc/>
    public Double3 Center => default;

    /// <inheritdoc/>
    public double Margin => 0;

    /// <inheritdoc/>
    public double BoundingRadius => Math.Max(Math.Max(_radii.X, _radii.Y), _radii.Z);

    object ILibraryShape.MakeTraits() => new LibraryTraits<EllipsoidShape>();

    bool ILibraryShape.TryGetForm(out ShapeForm form) => ShapeForm.Of(FormKind.Ellipsoid, _radii, out form);

    MassProperties ICurve.GetMass(double rounding) => rounding > 0
        ? throw ConvexShape.NoMass("A rounded ellipsoid")
        : Even(4 * Math.PI / 3 * _radii.X * _radii.Y * _radii.Z, default, Double3.Multiply(_radii, _radii) * 0.2);

    /// <inheritdoc/>
    public int Support(in Double3 direction, out Double3 point) =>
        PrimitiveSupport.Ellipsoid(_radii, direction, out point);

    /// <summary>Nothing: the shape has no faces.</summary>
    public void GetFace(in Double3 direction, ref FaceCorners corners)
    {
    }

    /// <inheritdoc/>
    public bool TryGetVertex(int id, out Double3 point) => PrimitiveSupport.NoVertex(out point);
}
