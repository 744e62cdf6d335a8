namespace Gjk.Core;

/// <summary>Any shape scaled along its local axes; negative factors mirror it. The products are taken in double, where
/// they are exact for float vertices.</summary>
/// <remarks>Uneven factors, and a shape of your own, are measured once, by six supports in the constructor. Uneven
/// factors turn the margin's ball into an ellipsoid, which then belongs to the core.</remarks>
/// <typeparam name="T">The shape inside.</typeparam>
public readonly struct Scaled<T> : ISupportMap, ILibraryShape
    where T : struct, ISupportMap
{
    private readonly T _inner;
    private readonly AxisScale _scale;
    private readonly Double3 _center, _centerError;
    private readonly double _boundingRadius;

    /// <summary>Scales a shape by one factor along every axis.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The factor is 0, NaN or infinite.</exception>
    public Scaled(in T inner, float scale)
        : this(inner, new Vector3(scale))
    {
    }

    /// <summary>Scales a shape.</summary>
    /// <exception cref="ArgumentOutOfRangeException">A factor is 0, NaN or infinite.</exception>
    public Scaled(in T inner, Vector3 scale)
    {
        _inner = inner;
        _scale = new AxisScale(Guard.Scale(scale, nameof(scale)));
        _scale.ScaleCenter(inner.Center, out _center, out _centerError);
        _boundingRadius = inner.BoundingRadius * _scale.Largest + _centerError.Length;
        if (!(_boundingRadius >= 0) || (_scale.KeepsBalls && ShapeTraits<T>.AreTight)) return;
        _boundingRadius = Math.Min(_boundingRadius, CoreExtent.Radius(ref this) + Margin);
    }

    /// <summary>The shape inside.</summary>
    public T Inner => _inner;

    /// <summary>The factors, none of them 0.</summary>
    public Vector3 Factors => (Vector3)_scale.Factors;

    /// <inheritdoc/>
    public Double3 Center => _center;

    /// <inheritdoc/>
    public double Margin => _scale.Margin(_inner.Margin);

    /// <summary>The inner radius times the largest factor, or what the scaled core's supports along its axes show where
    /// that is less; NaN in a <c>default</c> struct, which no query accepts.</summary>
    public double BoundingRadius => _scale.Largest > 0 ? _boundingRadius : double.NaN;

    object ILibraryShape.MakeTraits() => new LibraryTraits<Scaled<T>>();

    bool ILibraryShape.TryGetForm(out ShapeForm form) => TryGetForm(out form);

    /// <inheritdoc cref="ILibraryShape.TryGetForm"/>
    internal bool TryGetForm(out ShapeForm form)
    {
        T inner = _inner;
        if (!(_scale.Largest > 0) || !ShapeTraits<T>.Instance.TryGetForm(ref inner, out form) || !form.Scale(_scale))
            return ShapeForm.None(out form);
        form.Center = _center;
        form.CenterError = _scale.Outward(form.CenterError) + _centerError;
        return true;
    }

    /// <inheritdoc/>
    public int Support(in Double3 direction, out Double3 point)
    {
        Double3 inward = _scale.Inward(direction);
        int id = _inner.Support(inward, out point);
        id = _scale.Outward(id, _inner.Margin, inward, ref point);
        point += _centerError;
        return id;
    }

    /// <inheritdoc/>
    public unsafe void GetFace(in Double3 direction, ref FaceCorners corners)
    {
        if (_inner.Margin > 0 && !_scale.KeepsBalls) return;
        OuterFrame outer = _scale.Frame(corners, direction);
        OuterFrame* around = corners.Outer;
        if (!_scale.KeepsBalls) corners.Outer = &outer;
        _inner.GetFace(_scale.Inward(direction), ref corners);
        corners.Outer = around;
        _scale.Outward(ref corners, _centerError);
    }

    /// <inheritdoc/>
    public bool TryGetVertex(int id, out Double3 point)
    {
        bool found = _inner.TryGetVertex(id, out point) && (_scale.KeepsBalls || _inner.Margin == 0);
        point = Double3.Multiply(_scale.Factors, point) + _centerError;
        return found;
    }
}
