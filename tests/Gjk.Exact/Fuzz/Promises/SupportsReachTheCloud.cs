namespace Gjk.Exact.Fuzz.Promises;

/// <summary>In no direction does a shape's support value differ from the greatest dot product with the points that it
/// was made of; of curved shapes, from the formula. The support point is one of those points, to the last bit, and is
/// the vertex that its id names.</summary>
internal static class SupportsReachTheCloud
{
    /// <summary>Ratio: a component so far below the largest one counts for nothing.</summary>
    private const double Underflow = 1e-290;

    public static string? Broken(FuzzPair pair)
    {
        Vector3 place = pair.PoseB.Position;
        ulong seed = BitConverter.SingleToUInt32Bits(place.X) ^ (ulong)BitConverter.SingleToUInt32Bits(place.Y) << 32;
        return Problem(pair.A, pair.BodyA, seed, "A") ?? Problem(pair.B, pair.BodyB, seed + 1, "B");
    }

    /// <summary>How the support towards a direction breaks the promise, or null.</summary>
    public static string? Problem(in ConvexShape shape, PosedShape body, in Double3 d, string name)
    {
        if (d == default || !d.IsFinite) return null;
        int id = shape.Support(d, out Double3 fromCenter);
        Double3 point = shape.Center + fromCenter;
        string? problem = body.IsCurved
            ? OffTheFormula(body, d, point)
            : OffTheCloud(body, d, point) ?? OfAnotherName(shape, body, id, fromCenter);
        return problem is null
            ? null
            : Say.Line(
                $"towards ({d.X:R}, {d.Y:R}, {d.Z:R}) {name} gives ({point.X:R}, {point.Y:R}, {point.Z:R}): {problem}");
    }

    private static string? Problem(in ConvexShape shape, PosedShape body, ulong seed, string name)
    {
        foreach (Double3 d in SupportDirections.Of(body, seed))
        {
            if (Problem(shape, body, d, name) is { } problem) return problem;
        }

        return null;
    }

    private static string? OffTheCloud(PosedShape body, in Double3 d, in Double3 point)
    {
        Double3 unit = Normal(d);
        double highest = body.CoreHeight(unit), height = Double3.Dot(unit, point - body.Center);
        return height >= highest - Rounding(body, unit)
            ? null
            : Say.Line($"lower than the highest point by {highest - height}");
    }

    private static string? OffTheFormula(PosedShape body, in Double3 d, in Double3 point)
    {
        Double3 unit = Normal(d);
        double off = Double3.Dot(unit, point) - body.CoreHeight(unit);
        return Math.Abs(off) <= Rounding(body, unit) ? null : Say.Line($"off the formula's height by {off}");
    }

    private static string? OfAnotherName(in ConvexShape shape, PosedShape body, int id, in Double3 fromCenter)
    {
        if (!shape.TryGetVertex(id, out Double3 vertex) || vertex != fromCenter)
            return Say.Line($"vertex {id} is ({vertex.X:R}, {vertex.Y:R}, {vertex.Z:R})");
        if (shape.Hull is null) return null;
        Double3 named = Double3.Multiply((Double3)shape.Scale, shape.Hull.GetVertex(id));
        double off = (shape.Center + fromCenter - named).Length;
        return named == body.Vertices[shape.Hull.SourceIndex(id)] && off <= 4 * Accuracy.Rounding * body.LongestSide
            ? null
            : Say.Line($"vertex {id} is not point {shape.Hull.SourceIndex(id)} of the cloud");
    }

    /// <summary>What the roundings of two scaled dot products with points of the shape come to, and of the check;
    /// products below the range of doubles are 0.</summary>
    private static double Rounding(PosedShape body, in Double3 unit) =>
        Underflow * body.LongestSide + 2 * Accuracy.Rounding * (
            Math.Abs(unit.X) * body.Extents.X + Math.Abs(unit.Y) * body.Extents.Y + Math.Abs(unit.Z) * body.Extents.Z);

    /// <summary>Brought near unit length by a power of two, which rounds nothing but what is far below the
    /// rest.</summary>
    private static Double3 Normal(in Double3 d)
    {
        int exponent = -Math.ILogB(Math.Max(Math.Abs(d.X), Math.Max(Math.Abs(d.Y), Math.Abs(d.Z))));
        return new Double3(Math.ScaleB(d.X, exponent), Math.ScaleB(d.Y, exponent), Math.ScaleB(d.Z, exponent));
    }
}
