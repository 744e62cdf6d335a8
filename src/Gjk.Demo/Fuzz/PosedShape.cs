using System;
using System.Collections.Generic;
using Gjk.Core;

namespace Gjk.Demo.Fuzz;

/// <summary>
/// A shape where it is, seen without the library's solvers: a rotation matrix of its own, the vertices listed, and heights found by looking at all of them.
/// </summary>
internal sealed class PosedShape
{
    private readonly ConvexShape _shape;
    private readonly Vector3D[] _fromCenter;
    private readonly Vector3D _row0, _row1, _row2;

    public PosedShape(in ConvexShape shape, in RigidPose pose)
    {
        _shape = shape;
        Position = pose.Position;
        double x = pose.Rotation.X, y = pose.Rotation.Y, z = pose.Rotation.Z, w = pose.Rotation.W;
        double s = 1 / (x * x + y * y + z * z + w * w);
        _row0 = new Vector3D(w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)) * s;
        _row1 = new Vector3D(2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)) * s;
        _row2 = new Vector3D(2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z) * s;
        Vertices = ListVertices(shape);
        _fromCenter = Array.ConvertAll(Vertices, v => v - Center);
        LongestSide = Math.Max(Side(new Vector3D(1, 0, 0)), Math.Max(Side(new Vector3D(0, 1, 0)), Side(new Vector3D(0, 0, 1))));
        Reach = Center.Length + shape.BoundingRadius;
    }

    public Vector3D Position { get; }

    public Vector3D Center => _shape.Center;

    public double Margin => _shape.Margin;

    /// <summary>In the local frame, scale applied; empty where the core is curved.</summary>
    public Vector3D[] Vertices { get; }

    public bool IsCurved => Vertices.Length == 0;

    /// <summary>The longest side of the local bounding box, margin included.</summary>
    public double LongestSide { get; }

    /// <summary>How far from its position the shape's numbers reach: what their rounding is measured by.</summary>
    public double Reach { get; }

    public Vector3D Rotate(in Vector3D v) => new(Vector3D.Dot(_row0, v), Vector3D.Dot(_row1, v), Vector3D.Dot(_row2, v));

    public Vector3D InverseRotate(in Vector3D v) => _row0 * v.X + _row1 * v.Y + _row2 * v.Z;

    /// <summary>How far the shape reaches beyond its centre along a unit direction of the world.</summary>
    public double Height(in Vector3D direction) => LocalHeight(InverseRotate(direction));

    /// <summary>The most that a local point exceeds the shape by along any of the directions, or along that from the centre; all of them in the local frame.</summary>
    public double Outside(in Vector3D local, ReadOnlySpan<Vector3D> directions)
    {
        Vector3D outward = local - Center;
        double length = outward.Length, most = length > 0 ? length - LocalHeight(outward * (1 / length)) : 0;
        foreach (Vector3D u in directions) most = Math.Max(most, Vector3D.Dot(u, outward) - LocalHeight(u));
        return outward.IsFinite ? most : double.PositiveInfinity;
    }

    /// <summary>The directions across up to <paramref name="most"/> triangles of a mesh's surface, in the local frame.</summary>
    public IEnumerable<Vector3D> FaceNormals(int most)
    {
        if (_shape.Hull is not { } hull) yield break;
        int step = Math.Max(1, hull.TriangleCount / most);
        for (int i = 0; i < hull.TriangleCount; i += step)
        {
            hull.GetTriangle(i, out int a, out int b, out int c);
            Vector3D n = Vector3D.Cross(_fromCenter[b] - _fromCenter[a], _fromCenter[c] - _fromCenter[a]);
            double length = n.Length;
            if (length > 0) yield return n * (1 / length);
        }
    }

    private double LocalHeight(in Vector3D direction)
    {
        if (IsCurved)
        {
            _shape.Support(direction, -1, out Vector3D point);
            return Vector3D.Dot(direction, point - Center) + Margin;
        }

        double most = double.NegativeInfinity;
        foreach (Vector3D v in _fromCenter) most = Math.Max(most, Vector3D.Dot(direction, v));
        return most + Margin;
    }

    private double Side(in Vector3D axis) => LocalHeight(axis) + LocalHeight(-axis);

    private static Vector3D[] ListVertices(in ConvexShape shape)
    {
        var vertices = new List<Vector3D>();
        for (int id = 0; shape.TryGetVertex(id, out Vector3D vertex); id++) vertices.Add(vertex);
        return [.. vertices];
    }
}
