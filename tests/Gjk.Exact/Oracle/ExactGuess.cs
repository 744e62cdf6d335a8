namespace Gjk.Exact.Oracle;

/// <summary>Where the exact walk may start: the nearest feature, found by the same walk in doubles. It need not be
/// right, since the exact walk goes on from any simplex; it only saves steps on long integers.</summary>
public static class ExactGuess
{
    /// <summary>More than hulls need; curved shapes have crept to the rounding of a double by then, or
    /// nearly.</summary>
    private const int MostSteps = 128;

    /// <summary>Ratio to |v|²: what is left between the planes is rounding.</summary>
    private const double Closed = 1e-15;

    /// <summary>A point of the difference, and what made it: two indices, or nothing of interest.</summary>
    public readonly record struct Corner(int I, int J, Double3 W);

    /// <summary>The Minkowski vertices of the feature, at least one and at most four.</summary>
    public static Int3[] Feature(ExactProblem problem)
    {
        Double3 first = problem.FirstVertex();
        List<Corner> feature = Walk(
            new Corner(0, 0, first),
            direction =>
            {
                (int i, int j, Double3 fromFirst) = problem.RoughSupport(direction);
                return new Corner(i, j, first + fromFirst);
            },
            out _);
        return [.. feature.ConvertAll(c => problem.Vertex(c.I, c.J))];
    }

    /// <summary>Walks towards the origin until rounding ends it.</summary>
    /// <param name="first">Any corner of a convex set.</param>
    /// <param name="support">The set's corner that is furthest in a unit direction.</param>
    /// <param name="nearest">The nearest point found; it is in the set, so the set is no further than that.</param>
    /// <returns>The corners around it.</returns>
    public static List<Corner> Walk(Corner first, Func<Double3, Corner> support, out Double3 nearest)
    {
        List<Corner> feature = [first];
        nearest = first.W;
        for (int step = 0; step < MostSteps && feature.Count < 4; step++)
        {
            double squared = nearest.LengthSquared;
            if (!(squared > 0) || double.IsInfinity(squared)) break;
            Corner corner = support(nearest * (-1 / Math.Sqrt(squared)));
            if (squared - Double3.Dot(nearest, corner.W) <= Closed * squared || feature.Contains(corner)) break;
            List<Corner> next = Nearest([.. feature, corner], out Double3 nearer);
            if (!(nearer.LengthSquared < squared)) break;
            (feature, nearest) = (next, nearer);
        }

        return feature;
    }

    /// <summary>The nearest of all faces that hold the projection of the origin.</summary>
    private static List<Corner> Nearest(Corner[] simplex, out Double3 nearest)
    {
        List<Corner> best = [];
        nearest = default;
        double least = double.PositiveInfinity;
        for (int mask = 1; mask < 1 << simplex.Length; mask++)
        {
            List<Corner> face = [];
            for (int i = 0; i < simplex.Length; i++)
            {
                if ((mask >> i & 1) != 0) face.Add(simplex[i]);
            }

            if (!TryProject(face, out Double3 v)) continue;
            double squared = v.LengthSquared;
            if (squared > least || (squared == least && face.Count >= best.Count)) continue;
            (best, nearest, least) = (face, v, squared);
        }

        return best;
    }

    /// <summary>The origin's projection, if it lies inside the face: a mean of the corners with weights that are
    /// positive, so that rounding moves it within the face but never out of it.</summary>
    private static bool TryProject(List<Corner> face, out Double3 v)
    {
        Double3 a = face[0].W;
        v = a;
        if (face.Count == 1) return true;
        Double3 b = face[1].W, ab = b - a;
        if (face.Count == 2)
        {
            double t = -Double3.Dot(a, ab) / ab.LengthSquared;
            v = a * (1 - t) + b * t;
            return t > 0 && t < 1;
        }

        Double3 c = face[2].W, n = Double3.Cross(ab, c - a);
        if (face.Count == 3) return TryMean([a, b, c], [Area(n, b, c), Area(n, c, a), Area(n, a, b)], out v);
        Double3 d = face[3].W;
        double side = Math.Sign(Double3.Dot(n, d - a));
        ReadOnlySpan<double> weights =
        [
            side * Volume(default, b, c, d), side * Volume(a, default, c, d), side * Volume(a, b, default, d),
            side * Volume(a, b, c, default),
        ];
        return TryMean([a, b, c, d], weights, out v);
    }

    private static bool TryMean(ReadOnlySpan<Double3> corners, ReadOnlySpan<double> weights, out Double3 mean)
    {
        mean = default;
        double sum = 0;
        foreach (double w in weights)
        {
            if (!(w > 0)) return false;
            sum += w;
        }

        for (int i = 0; i < corners.Length; i++) mean += corners[i] * (weights[i] / sum);
        return true;
    }

    private static double Area(in Double3 normal, in Double3 a, in Double3 b) =>
        Double3.Dot(normal, Double3.Cross(a, b));

    private static double Volume(in Double3 a, in Double3 b, in Double3 c, in Double3 d) =>
        Double3.Dot(Double3.Cross(b - a, c - a), d - a);
}
