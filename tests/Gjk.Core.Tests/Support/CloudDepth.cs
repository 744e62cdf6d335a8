namespace Gjk.Core.Tests.Support;

/// <summary>The shortest translation that separates two overlapping clouds, to double accuracy: all planes that can be
/// a face of their difference are tried.</summary>
internal static class CloudDepth
{
    public static double Of(TestPair pair)
    {
        Double3[] a = World(pair.A, pair.PoseA, default);
        Double3[] b = World(pair.B, pair.PoseB, (Double3)pair.PoseB.Position - pair.PoseA.Position);
        double least = double.PositiveInfinity;
        foreach (Double3 n in FaceNormals(a, b)) least = Math.Min(least, Math.Min(Past(a, b, n), Past(a, b, -n)));
        return least;
    }

    /// <summary>The part of a line on which the clouds overlap when B moves along it: where it has entered all
    /// half-spaces of their difference, and not left any; empty where the first is larger than the second.</summary>
    /// <returns>Both as fractions of the motion, and the normal of the plane entered last, from A to B.</returns>
    public static (double Entry, double Exit, Double3 Normal) Along(TestPair pair, Double3 motion)
    {
        Double3[] a = World(pair.A, pair.PoseA, default);
        Double3[] b = World(pair.B, pair.PoseB, (Double3)pair.PoseB.Position - pair.PoseA.Position);
        double entry = double.NegativeInfinity, exit = double.PositiveInfinity;
        Double3 normal = default;
        foreach (Double3 side in FaceNormals(a, b))
        {
            foreach (Double3 n in new[] { side, -side })
            {
                double slope = Double3.Dot(n, motion), at = Past(a, b, n) / slope;
                if (slope > 0) exit = Math.Min(exit, at);
                if (slope < 0 && at > entry) (entry, normal) = (at, n);
                if (slope == 0 && Past(a, b, n) < 0) entry = double.PositiveInfinity;
            }
        }

        return (entry, exit, normal);
    }

    /// <summary>How the signed distance of clouds that only touch changes at first when B moves: by the best of the
    /// planes in which they touch, each of which goes on separating them if B does not move against its
    /// normal.</summary>
    /// <param name="pair">The clouds.</param>
    /// <param name="motion">Of B.</param>
    /// <param name="noise">Length: what is no further apart touches.</param>
    public static double Rate(TestPair pair, Double3 motion, double noise)
    {
        Double3[] a = World(pair.A, pair.PoseA, default);
        Double3[] b = World(pair.B, pair.PoseB, (Double3)pair.PoseB.Position - pair.PoseA.Position);
        double most = double.NegativeInfinity;
        foreach (Double3 side in FaceNormals(a, b))
        {
            if (Past(a, b, side) <= noise) most = Math.Max(most, Double3.Dot(side, motion));
            if (Past(a, b, -side) <= noise) most = Math.Max(most, -Double3.Dot(side, motion));
        }

        return most;
    }

    private static IEnumerable<Double3> FaceNormals(Double3[] a, Double3[] b)
    {
        List<Double3> edgesA = Edges(a), edgesB = Edges(b), all = [.. edgesA, .. edgesB];
        for (int i = 0; i < all.Count; i++)
        {
            for (int j = i + 1; j < all.Count; j++)
            {
                Double3 n = Double3.Cross(all[i], all[j]);
                double length = n.Length;
                if (length > 1e-12 * all[i].Length * all[j].Length) yield return n * (1 / length);
            }
        }
    }

    /// <summary>How far A must move against n to leave B behind.</summary>
    private static double Past(Double3[] a, Double3[] b, in Double3 n) => Highest(a, n) + Highest(b, -n);

    private static double Highest(Double3[] points, in Double3 n)
    {
        double most = double.NegativeInfinity;
        foreach (Double3 p in points) most = Math.Max(most, Double3.Dot(p, n));
        return most;
    }

    private static List<Double3> Edges(Double3[] points)
    {
        var edges = new List<Double3>();
        for (int i = 0; i < points.Length; i++)
            for (int j = i + 1; j < points.Length; j++) edges.Add(points[j] - points[i]);
        return edges;
    }

    private static Double3[] World(TestShape shape, in RigidPose pose, in Double3 position)
    {
        var body = new Body<ConvexShape>(shape.Shape, pose);
        var points = new Double3[shape.Vertices!.Length];
        for (int i = 0; i < points.Length; i++) points[i] = body.Rotate(shape.Vertices[i]) + position;
        return points;
    }
}
