namespace Gjk.Core.Tests.Support;

/// <summary>The depth of two solid hulls by all facets of their difference: those of each, and a pair of edges wherever
/// the directions across the one cross those across the other. Slower than the library's, but it leaves nothing
/// out.</summary>
internal static class FacetDepth
{
    public static double Of(ConvexHull a, in RigidPose poseA, ConvexHull b, in RigidPose poseB)
    {
        var bodyA = new Body<ConvexMesh>(new ConvexMesh(a), poseA);
        var bodyB = new Body<ConvexMesh>(new ConvexMesh(b), poseB);
        Double3[] pointsA = Points(a, bodyA, default), pointsB = Points(b, bodyB, bodyB.Position - bodyA.Position);
        List<Arc> arcsA = Arcs(a, pointsA, 1), arcsB = Arcs(b, pointsB, -1);
        double least = double.PositiveInfinity;
        foreach (Arc arc in arcsA) least = Math.Min(least, Past(pointsA, pointsB, arc.From));
        foreach (Arc arc in arcsB) least = Math.Min(least, Past(pointsA, pointsB, arc.From));
        foreach (Arc x in arcsA)
        {
            foreach (Arc y in arcsB)
            {
                if (!x.TryCross(y, out Double3 normal)) continue;
                least = Math.Min(
                    least, Double3.Dot(normal, pointsA[x.Corner]) - Double3.Dot(normal, pointsB[y.Corner]));
            }
        }

        return least;
    }

    private static Double3[] Points(ConvexHull hull, Body<ConvexMesh> body, in Double3 position)
    {
        var points = new Double3[hull.VertexCount];
        for (int i = 0; i < points.Length; i++) points[i] = body.Rotate(hull.GetVertex(i)) + position;
        return points;
    }

    /// <summary>For each edge the directions across it, from one facet's normal to the other's.</summary>
    private static List<Arc> Arcs(ConvexHull hull, Double3[] points, double sign)
    {
        var normals = new Dictionary<(int, int), Double3>();
        for (int i = 0; i < hull.TriangleCount; i++)
        {
            hull.GetTriangle(i, out int a, out int b, out int c);
            Double3 normal = Double3.Cross(points[b] - points[a], points[c] - points[a]);
            normal *= sign / normal.Length;
            normals[(a, b)] = normals[(b, c)] = normals[(c, a)] = normal;
        }

        var arcs = new List<Arc>();
        foreach (((int from, int to), Double3 normal) in normals)
            arcs.Add(new Arc(from, normal, normals[(to, from)]));
        return arcs;
    }

    private static double Past(Double3[] a, Double3[] b, in Double3 n)
    {
        double most = double.NegativeInfinity, least = double.PositiveInfinity;
        foreach (Double3 p in a) most = Math.Max(most, Double3.Dot(p, n));
        foreach (Double3 p in b) least = Math.Min(least, Double3.Dot(p, n));
        return most - least;
    }

    /// <summary>Directions between two on the shorter way, with a corner that is furthest in all of them.</summary>
    private readonly record struct Arc(int Corner, Double3 From, Double3 To)
    {
        public bool TryCross(in Arc other, out Double3 normal)
        {
            normal = default;
            Double3 across = Double3.Cross(From, To), acrossOther = Double3.Cross(other.From, other.To);
            double a = Double3.Dot(acrossOther, From), b = Double3.Dot(acrossOther, To);
            if (!(a * b < 0)) return false;
            double c = Double3.Dot(across, other.From), d = Double3.Dot(across, other.To);
            if (!(c * d < 0)) return false;
            normal = Double3.Cross(across, acrossOther);
            normal *= Math.Sign(Double3.Dot(normal, From + To)) / normal.Length;
            return Double3.Dot(normal, other.From + other.To) > 0;
        }
    }
}
