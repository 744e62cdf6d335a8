using System;
using System.Collections.Generic;

namespace Gjk.Core.Tests.Support;

/// <summary>What every <see cref="Body{T}"/> shares.</summary>
internal static class Body
{
    /// <summary>Unit directions on a lattice (faces, edges and corners of a cube, and finer) and a few that are on none.</summary>
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

/// <summary>A posed shape with its own rotation matrix, made here from the quaternion and not taken from the library.</summary>
internal sealed class Body<T>
    where T : struct, ISupportMap
{
    private readonly T _shape;
    private readonly Vector3D _row0, _row1, _row2;

    public Body(in T shape, in RigidPose pose)
    {
        _shape = shape;
        Position = pose.Position;
        double x = pose.Rotation.X, y = pose.Rotation.Y, z = pose.Rotation.Z, w = pose.Rotation.W;
        double s = 1 / (x * x + y * y + z * z + w * w);
        _row0 = new Vector3D(w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)) * s;
        _row1 = new Vector3D(2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)) * s;
        _row2 = new Vector3D(2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z) * s;
    }

    public Vector3D Position { get; }

    public double Radius => _shape.BoundingRadius + _shape.Center.Length;

    public Vector3D Rotate(in Vector3D v) => new(Vector3D.Dot(_row0, v), Vector3D.Dot(_row1, v), Vector3D.Dot(_row2, v));

    public Vector3D InverseRotate(in Vector3D v) => _row0 * v.X + _row1 * v.Y + _row2 * v.Z;

    public Vector3D ToWorld(in Vector3D local) => Rotate(local) + Position;

    /// <summary>How far the shape reaches from its position along a unit direction of the world.</summary>
    public double Height(in Vector3D direction) => LocalHeight(InverseRotate(direction));

    /// <summary>How far a local point is outside: the most that it exceeds the support by in any of the fixed directions, or in that from the centre.</summary>
    public double Outside(in Vector3D local)
    {
        double most = double.NegativeInfinity;
        foreach (Vector3D u in Body.Directions) most = Math.Max(most, Vector3D.Dot(u, local) - LocalHeight(u));
        Vector3D out1 = local - _shape.Center;
        double length = out1.Length;
        if (length > 0) most = Math.Max(most, Vector3D.Dot(out1, local) / length - LocalHeight(out1 * (1 / length)));
        return double.IsFinite(local.X + local.Y + local.Z) ? most : double.PositiveInfinity;
    }

    private double LocalHeight(in Vector3D direction)
    {
        _shape.Support(direction, -1, out Vector3D point);
        return Vector3D.Dot(direction, point) + _shape.Margin;
    }
}
