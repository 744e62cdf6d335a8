using System;
using System.Collections.Generic;

namespace Gjk.Core.Tests.Support;

/// <summary>
/// Where the exact walk may start: the nearest feature, found by the same walk in doubles. It need not be right, since the exact walk goes on from any
/// simplex; it only saves steps on long integers.
/// </summary>
internal static class ExactGuess
{
    private const int MostSteps = 64;

    /// <summary>Ratio to |v|²: what is left between the planes is rounding.</summary>
    private const double Closed = 1e-15;

    private readonly record struct Corner(int I, int J, Vector3D W);

    /// <summary>The Minkowski vertices of the feature, at least one and at most four.</summary>
    public static Int3[] Feature(ExactProblem problem)
    {
        Vector3D first = problem.FirstVertex(), v = first;
        List<Corner> feature = [new Corner(0, 0, first)];
        for (int step = 0; step < MostSteps; step++)
        {
            double squared = v.LengthSquared;
            if (!(squared > 0) || double.IsInfinity(squared)) break;
            (int i, int j, Vector3D fromFirst) = problem.RoughSupport(v * (-1 / Math.Sqrt(squared)));
            Vector3D w = first + fromFirst;
            if (squared - Vector3D.Dot(v, w) <= Closed * squared || feature.Exists(c => c.I == i && c.J == j)) break;
            List<Corner> next = Nearest([.. feature, new Corner(i, j, w)], out Vector3D nearest);
            if (!(nearest.LengthSquared < squared)) break;
            (feature, v) = (next, nearest);
        }

        return [.. feature.ConvertAll(c => problem.Vertex(c.I, c.J))];
    }

    /// <summary>The nearest of all faces that hold the projection of the origin.</summary>
    private static List<Corner> Nearest(Corner[] simplex, out Vector3D nearest)
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

            if (!TryProject(face, out Vector3D v)) continue;
            double squared = v.LengthSquared;
            if (squared > least || (squared == least && face.Count >= best.Count)) continue;
            (best, nearest, least) = (face, v, squared);
        }

        return best;
    }

    /// <summary>The origin's projection, if it lies inside the face.</summary>
    private static bool TryProject(List<Corner> face, out Vector3D v)
    {
        Vector3D a = face[0].W;
        v = a;
        if (face.Count == 1) return true;
        Vector3D ab = face[1].W - a;
        if (face.Count == 2)
        {
            double t = -Vector3D.Dot(a, ab) / ab.LengthSquared;
            v = a + ab * t;
            return t > 0 && t < 1;
        }

        Vector3D b = face[1].W, c = face[2].W, n = Vector3D.Cross(ab, c - a);
        if (face.Count == 3)
        {
            v = n * (Vector3D.Dot(n, a) / n.LengthSquared);
            return Vector3D.Dot(n, Vector3D.Cross(a, b)) > 0 && Vector3D.Dot(n, Vector3D.Cross(b, c)) > 0 && Vector3D.Dot(n, Vector3D.Cross(c, a)) > 0;
        }

        Vector3D d = face[3].W;
        v = default;
        int side = Math.Sign(Vector3D.Dot(n, d - a));
        return side != 0 && Volume(default, b, c, d) == side && Volume(a, default, c, d) == side && Volume(a, b, default, d) == side && Volume(a, b, c, default) == side;
    }

    private static int Volume(in Vector3D a, in Vector3D b, in Vector3D c, in Vector3D d) => Math.Sign(Vector3D.Dot(Vector3D.Cross(b - a, c - a), d - a));
}
