using System;
using System.Collections.Generic;

namespace Gjk.Core.Tests.Support;

/// <summary>
/// The shortest translation that separates two overlapping clouds, to double accuracy: all planes that can be a face of
/// their difference are tried.
/// </summary>
internal static class Depth
{
    public static double Of(TestPair pair)
    {
        Vector3D[] a = World(pair.A, pair.PoseA, default);
        Vector3D[] b = World(pair.B, pair.PoseB, (Vector3D)pair.PoseB.Position - pair.PoseA.Position);
        double least = double.PositiveInfinity;
        List<Vector3D> edgesA = Edges(a), edgesB = Edges(b), all = [.. edgesA, .. edgesB];
        for (int i = 0; i < all.Count; i++)
        {
            for (int j = i + 1; j < all.Count; j++)
            {
                Vector3D n = Vector3D.Cross(all[i], all[j]);
                double length = n.Length;
                if (length <= 1e-12 * all[i].Length * all[j].Length) continue;
                n *= 1 / length;
                least = Math.Min(least, Math.Min(Past(a, b, n), Past(a, b, -n)));
            }
        }

        return least;
    }

    /// <summary>How far A must move against n to leave B behind.</summary>
    private static double Past(Vector3D[] a, Vector3D[] b, in Vector3D n) => Highest(a, n) + Highest(b, -n);

    private static double Highest(Vector3D[] points, in Vector3D n)
    {
        double most = double.NegativeInfinity;
        foreach (Vector3D p in points) most = Math.Max(most, Vector3D.Dot(p, n));
        return most;
    }

    private static List<Vector3D> Edges(Vector3D[] points)
    {
        var edges = new List<Vector3D>();
        for (int i = 0; i < points.Length; i++)
            for (int j = i + 1; j < points.Length; j++) edges.Add(points[j] - points[i]);
        return edges;
    }

    private static Vector3D[] World(TestShape shape, in RigidPose pose, in Vector3D position)
    {
        var body = new Body<ConvexShape>(shape.Shape, pose);
        var points = new Vector3D[shape.Vertices!.Length];
        for (int i = 0; i < points.Length; i++) points[i] = body.Rotate(shape.Vertices[i]) + position;
        return points;
    }
}
