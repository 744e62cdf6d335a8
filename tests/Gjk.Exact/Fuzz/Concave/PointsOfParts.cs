namespace Gjk.Exact.Fuzz.Concave;

/// <summary>How far a point is from A's parts, whether it is in one of them (a distance may be too short for a float),
/// and whether it is in A's inside, from the raw numbers.</summary>
internal readonly record struct PointTruth(float Distance, bool IsInPart, bool IsInside)
{
    public static PointTruth Of(ConcavePair pair, Vector3 point, Rng random)
    {
        var at = new RigidPose(point);
        float least = float.PositiveInfinity;
        bool isInPart = false;
        foreach (ConvexShape part in pair.PartsA)
        {
            DistanceResult r = ConvexQuery.Distance(part, pair.PoseA, ConvexShape.Point(), at);
            least = Math.Min(least, r.Distance);
            isInPart |= r.IsOverlapping;
        }

        bool isInside = least > 0 && pair.RawA.IsSolid
            && ExactWinding.About(pair.RawA.AllCorners(), pair.PoseA, default, at, random) is not (0 or null);
        return new PointTruth(least, isInPart, isInside);
    }
}

/// <summary>Points against the parts of A.</summary>
internal static class PointsOfParts
{
    private const int Count = 4;

    public static string? Broken(ConcavePair pair)
    {
        Rng random = pair.Random(9);
        for (int i = 0; i < Count; i++)
        {
            Vector3 point = random.OneIn(2) ? Near(pair, random) : OnA(pair, random);
            if (!float.IsFinite(point.LengthSquared())) continue;
            if (At(pair, point, PointTruth.Of(pair, point, random)) is { } how)
                return Say.Line($"the point {RawJson.Of(point)}: {how}");
        }

        return null;
    }

    /// <summary>Between the two, in them or around them.</summary>
    public static Vector3 Near(ConcavePair pair, Rng random)
    {
        Vector3 a = Corner(pair, random), b = Corner(pair, random), c = Corner(pair, random);
        float u = random.Float(-0.3, 1.3), v = random.Float(-0.3, 1.3);
        return a + u * (b - a) + v * (c - a);
    }

    /// <summary>At a corner of A, on an edge or in a triangle, but for rounding, or a little off it.</summary>
    public static Vector3 OnA(ConcavePair pair, Rng random)
    {
        int part = random.Below(pair.PartsA.Length);
        if (pair.RawA.CornersOf(part) is not { Length: >= 3 } corners) return Near(pair, random);
        Double3 local = random.Below(3) switch
        {
            0 => corners[0],
            1 => (corners[0] + corners[1]) * 0.5,
            _ => (corners[0] + corners[1] + corners[2]) * (1.0 / 3),
        };
        Vector3 world = pair.PoseA.TransformPoint((Vector3)local);
        if (random.OneIn(2)) return world;
        double size = (corners[1] - corners[0]).Length * random.Magnitude(1e-8, 1e-2);
        return world + (Vector3)(random.Direction() * size);
    }

    private static Vector3 Corner(ConcavePair pair, Rng random)
    {
        bool isA = random.OneIn(2);
        ConvexShape[] parts = isA ? pair.PartsA : pair.PartsB;
        ConvexShape part = parts[random.Below(parts.Length)];
        part.Support(random.Direction(), out Double3 point);
        return (isA ? pair.PoseA : pair.PoseB).TransformPoint((Vector3)(part.Center + point));
    }

    private static string? At(ConcavePair pair, Vector3 point, in PointTruth truth)
    {
        PairDistance signed = ConcaveQuery.SignedDistance(pair.A, pair.PoseA, point, pair.Scratch);
        if (signed.Status is not (GjkStatus.Separated or GjkStatus.Overlapping)) return null;
        bool isIn = ConcaveQuery.Contains(pair.A, pair.PoseA, point, pair.Scratch);
        if (isIn != (truth.IsInPart || truth.IsInside))
            return Say.Line($"Contains says {isIn}, but it is {truth.Distance:R} away, inside {truth.IsInside}");
        bool hasDepth = pair.RawA.IsConvex;
        if (!hasDepth && signed.Distance != (truth.IsInside ? -truth.Distance : truth.Distance))
            return Say.Line($"{signed}, but it is {truth.Distance:R} away, inside {truth.IsInside}");
        PairDistance plain = ConcaveQuery.Distance(pair.A, pair.PoseA, point, pair.Scratch);
        if (plain.Distance != (isIn ? 0 : truth.Distance)) return Say.Line($"{plain}, but {truth.Distance:R}");
        Vector3 closest = ConcaveQuery.ClosestPoint(pair.A, pair.PoseA, point, pair.Scratch);
        return closest == (isIn ? point : plain.Result.PointA) ? null : Say.Line($"the closest point is {closest}");
    }
}
