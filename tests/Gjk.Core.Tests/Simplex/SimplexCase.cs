namespace Gjk.Core.Tests;

/// <summary>A simplex placed so that the origin's nearest feature is known by construction: a point inside the feature,
/// moved out along a direction of the feature's normal cone, is where the origin is put. No coordinate is zero or
/// repeated, so that easy zeros fool no test.</summary>
internal sealed class SimplexCase
{
    private static readonly Double3[] Corners =
    [
        new(0.3, -0.7, 1.1), new(1.9, 0.4, -0.2), new(-0.8, 1.6, 0.5), new(0.2, 0.3, 2.7),
    ];

    private static readonly double[] Shares = [0.31, 0.17, 0.29, 0.23];

    private SimplexCase(Double3[] vertices, double[] weights, Double3 normal, double distance)
    {
        Vertices = vertices;
        Weights = weights;
        Normal = normal;
        Distance = distance;
    }

    /// <summary>The vertices, seen from the origin.</summary>
    public Double3[] Vertices { get; }

    /// <summary>The nearest point's weights.</summary>
    public double[] Weights { get; }

    /// <summary>The unit vector from the origin to the nearest point.</summary>
    public Double3 Normal { get; }

    public double Distance { get; }

    /// <summary>Every subset of the first n corners as the nearest feature, with the origin at three distances, and
    /// triangles from either side.</summary>
    public static IEnumerable<object[]> All(int n)
    {
        for (int subset = 1; subset < 1 << n; subset++)
        {
            bool solid = n == 4 && subset == 15;
            foreach (double distance in solid ? [0.0] : new[] { 0.37, 5.9, 3e-7 })
            {
                foreach (int side in n == 3 ? [1, -1] : new[] { 1 }) yield return [n, subset, distance, side];
            }
        }
    }

    public static SimplexCase Make(int n, int subset, double distance, int side)
    {
        double total = Enumerable.Range(0, n).Where(i => (subset >> i & 1) != 0).Sum(i => Shares[i]);
        double[] weights =
            [.. Enumerable.Range(0, 4).Select(i => i < n && (subset >> i & 1) != 0 ? Shares[i] / total : 0)];
        var point = default(Double3);
        for (int i = 0; i < n; i++) point += Corners[i] * weights[i];
        Double3 outward = distance == 0 ? default : Outward(n, subset, side);
        Double3 origin = point + outward * distance;
        Double3[] vertices = [.. Corners.Take(n).Select(c => c - origin)];

        // The fixture's own precondition: no vertex lies further out than the feature.
        foreach (Double3 c in Corners.Take(n)) Assert.True(Double3.Dot(outward, c - point) < 1e-9);
        return new SimplexCase(vertices, weights, -outward, distance);
    }

    /// <summary>A unit vector inside the feature's normal cone.</summary>
    private static Double3 Outward(int n, int subset, int side)
    {
        var sum = default(Double3);
        if (n == 2)
        {
            Double3 along = Unit(Corners[1] - Corners[0]);
            Double3 across = Unit(Double3.Cross(along, new Double3(0.3, 0.5, -0.8)));
            return Unit(subset == 3 ? across : across + along * (subset == 2 ? 0.6 : -0.6));
        }

        if (n == 3)
        {
            Double3 normal = Unit(Double3.Cross(Corners[1] - Corners[0], Corners[2] - Corners[0])) * side;
            for (int missing = 0; missing < 3; missing++)
            {
                if ((subset >> missing & 1) == 0) sum += InPlaneOutward(missing);
            }

            return Unit(sum + normal * 0.4);
        }

        for (int missing = 0; missing < 4; missing++)
        {
            if ((subset >> missing & 1) == 0) sum += FaceOutward(missing);
        }

        return Unit(sum);
    }

    /// <summary>In the triangle's plane, away from its corner that is missing, perpendicular to the other two's
    /// edge.</summary>
    private static Double3 InPlaneOutward(int missing)
    {
        Double3 p = Corners[(missing + 1) % 3], q = Corners[(missing + 2) % 3], e = Unit(q - p);
        Double3 inward = Corners[missing] - p;
        return -Unit(inward - e * Double3.Dot(e, inward));
    }

    private static Double3 FaceOutward(int missing)
    {
        Double3[] face = [.. Corners.Where((_, i) => i != missing)];
        Double3 normal = Unit(Double3.Cross(face[1] - face[0], face[2] - face[0]));
        return Double3.Dot(normal, Corners[missing] - face[0]) > 0 ? -normal : normal;
    }

    private static Double3 Unit(Double3 v) => v * (1 / v.Length);
}
