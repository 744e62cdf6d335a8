namespace Gjk.Exact.Fuzz;

/// <summary>Directions in which a look-up of a shape's furthest point might go wrong, in the shape's frame and of about
/// unit length.</summary>
internal static class SupportDirections
{
    private const int MostFaces = 12, Edges = 12, Scattered = 12;

    /// <summary>What a component may be beside one of about 1: nothing, far below the rounding of a dot product, or the
    /// least number there is.</summary>
    private static readonly double[] Tiny = [0, 1e-17, -1e-17, 1e-12, -1e-9, 1e-300, -double.Epsilon];

    /// <param name="body">The shape.</param>
    /// <param name="seed">Of those that are drawn at random.</param>
    public static IEnumerable<Double3> Of(PosedShape body, ulong seed)
    {
        var random = new Rng(seed);
        foreach (Double3 d in Directions.Few) yield return d;
        for (int i = 0; i < Scattered; i++)
        {
            yield return random.Direction();
            yield return Thinned(random, random.Direction());
            yield return CellBorder(random, body.Sides);
        }

        foreach (Double3 n in body.FaceNormals(MostFaces))
        {
            yield return n;
            yield return -n;
            yield return Thinned(random, n);
        }

        Double3[] vertices = body.Vertices;
        for (int i = 0; i < Edges && vertices.Length > 1; i++)
        {
            Double3 edge = vertices[random.Below(vertices.Length)] - vertices[random.Below(vertices.Length)];
            if (TryUnit(edge, out Double3 along)) yield return along;
            if (TryUnit(Double3.Cross(along, random.Direction()), out Double3 across)) yield return across;
        }
    }

    /// <summary>With one or two components next to nothing.</summary>
    private static Double3 Thinned(Rng random, in Double3 d)
    {
        int spared = random.Below(3), other = random.Below(3);
        double x = Component(0, d.X), y = Component(1, d.Y), z = Component(2, d.Z);
        return Math.Max(Math.Abs(x), Math.Max(Math.Abs(y), Math.Abs(z))) >= 0.1 ? new Double3(x, y, z) : d;

        double Component(int axis, double value) => axis == spared || axis == other ? value : random.Of<double>(Tiny);
    }

    /// <summary>On the border of a cell of a cube's face that is cut into 2^k squares a side, for a cube stretched to
    /// the shape's box or not.</summary>
    private static Double3 CellBorder(Rng random, in Double3 sides)
    {
        int parts = 1 << random.Below(7);
        double u = (2.0 * random.Below(parts + 1) - parts) / parts;
        double v = random.OneIn(2) ? random.Range(-1, 1) : (2.0 * random.Below(parts + 1) - parts) / parts;
        Double3 d = random.Below(3) switch
        {
            0 => new(random.Sign(), u, v),
            1 => new(v, random.Sign(), u),
            _ => new(u, v, random.Sign()),
        };
        if (random.OneIn(2) || sides.X == 0 || sides.Y == 0 || sides.Z == 0) return d;
        return TryUnit(new Double3(d.X / sides.X, d.Y / sides.Y, d.Z / sides.Z), out Double3 stretched)
            ? stretched
            : d;
    }

    /// <summary>Of unit length; false for zero, and for what is too long or too short to be squared.</summary>
    private static bool TryUnit(in Double3 v, out Double3 unit)
    {
        double squared = v.LengthSquared;
        unit = v * (1 / Math.Sqrt(squared));
        return squared is > 1e-290 and < 1e290;
    }
}
