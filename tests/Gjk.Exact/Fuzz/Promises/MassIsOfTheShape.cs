namespace Gjk.Exact.Fuzz.Promises;

/// <summary>The centre of mass of what has a volume lies in the shape, no moment exceeds the sum of the two others, a
/// pose changes no volume and takes the centre along, and a polytope's volume is that of its tetrahedra.</summary>
internal static class MassIsOfTheShape
{
    /// <summary>Ratio to the cube of the longest side: what summing thousands of tetrahedra may lose.</summary>
    private const double OfSum = 1e-12;

    public static string? Broken(FuzzPair pair) =>
        Problem(pair, pair.A.GetMassProperties(), pair.A.Placed(pair.PoseB).GetMassProperties());

    /// <summary>What is wrong with two answers, which may be lies: for A, and for A placed as B is.</summary>
    public static string? Problem(FuzzPair pair, in MassProperties mass, in MassProperties placed)
    {
        ConvexShape shape = pair.A;
        double side = pair.BodyA.LongestSide, cube = side * side * side;
        if (!(mass.Volume >= 0 && mass.Volume <= cube * 8)) return Say.Line($"its volume is {mass.Volume}");
        if (placed.Volume != mass.Volume) return Say.Line($"placed, its volume is {placed.Volume} for {mass.Volume}");
        double sum = shape is { Hull: { } hull, Margin: 0 } ? Volume(hull, shape.Scale) : mass.Volume;
        if (!(Math.Abs(sum - mass.Volume) <= OfSum * cube))
            return Say.Line($"its volume is {mass.Volume}, its tetrahedra have {sum}");
        Double3 i = mass.InertiaDiagonal;
        double most = Math.Max(i.X, Math.Max(i.Y, i.Z)), all = i.X + i.Y + i.Z;
        if (!(2 * most <= all * (1 + Accuracy.Rounding))) return Say.Line($"its moments are {i}");
        double outside = mass.Volume > 0 ? pair.BodyA.Outside(mass.Center, Directions.Few) : 0;
        if (!(outside <= Accuracy.Rounding * (side + pair.BodyA.Center.Length)))
            return Say.Line($"its centre {mass.Center} lies {outside} outside");
        var turn = new ApproximateRotation(pair.PoseB.Rotation);
        double off = (turn.Rotate(mass.Center) + pair.PoseB.Position - placed.Center).Length;
        double size = side + mass.Center.Length + ((Double3)pair.PoseB.Position).Length;
        return off <= Accuracy.Rounding * size ? null : Say.Line($"placed, its centre is {off} off");
    }

    private static double Volume(ConvexHull hull, Vector3 scale)
    {
        double sum = 0;
        for (int i = 0; i < hull.TriangleCount; i++)
        {
            hull.GetTriangle(i, out int a, out int b, out int c);
            Double3 p = hull.GetVertex(a) - hull.Center, q = hull.GetVertex(b) - hull.Center;
            sum += Double3.Dot(p, Double3.Cross(q, hull.GetVertex(c) - hull.Center));
        }

        return Math.Abs(sum / 6 * scale.X * scale.Y * scale.Z);
    }
}
