using System;
using System.Collections.Generic;
using Gjk.Core;

namespace Gjk.Exact.Fuzz;

/// <summary>
/// A shape where it is, seen without the library's hulls, supports and solvers: a rotation matrix of its own, the
/// points that the shape was made of, and heights found by looking at all of them. Nothing here depends on the shape's
/// bounding radius, which may be generous.
/// </summary>
internal sealed class PosedShape
{
    private readonly ConvexShape _shape;
    private readonly Vector3D[] _fromCenter;
    private readonly CurvedHeights? _curved;
    private readonly ApproximateRotation _rotation;

    public PosedShape(in FuzzShape shape, in RigidPose pose)
    {
        _shape = shape.Shape;
        _rotation = new ApproximateRotation(pose.Rotation);
        Position = pose.Position;
        Vertices = ListVertices(shape);
        if (Vertices.Length == 0) _curved = new CurvedHeights(_shape);
        else Center = Middle(Vertices);
        _fromCenter = Array.ConvertAll(Vertices, v => v - Center);
        Sides = new Vector3D(Side(new Vector3D(1, 0, 0)), Side(new Vector3D(0, 1, 0)), Side(new Vector3D(0, 0, 1)));
    }

    public Vector3D Position { get; }

    /// <summary>The middle of the local bounding box; the local origin of a curved shape.</summary>
    public Vector3D Center { get; }

    public double Margin => _shape.Margin;

    /// <summary>In the local frame, scale applied, as the shape was given; empty where the core is curved.</summary>
    public Vector3D[] Vertices { get; }

    public bool IsCurved => _curved is not null;

    /// <summary>The sides of the local bounding box, margin included.</summary>
    public Vector3D Sides { get; }

    /// <summary>The largest magnitude of each local coordinate.</summary>
    public Vector3D Extents =>
        new(Math.Abs(Center.X) + 0.5 * Sides.X, Math.Abs(Center.Y) + 0.5 * Sides.Y, Math.Abs(Center.Z) + 0.5 * Sides.Z);

    public double LongestSide => Math.Max(Sides.X, Math.Max(Sides.Y, Sides.Z));

    /// <summary>Half the diagonal of the local bounding box: a ball about the centre that holds the shape.</summary>
    public double Radius => 0.5 * Sides.Length;

    public Vector3D Rotate(in Vector3D v) => _rotation.Rotate(v);

    public Vector3D InverseRotate(in Vector3D v) => _rotation.InverseRotate(v);

    /// <summary>How far the shape reaches beyond its centre along a unit direction of the world.</summary>
    public double Height(in Vector3D direction) => CoreHeight(InverseRotate(direction)) + Margin;

    /// <summary>The same for the core, without the margin, along a direction of the local frame.</summary>
    public double CoreHeight(in Vector3D direction)
    {
        if (_curved is not null) return _curved.Of(direction);
        double most = double.NegativeInfinity;
        foreach (Vector3D v in _fromCenter) most = Math.Max(most, Vector3D.Dot(direction, v));
        return most;
    }

    /// <summary>
    /// The most that a local point exceeds the shape by along any of the directions, or along that from the centre; all
    /// of them in the local frame.
    /// </summary>
    public double Outside(in Vector3D local, ReadOnlySpan<Vector3D> directions)
    {
        Vector3D outward = local - Center;
        double length = outward.Length, most = length > 0 ? length - CoreHeight(outward * (1 / length)) - Margin : 0;
        foreach (Vector3D u in directions) most = Math.Max(most, Vector3D.Dot(u, outward) - CoreHeight(u) - Margin);
        return outward.IsFinite ? most : double.PositiveInfinity;
    }

    /// <summary>
    /// The directions across up to <paramref name="most"/> triangles of a mesh's surface, in the local frame.
    /// </summary>
    public IEnumerable<Vector3D> FaceNormals(int most)
    {
        if (_shape.Hull is not { } hull) yield break;
        int step = Math.Max(1, hull.TriangleCount / most);
        Vector3D factors = _shape.Scale;
        for (int i = 0; i < hull.TriangleCount; i += step)
        {
            hull.GetTriangle(i, out int a, out int b, out int c);
            Vector3D corner = hull.GetVertex(a), ab = hull.GetVertex(b) - corner, ac = hull.GetVertex(c) - corner;
            Vector3D n = Vector3D.Cross(Vector3D.Multiply(factors, ab), Vector3D.Multiply(factors, ac));
            double length = n.Length;
            if (length > 0) yield return n * (1 / length);
        }
    }

    /// <summary>How many directions <see cref="EdgeDirections"/> has; none where the core is curved.</summary>
    public int EdgeCount =>
        _shape.Hull is { TriangleCount: > 0 } hull
            ? 3 * hull.TriangleCount / 2
            : Vertices.Length * (Vertices.Length - 1) / 2;

    /// <summary>
    /// Along the sides of a mesh's triangles, and without triangles along the differences of all vertices, in the local
    /// frame: every edge of the core is along one of them.
    /// </summary>
    public List<Vector3D> EdgeDirections()
    {
        var edges = new List<Vector3D>(EdgeCount);
        if (_shape.Hull is { TriangleCount: > 0 } hull)
        {
            for (int i = 0; i < hull.TriangleCount; i++)
            {
                hull.GetTriangle(i, out int a, out int b, out int c);
                if (a < b) edges.Add(Side(hull, a, b));
                if (b < c) edges.Add(Side(hull, b, c));
                if (c < a) edges.Add(Side(hull, c, a));
            }

            return edges;
        }

        for (int i = 0; i < Vertices.Length; i++)
        {
            for (int j = i + 1; j < Vertices.Length; j++) edges.Add(Vertices[j] - Vertices[i]);
        }

        return edges;
    }

    private Vector3D Side(ConvexHull hull, int from, int to) =>
        Vector3D.Multiply(_shape.Scale, (Vector3D)hull.GetVertex(to) - hull.GetVertex(from));

    private double Side(in Vector3D axis) => CoreHeight(axis) + CoreHeight(-axis) + 2 * Margin;

    private static Vector3D Middle(Vector3D[] vertices)
    {
        Vector3D low = vertices[0], high = low;
        foreach (Vector3D v in vertices)
        {
            low = new Vector3D(Math.Min(low.X, v.X), Math.Min(low.Y, v.Y), Math.Min(low.Z, v.Z));
            high = new Vector3D(Math.Max(high.X, v.X), Math.Max(high.Y, v.Y), Math.Max(high.Z, v.Z));
        }

        return (low + high) * 0.5;
    }

    private static Vector3D[] ListVertices(in FuzzShape shape)
    {
        if (shape.Cloud is { } cloud)
        {
            var scaled = new Vector3D[cloud.Count];
            Vector3D factors = shape.Scale;
            for (int i = 0; i < scaled.Length; i++) scaled[i] = Vector3D.Multiply(factors, cloud[i]);
            return scaled;
        }

        // Segments, boxes and the like: the library multiplies the scale in without rounding, and has at most eight of
        // them.
        var vertices = new List<Vector3D>();
        for (int id = 0; shape.Shape.TryGetVertex(id, out Vector3D vertex); id++)
            vertices.Add(shape.Shape.Center + vertex);
        return [.. vertices];
    }
}
