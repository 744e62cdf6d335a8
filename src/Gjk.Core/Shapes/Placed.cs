namespace Gjk.Core;

/// <summary>Any shape turned and moved inside the local frame: a capsule along x, a collider beside its object's
/// origin.</summary>
/// <remarks>The shape's centre is placed in double-double and its rounding error is kept, so a shape placed far from
/// the local origin loses no accuracy. Queries ask the shape inside in its own axes, so they stay as fast.</remarks>
/// <typeparam name="T">The shape inside.</typeparam>
public readonly struct Placed<T> : ISupportMap, IPlacedShape<Placed<T>>
    where T : struct, ISupportMap
{
    private readonly T _inner;

    /// <summary>Null in a <c>default</c> struct.</summary>
    private readonly Placement? _placement;

    /// <summary>Places a shape.</summary>
    /// <param name="inner">The shape.</param>
    /// <param name="pose">Where it is in the frame of the placed shape.</param>
    /// <exception cref="ArgumentOutOfRangeException">The pose is a <c>default</c> struct.</exception>
    public Placed(in T inner, in RigidPose pose)
    {
        Guard.Pose(pose, nameof(pose));
        _inner = inner;
        _placement = new Placement(pose, ShapeTraits<T>.Instance.PlacementOf(ref _inner), Core.Center);
    }

    private Placed(in T core)
    {
        _inner = core;
        _placement = Placement.None;
    }

    /// <summary>The shape inside.</summary>
    public T Inner => _inner;

    /// <summary>Pose of the inner shape in this one's frame.</summary>
    public RigidPose Pose => _placement is null ? default : _placement.Pose;

    /// <inheritdoc/>
    public Double3 Center => IsPlaced ? _placement!.Center : _inner.Center;

    /// <inheritdoc/>
    public double Margin => _inner.Margin;

    /// <summary>As <see cref="ISupportMap.BoundingRadius"/>; NaN in a <c>default</c> struct, which no query
    /// accepts.</summary>
    public double BoundingRadius => _placement is null ? double.NaN
        : IsPlaced ? _placement.Radius(Core.BoundingRadius, Margin) : _inner.BoundingRadius;

    private bool IsPlaced => _placement is not null && _placement != Placement.None;

    /// <summary>The shape inside, without the poses that it was placed at before.</summary>
    private T Core => ShapeTraits<T>.Instance.InCoreAxes(_inner);

    object ILibraryShape.MakeTraits() => new PlacedTraits<Placed<T>>(ShapeTraits<T>.AreTight);

    Placement? IPlacedShape<Placed<T>>.Placement => IsPlaced ? _placement : null;

    Placed<T> IPlacedShape<Placed<T>>.InCoreAxes() => _placement is null ? this : new(Core);

    bool ILibraryShape.TryGetForm(out ShapeForm form)
    {
        T core = Core;
        if (_placement is not null && ShapeTraits<T>.Instance.TryGetForm(ref core, out form))
            return !IsPlaced || _placement.TryPlace(ref form);
        return ShapeForm.None(out form);
    }

    /// <inheritdoc/>
    public int Support(in Double3 direction, out Double3 point)
    {
        if (!IsPlaced) return _inner.Support(direction, out point);
        int id = Core.Support(_placement!.Inward(direction), out point);
        point = _placement.Outward(point);
        return id;
    }

    /// <inheritdoc/>
    public void GetFace(in Double3 direction, ref FaceCorners corners)
    {
        if (IsPlaced) _placement!.GetFace(Core, direction, ref corners);
        else _inner.GetFace(direction, ref corners);
    }

    /// <inheritdoc/>
    public bool TryGetVertex(int id, out Double3 point)
    {
        bool found = Core.TryGetVertex(id, out point);
        if (IsPlaced) point = _placement!.Outward(point);
        return found;
    }
}
