using System;
using System.Collections.Generic;

namespace Gjk.Core.Tests.Support;

/// <summary>
/// The depth of two solid hulls by all facets of their difference: those of each, and a pair of edges wherever the
/// directions across the one cross those across the other. Slower than the library's, but it leaves nothing out.
/// </summary>
internal static class FacetDepth
{
    public static double Of(ConvexHull a, in RigidPose poseA, ConvexHull b, in RigidPose poseB)
    {
        var bodyA = new Body<ConvexMesh>(new ConvexMesh(a), poseA);
        var bodyB = new Body<ConvexMesh>(new ConvexMesh(b), poseB);
        Vector3D[] pointsA = Points(a, bodyA, default), pointsB = Points(b, bodyB, bodyB.Position - bodyA.Position);
        List<Arc> arcsA = Arcs(a, pointsA, 1), arcsB = Arcs(b, pointsB, -1);
        double least = double.PositiveInfinity;
        foreach (Arc arc in arcsA) least = Math.Min(least, Past(pointsA, pointsB, arc.From));
        foreach (Arc arc in arcsB) least = Math.Min(least, Past(pointsA, pointsB, arc.From));
        foreach (Arc x in arcsA)
        {
            foreach (Arc y in arcsB)
            {
                if (!x.TryCross(y, out Vector3D normal)) continue;
                least = Math.Min(
                    least, Vector3D.Dot(normal, pointsA[x.Corner]) - Vector3D.Dot(normal, pointsB[y.Corner]));
            }
        }

        return least;
    }

    private static Vector3D[] Points(ConvexHull hull, Body<ConvexMesh> body, in Vector3D position)
    {
        var points = new Vector3D[hull.VertexCount];
        for (int i = 0; i < points.Length; i++) points[i] = body.Rotate(hull.GetVertex(i)) + position;
        return points;
    }

    /// <summary>For each edge the directions across it, from one facet's normal to the other's.</summary>
    private static List<Arc> Arcs(ConvexHull hull, Vector3D[] points, double sign)
    {
        var normals = new Dictionary<(int, int), Vector3D>();
        for (int i = 0; i < hull.TriangleCount; i++)
        {
            hull.GetTriangle(i, out int a, out int b, out int c);
            Vector3D normal = Vector3D.Cross(points[b] - points[a], points[c] - points[a]);
            normal *= sign / normal.Length;
            normals[(a, b)] = normals[(b, c)] = normals[(c, a)] = normal;
        }

        var arcs = new List<Arc>();
        foreach (((int from, int to), Vector3D normal) in normals)
            arcs.Add(new Arc(from, normal, normals[(to, from)]));
        return arcs;
    }

    private static double Past(Vector3D[] a, Vector3D[] b, in Vector3D n)
    {
        double most = double.NegativeInfinity, least = double.PositiveInfinity;
        foreach (Vector3D p in a) most = Math.Max(most, Vector3D.Dot(p, n));
        foreach (Vector3D p in b) least = Math.Min(least, Vector3D.Dot(p, n));
        return most - least;
    }

    /// <summary>Directions between two on the shorter way, with a corner that is furthest in all of them.</summary>
    private readonly record struct Arc(int Corner, Vector3D From, Vector3D To)
    {
        public bool TryCross(in Arc other, out Vector3D normal)
        {
            normal = default;
            Vector3D across = Vector3D.Cross(From, To), acrossOther = Vector3D.Cross(other.From, other.To);
            double a = Vector3D.Dot(acrossOther, From), b = Vector3D.Dot(acrossOther, To);
            if (!(a * b < 0)) return false;
            double c = Vector3D.Dot(across, other.From), d = Vector3D.Dot(across, other.To);
            if (!(c * d < 0)) return false;
            normal = Vector3D.Cross(across, acrossOther);
            normal *= Math.Sign(Vector3D.Dot(normal, From + To)) / normal.Length;
            return Vector3D.Dot(normal, other.From + other.To) > 0;
        }
    }
}
