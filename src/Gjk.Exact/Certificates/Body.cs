using System;
using Gjk.Core;

namespace Gjk.Exact.Certificates;

/// <summary>
/// A posed shape with its own rotation matrix, made here from the quaternion and not taken from the library.
/// </summary>
public sealed class Body<T>
    where T : struct, ISupportMap
{
    private readonly T _shape;
    private readonly ApproximateRotation _rotation;

    public Body(in T shape, in RigidPose pose)
    {
        _shape = shape;
        Pose = pose;
        Center = shape.Center;
        _rotation = new ApproximateRotation(pose.Rotation);
        Radius = 0.5 * new Vector3D(
            Side(new Vector3D(1, 0, 0)), Side(new Vector3D(0, 1, 0)), Side(new Vector3D(0, 0, 1))).Length;
    }

    public RigidPose Pose { get; }

    public Vector3D Position => Pose.Position;

    public Vector3D Center { get; }

    /// <summary>
    /// Half the diagonal of the local bounding box, by the shape's own supports: the bounding radius may be generous.
    /// </summary>
    public double Radius { get; }

    public Vector3D Rotate(in Vector3D v) => _rotation.Rotate(v);

    public Vector3D InverseRotate(in Vector3D v) => _rotation.InverseRotate(v);

    public Vector3D ToWorld(in Vector3D local) => Rotate(local) + Position;

    /// <summary>How far the shape reaches from its position along a unit direction of the world.</summary>
    public double Height(in Vector3D direction) =>
        Vector3D.Dot(direction, Rotate(Center)) + HeightOverCenter(direction);

    /// <summary>The same from its centre, which loses nothing where the shape is far from its own origin.</summary>
    public double HeightOverCenter(in Vector3D direction) => LocalHeight(InverseRotate(direction));

    /// <summary>
    /// How far a local point is outside: the most that it exceeds the support by in any of the fixed directions, or in
    /// that from the centre.
    /// </summary>
    public double Outside(in Vector3D local)
    {
        double most = double.NegativeInfinity;
        Vector3D outward = local - Center;
        foreach (Vector3D u in Directions.Many) most = Math.Max(most, Vector3D.Dot(u, outward) - LocalHeight(u));
        double length = outward.Length;
        if (length > 0) most = Math.Max(most, length - LocalHeight(outward * (1 / length)));
        return double.IsFinite(local.X + local.Y + local.Z) ? most : double.PositiveInfinity;
    }

    private double Side(in Vector3D axis) => LocalHeight(axis) + LocalHeight(-axis);

    private double LocalHeight(in Vector3D direction)
    {
        _shape.Support(direction, out Vector3D point);
        return Vector3D.Dot(direction, point) + _shape.Margin;
    }
}
