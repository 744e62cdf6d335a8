namespace Gjk.Exact.Oracle;

/// <summary>The face of a simplex nearest to the origin, found by trying all of them: the origin's projection must lie
/// inside the face (all weights positive) and no other point of the simplex may be nearer along the direction to it.
/// The least face that holds the nearest point always passes.</summary>
public sealed record ExactFeature(
    Int3[] Points, Int3 Direction, BigInteger SquaredNumerator, BigInteger SquaredDenominator)
{
    public static ExactFeature Nearest(Int3[] simplex)
    {
        for (int size = 1; size <= simplex.Length; size++)
        {
            for (int mask = 1; mask < 1 << simplex.Length; mask++)
            {
                if (BitOperations.PopCount((uint)mask) != size) continue;
                Int3[] face = [.. simplex.Where((_, i) => (mask >> i & 1) != 0)];
                ExactFeature? candidate = Of(face);
                if (candidate is not null && candidate.IsNearest(simplex)) return candidate;
            }
        }

        throw new System.InvalidOperationException("No face of the simplex is nearest: the oracle itself is wrong.");
    }

    private bool IsNearest(Int3[] simplex)
    {
        BigInteger height = Int3.Dot(Direction, Points[0]);
        return simplex.All(p => Int3.Dot(Direction, p) >= height);
    }

    private static ExactFeature? Of(Int3[] p) => p.Length switch
    {
        1 => new ExactFeature(p, p[0], Int3.Dot(p[0], p[0]), 1),
        2 => Segment(p),
        3 => Triangle(p),
        _ => Tetrahedron(p),
    };

    private static ExactFeature? Segment(Int3[] p)
    {
        Int3 edge = p[1] - p[0];
        BigInteger squared = Int3.Dot(edge, edge), t = -Int3.Dot(p[0], edge);
        if (t.Sign <= 0 || t >= squared) return null;
        Int3 nearest = p[0] * squared + edge * t;
        return new ExactFeature(p, nearest, Int3.Dot(nearest, nearest), squared * squared);
    }

    private static ExactFeature? Triangle(Int3[] p)
    {
        Int3 normal = Int3.Cross(p[1] - p[0], p[2] - p[0]);
        if (normal.IsZero) return null;
        bool inside = Int3.Dot(normal, Int3.Cross(p[1], p[2])).Sign > 0
            && Int3.Dot(normal, Int3.Cross(p[2], p[0])).Sign > 0
            && Int3.Dot(normal, Int3.Cross(p[0], p[1])).Sign > 0;
        if (!inside) return null;
        BigInteger height = Int3.Dot(normal, p[0]);
        return new ExactFeature(p, normal * height.Sign, height * height, Int3.Dot(normal, normal));
    }

    private static ExactFeature? Tetrahedron(Int3[] p)
    {
        int a = Volume(default, p[1], p[2], p[3]), b = Volume(p[0], default, p[2], p[3]);
        int c = Volume(p[0], p[1], default, p[3]), d = Volume(p[0], p[1], p[2], default);
        bool encloses = a != 0 && a == b && b == c && c == d;
        return encloses ? new ExactFeature(p, default, 0, 1) : null;
    }

    private static int Volume(Int3 a, Int3 b, Int3 c, Int3 d) => Int3.Dot(b - a, Int3.Cross(c - a, d - a)).Sign;
}
