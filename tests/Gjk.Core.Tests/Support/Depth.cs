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
        foreach (Vector3D n in FaceNormals(a, b)) least = Math.Min(least, Math.Min(Past(a, b, n), Past(a, b, -n)));
        return least;
    }

    /// <summary>
    /// The part of a line on which the clouds overlap when B moves along it: where it has entered all half-spaces of
    /// their difference, and not left any; empty where the first is larger than the second.
    /// </summary>
    /// <returns>Both as fractions of the motion, and the normal of the plane entered last, from A to B.</returns>
    public static (double Entry, double Exit, Vector3D Normal) Along(TestPair pair, Vector3D motion)
    {
        Vector3D[] a = World(pair.A, pair.PoseA, default);
        Vector3D[] b = World(pair.B, pair.PoseB, (Vector3D)pair.PoseB.Position - pair.PoseA.Position);
        double entry = double.NegativeInfinity, exit = double.PositiveInfinity;
        Vector3D normal = default;
        foreach (Vector3D side in FaceNormals(a, b))
        {
            foreach (Vector3D n in new[] { side, -side })
            {
                double slope = Vector3D.Dot(n, motion), at = Past(a, b, n) / slope;
                if (slope > 0) exit = Math.Min(exit, at);
                if (slope < 0 && at > entry) (entry, normal) = (at, n);
                if (slope == 0 && Past(a, b, n) < 0) entry = double.PositiveInfinity;
            }
        }

        return (entry, exit, normal);
    }

    /// <summary>
    /// How the signed distance of clouds that only touch changes at first when B moves: by the best of the planes in
    /// which they touch, each of which goes on separating them if B does not move against its normal.
    /// </summary>
    /// <param name="pair">The clouds.</param>
    /// <param name="motion">Of B.</param>
    /// <param name="noise">Length: what is no further apart touches.</param>
    public static double Rate(TestPair pair, Vector3D motion, double noise)
    {
        Vector3D[] a = World(pair.A, pair.PoseA, default);
        Vector3D[] b = World(pair.B, pair.PoseB, (Vector3D)pair.PoseB.Position - pair.PoseA.Position);
        double most = double.NegativeInfinity;
        foreach (Vector3D side in FaceNormals(a, b))
        {
            if (Past(a, b, side) <= noise) most = Math.Max(most, Vector3D.Dot(side, motion));
            if (Past(a, b, -side) <= noise) most = Math.Max(most, -Vector3D.Dot(side, motion));
        }

        return most;
    }

    private static IEnumerable<Vector3D> FaceNormals(Vector3D[] a, Vector3D[] b)
    {
        List<Vector3D> edgesA = Edges(a), edgesB = Edges(b), all = [.. edgesA, .. edgesB];
        for (int i = 0; i < all.Count; i++)
        {
            for (int j = i + 1; j < all.Count; j++)
            {
                Vector3D n = Vector3D.Cross(all[i], all[j]);
                double length = n.Length;
                if (length > 1e-12 * all[i].Length * all[j].Length) yield return n * (1 / length);
            }
        }
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
