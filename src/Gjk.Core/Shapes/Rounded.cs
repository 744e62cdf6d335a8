namespace Gjk.Core;

/// <summary>Any shape widened by a radius: its Minkowski sum with a ball. The radius only adds to the margin, so
/// queries stay as fast.</summary>
/// <typeparam name="T">The shape inside.</typeparam>
public readonly struct Rounded<T> : ISupportMap, IPlacedShape<Rounded<T>>
    where T : struct, ISupportMap
{
    private readonly T _inner;
    private readonly float _radius;

    /// <summary>Widens a shape.</summary>
    /// <exception cref="System.ArgumentOutOfRangeException">The radius is negative, NaN or infinite.</exception>
    public Rounded(in T inner, float radius)
    {
        _inner = inner;
        _radius = Guard.NonNegative(radius, nameof(radius));
    }

    /// <summary>The shape inside.</summary>
    public T Inner => _inner;

    /// <summary>The added radius, in local units.</summary>
    public float Radius => _radius;

    /// <inheritdoc/>
    public Double3 Center => _inner.Center;

    /// <inheritdoc/>
    public double Margin => _inner.Margin + _radius;

    /// <inheritdoc/>
    public double BoundingRadius => _inner.BoundingRadius + _radius;

    object ILibraryShape.MakeTraits() => new PlacedTraits<Rounded<T>>(ShapeTraits<T>.AreTight);

    Placement? IPlacedShape<Rounded<T>>.Placement
    {
        get
        {
            T inner = _inner;
            return ShapeTraits<T>.Instance.PlacementOf(ref inner);
        }
    }

    Rounded<T> IPlacedShape<Rounded<T>>.InCoreAxes() => new(ShapeTraits<T>.Instance.InCoreAxes(_inner), _radius);

    bool ILibraryShape.TryGetForm(out ShapeForm form)
    {
        T inner = _inner;
        bool found = ShapeTraits<T>.Instance.TryGetForm(ref inner, out form);
        form.Round(_radius);
        return found;
    }

    /// <inheritdoc/>
    public int Support(in Double3 direction, out Double3 point) => _inner.Support(direction, out point);

    /// <inheritdoc/>
    public void GetFace(in Double3 direction, ref FaceCorners corners) => _inner.GetFace(direction, ref corners);

    /// <inheritdoc/>
    public bool TryGetVertex(int id, out Double3 point) => _inner.TryGetVertex(id, out point);
}
