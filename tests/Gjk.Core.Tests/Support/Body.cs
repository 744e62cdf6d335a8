using System;
using System.Collections.Generic;

namespace Gjk.Core.Tests.Support;

/// <summary>What every <see cref="Body{T}"/> shares.</summary>
internal static class Body
{
    /// <summary>
    /// Unit directions on a lattice (faces, edges and corners of a cube, and finer) and a few that are on none.
    /// </summary>
    public static readonly Vector3D[] Directions = MakeDirections();

    private static Vector3D[] MakeDirections()
    {
        var found = new List<Vector3D>();
        for (int i = 0; i < 125; i++)
        {
            var v = new Vector3D(i % 5 - 2, i / 5 % 5 - 2, i / 25 - 2);
            if (v.LengthSquared > 0) found.Add(v * (1 / v.Length));
        }

        var rng = new Rng(1);
        for (int i = 0; i < 40; i++)
        {
            Vector3D v = rng.Direction();
            found.Add(v * (1 / v.Length));
        }

        return [.. found];
    }
}

/// <summary>
/// A posed shape with its own rotation matrix, made here from the quaternion and not taken from the library.
/// </summary>
internal sealed class Body<T>
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
        foreach (Vector3D u in Body.Directions) most = Math.Max(most, Vector3D.Dot(u, outward) - LocalHeight(u));
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
