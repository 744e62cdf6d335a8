using Gjk.Core;

namespace Gjk.Exact.Fuzz.Concave;

/// <summary>Rays, casts and times of impact against single queries of all parts.</summary>
internal static class FirstOfParts
{
    /// <summary>More pairs of parts than these take longer than all other promises.</summary>
    private const int MostCasts = 4000, MostImpacts = 150;

    private const int RayCount = 4;

    public static string? Rays(ConcavePair pair)
    {
        FuzzRandom random = pair.Random(6);
        for (int i = 0; i < RayCount; i++)
        {
            Vector3 origin = PointsOfParts.Near(pair, random);
            Vector3 target = random.OneIn(4) ? PointsOfParts.Near(pair, random) : PointsOfParts.OnA(pair, random);
            Vector3 direction = random.OneIn(6)
                ? new Vector3(random.Below(3) - 1, random.Below(3) - 1, random.Below(3) - 1)
                : target - origin;
            if (direction == Vector3.Zero || !float.IsFinite(direction.LengthSquared())) continue;
            float most = random.OneIn(3) ? direction.Length() * random.Of(1f, 0.5f, 2f) : float.PositiveInfinity;
            if (Ray(pair, origin, direction, most, random) is { } how)
                return Say.Line($"from {RawJson.Of(origin)} along {RawJson.Of(direction)} up to {most:R}: {how}");
        }

        return null;
    }

    private static string? Ray(ConcavePair pair, Vector3 origin, Vector3 direction, float most, FuzzRandom random)
    {
        RayCastResult[] all =
            [.. pair.PartsA.Select(part => ConvexQuery.RayCast(part, pair.PoseA, origin, direction, most))];
        if (all.Any(one => one.Status is CastStatus.IterationLimit or CastStatus.InvalidInput)) return null;
        int[] order =
        [
            .. Enumerable.Range(0, all.Length).Where(i => all[i].IsHit).OrderBy(i => all[i].Distance).ThenBy(i => i),
        ];
        var found = new List<PartRayHit>();
        ConcaveQuery.RayCastAll(pair.A, pair.PoseA, origin, direction, pair.Scratch, found, most);
        if (!found.Select(hit => pair.RawA.IsConvex ? 0 : hit.Part).SequenceEqual(order)
            || found.Any(hit => hit.Distance != all[Math.Max(hit.Part, 0)].Distance))
            return Say.Line($"{found.Count} hits of parts, but there are {order.Length}");
        PartRayHit first = ConcaveQuery.RayCast(pair.A, pair.PoseA, origin, direction, pair.Scratch, most);
        if (pair.RawA.IsSolid)
        {
            PointTruth at = PointTruth.Of(pair, origin, random);
            if (at.Distance == 0) return null;
            if (at.IsInside)
                return first.Status == CastStatus.OverlappingAtStart && first.Result.Depth == at.Distance
                    ? null
                    : Say.Line($"{first}, but it begins {at.Distance:R} inside");
        }

        if (order.Length == 0) return first.Status == CastStatus.Miss ? null : Say.Line($"{first}, but no part is met");
        int least = order.OrderBy(i => all[i].Distance)
            .ThenBy(i => all[i].Status == CastStatus.OverlappingAtStart ? 0 : 1).ThenBy(i => i).First();
        return Math.Max(first.Part, 0) == least && first.Status == all[least].Status
            && first.Distance == all[least].Distance && first.Result.Normal == all[least].Normal
            ? null
            : Say.Line($"{first}, but {all[least]} of {least}");
    }

    public static string? Casts(ConcavePair pair)
    {
        if (pair.PairCount > MostCasts || pair.IsUnknown) return null;
        (Vector3 a, Vector3 b) = (pair.Motion.A, pair.Motion.B);
        CastOptions options = pair.Random(7).OneIn(4) && !pair.HasSolid ? CastOptions.OnlyDeeper() : default;
        CastResult[] all = pair.Ask(
            (in ConvexShape x, in ConvexShape y) =>
                ConvexQuery.Cast(x, pair.PoseA, a, y, pair.PoseB, b, 1, options));
        PartCast found = ConcaveQuery.Cast(
            pair.A, pair.PoseA, a, pair.B, pair.PoseB, b, pair.Scratch, 1, options);
        if (pair.HoldsPiece)
        {
            return found is { Status: CastStatus.OverlappingAtStart, Fraction: 0 }
                ? null
                : Say.Line($"inside: {found}");
        }

        if (pair.HasSolid && pair.Least == 0) return null;
        return First(pair, all, found);
    }

    public static string? Impacts(ConcavePair pair)
    {
        if (pair.PairCount > MostImpacts || pair.IsUnknown || pair.HasSolid) return null;
        FuzzRandom random = pair.Random(8);
        var a = new RigidMotion(pair.PoseA, pair.Motion.A, random.Vector(1));
        var b = new RigidMotion(pair.PoseB, pair.Motion.B, random.Vector(1));
        CastResult[] all = pair.Ask((in ConvexShape x, in ConvexShape y) => ConvexQuery.TimeOfImpact(x, a, y, b));
        return First(pair, all, ConcaveQuery.TimeOfImpact(pair.A, a, pair.B, b, pair.Scratch));
    }

    private static string? First(ConcavePair pair, CastResult[] all, in PartCast found)
    {
        if (all.Any(one => one.Status is not (CastStatus.Hit or CastStatus.Miss or CastStatus.OverlappingAtStart)))
            return null;
        int least = -1;
        for (int i = 0; i < all.Length; i++)
            if (all[i].IsHit && (least < 0 || IsBefore(all[i], all[least]))) least = i;
        if (least < 0) return found.Status == CastStatus.Miss ? null : Say.Line($"{found}, but no parts meet");
        return pair.IndexOf(found.PartA, found.PartB) == least && found.Status == all[least].Status
            && found.Fraction == all[least].Fraction
            ? null
            : Say.Line($"{found}, but {all[least]} of pair {least}");
    }

    private static bool IsBefore(in CastResult a, in CastResult b) =>
        a.Fraction != b.Fraction
            ? a.Fraction < b.Fraction
            : a.Status == CastStatus.OverlappingAtStart && b.Status != CastStatus.OverlappingAtStart;
}
