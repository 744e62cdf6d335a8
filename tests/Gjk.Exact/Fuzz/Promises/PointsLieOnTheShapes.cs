namespace Gjk.Exact.Fuzz.Promises;

/// <summary>Each closest point lies in its shape, in its own frame as in the world's, as far as a float can hold
/// it.</summary>
internal static class PointsLieOnTheShapes
{
    private const int MostFaces = 64;

    /// <summary>Dot products to spend on one shape's faces.</summary>
    private const int MostWork = 8000;

    public static string? Broken(FuzzPair pair)
    {
        DistanceResult r = pair.Answer;
        return r.Status is GjkStatus.Separated or GjkStatus.Overlapping ? Problem(pair, r) : null;
    }

    /// <summary>How the points of an answer for the pair, signed or not, break the promise, or null.</summary>
    public static string? Problem(FuzzPair pair, in DistanceResult r) =>
        Problem(pair, pair.BodyA, r.LocalPointA, r.PointA, "A")
        ?? Problem(pair, pair.BodyB, r.LocalPointB, r.PointB, "B");

    private static string? Problem(FuzzPair pair, PosedShape body, Vector3 local, Vector3 world, string name)
    {
        double slack = pair.WitnessSlack(body) + Accuracy.Rounding * body.LongestSide, rounding = Rounded(local);
        Double3[] directions =
        [
            .. Directions.Few,
            .. body.FaceNormals(Math.Max(1, Math.Min(MostFaces, MostWork / Math.Max(1, body.Vertices.Length)))),
        ];
        double outside = body.Outside(local, directions);
        if (!(outside <= slack + rounding)) return Say.Line($"the local point of {name} lies {outside} outside");
        double off = (body.Rotate(local) + body.Position - world).Length;
        return off <= slack + rounding + Rounded(world)
            ? null
            : Say.Line($"the point of {name} is {off} off the place of its local one");
    }

    /// <summary>What rounding to float does to a point.</summary>
    public static double Rounded(Vector3 p) => 2 * Accuracy.HalfFloat * ((Double3)p).Length + 2 * Accuracy.LeastFloat;
}
