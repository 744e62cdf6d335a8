using System;

namespace Gjk.Core;

/// <summary>
/// Any shape turned and moved inside the local frame: a capsule along x, a collider beside its object's origin.
/// </summary>
/// <remarks>
/// The shape's centre is placed in double-double and its rounding error is kept, so a shape placed far from the local
/// origin loses no accuracy.
/// </remarks>
/// <typeparam name="T">The shape inside.</typeparam>
public readonly struct Placed<T> : ISupportMap, ILibraryShape
    where T : struct, ISupportMap
{
    /// <summary>
    /// Ratio: 32 u, more than a rotation in double can lengthen a vector by: 26 u at most (proofs/placed.g).
    /// </summary>
    private const double RoundingUp = 1 + 32 * RoundOff.Unit;

    private readonly T _inner;
    private readonly RigidPose _pose;
    private readonly RotationD _rotation;
    private readonly Double3 _center, _centerError;
    private readonly double _boundingRadius;

    /// <summary>Places a shape.</summary>
    /// <param name="inner">The shape.</param>
    /// <param name="pose">Where it is in the frame of the placed shape.</param>
    /// <exception cref="ArgumentOutOfRangeException">The pose is a <c>default</c> struct.</exception>
    public Placed(in T inner, in RigidPose pose)
    {
        _inner = inner;
        _pose = Guard.Pose(pose, nameof(pose));
        _rotation = new RotationD(pose.Rotation);
        VectorDD center = VectorDD.Place(pose, inner.Center);
        _center = (Double3)center;
        _centerError = (Double3)(center - _center);
        _boundingRadius = inner.BoundingRadius * RoundingUp + _centerError.Length;
    }

    /// <summary>The shape inside.</summary>
    public T Inner => _inner;

    /// <summary>Pose of the inner shape in this one's frame.</summary>
    public RigidPose Pose => _pose;

    /// <inheritdoc/>
    public Double3 Center => _center;

    /// <inheritdoc/>
    public double Margin => _inner.Margin;

    /// <summary>
    /// As <see cref="ISupportMap.BoundingRadius"/>; NaN in a <c>default</c> struct, which no query accepts.
    /// </summary>
    public double BoundingRadius => _pose.IsValid ? _boundingRadius : double.NaN;

    object ILibraryShape.MakeTraits() => new LibraryTraits<Placed<T>>(ShapeTraits<T>.AreTight);

    bool ILibraryShape.TryGetTarget(out RayTarget target)
    {
        T inner = _inner;
        if (!_pose.IsValid || !ShapeTraits<T>.Of.TryGetTarget(ref inner, out target))
        {
            target = default;
            return false;
        }

        target.Center = _center;
        target.CenterError = _rotation.Rotate(target.CenterError) + _centerError;
        return target.Place(_pose.Rotation);
    }

    /// <inheritdoc/>
    public int Support(in Double3 direction, out Double3 point)
    {
        Double3 inward = _rotation.InverseRotate(DirectionRange.ToSafe(direction));
        int id = _inner.Support(inward, out point);
        point = _rotation.Rotate(point) + _centerError;
        return id;
    }

    /// <inheritdoc/>
    public unsafe void GetFace(in Double3 direction, ref FaceCorners corners)
    {
        OuterFrame turned = default;
        OuterFrame* around = corners.Outer;
        if (around != null)
        {
            turned = around->Turned(_rotation);
            corners.Outer = &turned;
        }

        _inner.GetFace(_rotation.InverseRotate(DirectionRange.ToSafe(direction)), ref corners);
        corners.Outer = around;
        for (int i = 0; i < corners.Count; i++) corners[i] = _rotation.Rotate(corners[i]) + _centerError;
    }

    /// <inheritdoc/>
    public bool TryGetVertex(int id, out Double3 point)
    {
        bool found = _inner.TryGetVertex(id, out point);
        point = _rotation.Rotate(point) + _centerError;
        return found;
    }
}
