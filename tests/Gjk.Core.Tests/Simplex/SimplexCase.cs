using System.Collections.Generic;
using System.Linq;

namespace Gjk.Core.Tests;

/// <summary>
/// A simplex placed so that the origin's nearest feature is known by construction: a point inside the feature, moved
/// out along a direction of the feature's normal cone, is where the origin is put. No coordinate is zero or repeated,
/// so that easy zeros fool no test.
/// </summary>
internal sealed class SimplexCase
{
    private static readonly Vector3D[] Corners =
    [
        new(0.3, -0.7, 1.1), new(1.9, 0.4, -0.2), new(-0.8, 1.6, 0.5), new(0.2, 0.3, 2.7),
    ];

    private static readonly double[] Shares = [0.31, 0.17, 0.29, 0.23];

    private SimplexCase(Vector3D[] vertices, double[] weights, Vector3D normal, double distance)
    {
        Vertices = vertices;
        Weights = weights;
        Normal = normal;
        Distance = distance;
    }

    /// <summary>The vertices, seen from the origin.</summary>
    public Vector3D[] Vertices { get; }

    /// <summary>The nearest point's weights.</summary>
    public double[] Weights { get; }

    /// <summary>The unit vector from the origin to the nearest point.</summary>
    public Vector3D Normal { get; }

    public double Distance { get; }

    /// <summary>
    /// Every subset of the first n corners as the nearest feature, with the origin at three distances, and triangles
    /// from either side.
    /// </summary>
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
        var point = default(Vector3D);
        for (int i = 0; i < n; i++) point += Corners[i] * weights[i];
        Vector3D outward = distance == 0 ? default : Outward(n, subset, side);
        Vector3D origin = point + outward * distance;
        Vector3D[] vertices = [.. Corners.Take(n).Select(c => c - origin)];

        // The fixture's own precondition: no vertex lies further out than the feature.
        foreach (Vector3D c in Corners.Take(n)) Assert.True(Vector3D.Dot(outward, c - point) < 1e-9);
        return new SimplexCase(vertices, weights, -outward, distance);
    }

    /// <summary>A unit vector inside the feature's normal cone.</summary>
    private static Vector3D Outward(int n, int subset, int side)
    {
        var sum = default(Vector3D);
        if (n == 2)
        {
            Vector3D along = Unit(Corners[1] - Corners[0]);
            Vector3D across = Unit(Vector3D.Cross(along, new Vector3D(0.3, 0.5, -0.8)));
            return Unit(subset == 3 ? across : across + along * (subset == 2 ? 0.6 : -0.6));
        }

        if (n == 3)
        {
            Vector3D normal = Unit(Vector3D.Cross(Corners[1] - Corners[0], Corners[2] - Corners[0])) * side;
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

    /// <summary>
    /// In the triangle's plane, away from its corner that is missing, perpendicular to the other two's edge.
    /// </summary>
    private static Vector3D InPlaneOutward(int missing)
    {
        Vector3D p = Corners[(missing + 1) % 3], q = Corners[(missing + 2) % 3], e = Unit(q - p);
        Vector3D inward = Corners[missing] - p;
        return -Unit(inward - e * Vector3D.Dot(e, inward));
    }

    private static Vector3D FaceOutward(int missing)
    {
        Vector3D[] face = [.. Corners.Where((_, i) => i != missing)];
        Vector3D normal = Unit(Vector3D.Cross(face[1] - face[0], face[2] - face[0]));
        return Vector3D.Dot(normal, Corners[missing] - face[0]) > 0 ? -normal : normal;
    }

    private static Vector3D Unit(Vector3D v) => v * (1 / v.Length);
}
