namespace Gjk.Exact.Fuzz.Concave;

/// <summary>Rays, casts and times of impact against single queries of all parts.</summary>
internal static class FirstOfParts
{
    /// <summary>More pairs of parts than these take longer than all other promises.</summary>
    private const int MostCasts = 4000, MostImpacts = 150;

    private const int RayCount = 4;

    public static string? Rays(ConcavePair pair)
    {
        Rng random = pair.Random(6);
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

    private static string? Ray(ConcavePair pair, Vector3 origin, Vector3 direction, float most, Rng random)
    {
        RayCastResult[] all =
            [.. pair.PartsA.Select(part => ConvexQuery.RayCast(part, pair.PoseA, origin, direction, most))];
        if (all.Any(one => one.Status is CastStatus.IterationLimit or CastStatus.InvalidInput)) return null;
        int[] met = [.. Enumerable.Range(0, all.Length).Where(i => all[i].IsHit)];
        var found = new List<RayHit>();
        ConcaveQuery.RayCastAll(pair.A, pair.PoseA, origin, direction, pair.Scratch, found, most);
        if (!found.Select(hit => pair.RawA.IsConvex ? 0 : hit.Part).Order().SequenceEqual(met)
            || found.Any(hit => hit.Distance != all[Math.Max(hit.Part, 0)].Distance))
            return Say.Line($"{found.Count} hits of parts, but there are {met.Length}");
        if (found.Zip(found.Skip(1)).Any(two => two.First.Distance > MathF.BitIncrement(two.Second.Distance)))
            return Say.Line($"{found.Count} hits of parts, not in their order");
        RayHit first = ConcaveQuery.RayCast(pair.A, pair.PoseA, origin, direction, pair.Scratch, most);
        if (pair.RawA.IsSolid)
        {
            PointTruth at = PointTruth.Of(pair, origin, random);
            if (at.Distance == 0) return null;
            if (at.IsInside)
                return first.Status == CastStatus.OverlappingAtStart && first.Result.Depth == at.Distance
                    ? null
                    : Say.Line($"{first}, but it begins {at.Distance:R} inside");
        }

        if (met.Length == 0) return first.Status == CastStatus.Miss ? null : Say.Line($"{first}, but no part is met");
        RayCastResult least = met.Select(i => all[i])
            .OrderBy(r => r.Distance).ThenByDescending(r => r.Status == CastStatus.OverlappingAtStart)
            .ThenByDescending(r => r.Depth).First();
        RayCastResult own = all[Math.Max(first.Part, 0)];
        return first.Status == least.Status && IsAsEarly(first.Distance, least.Distance)
            && first.Result.Depth == least.Depth
            && own.Status == first.Status && own.Distance == first.Distance && own.Normal == first.Result.Normal
            ? null
            : Say.Line($"{first}, but {least}, and {own} of that part");
    }

    public static string? Casts(ConcavePair pair)
    {
        if (pair.PairCount > MostCasts || pair.IsUnknown) return null;
        (Vector3 a, Vector3 b) = (pair.Motion.A, pair.Motion.B);
        CastOptions options = pair.Random(7).OneIn(4) && !pair.HasSolid ? CastOptions.OnlyDeeper() : default;
        CastResult[] all = pair.Ask(
            (in ConvexShape x, in ConvexShape y) =>
                ConvexQuery.Cast(x, pair.PoseA, a, y, pair.PoseB, b, 1, options));
        CastHit found = ConcaveQuery.Cast(
            pair.A, pair.PoseA, a, pair.B, pair.PoseB, b, pair.Scratch, 1, options);
        if (pair.HoldsPiece)
        {
            return found is { Status: CastStatus.OverlappingAtStart, Fraction: 0 }
                ? null
                : Say.Line($"inside: {found}");
        }

        if (pair.HasSolid && pair.Least == 0) return null;

        // What begins deeper in the union than is allowed may slide along it, so that some contacts do not count.
        bool slides = options.PassesShallow && pair.Least == 0;
        if (!slides) return First(pair, all, found);
        return Own(pair, all, found) is { } how && !IsOfUnion(pair, found, options) ? how : null;
    }

    /// <summary>Count: so often what begins in a union is moved out of a part.</summary>
    private const int MostLifts = 4;

    /// <summary>Whether a contact is that of its parts from where B is out of the union: by the deepest way out after
    /// the other; one that leads back goes along the last, and back to the touch; one that is less than a position can
    /// say is as long as its rounding.</summary>
    private static bool IsOfUnion(ConcavePair pair, in CastHit found, in CastOptions options)
    {
        RigidPose pose = pair.PoseB;
        float allowed = options.AllowedDepth;
        Double3 last = default;
        for (int i = 0; i < MostLifts; i++)
        {
            CastResult start = Along(pair, pose, Vector3.Zero);
            if (start.Status != CastStatus.OverlappingAtStart || !(start.Depth > allowed)) break;
            Double3 normal = start.Normal, way = normal;
            double back = Double3.Dot(normal, last), along = 1 - back * back;
            bool isBent = back < 0 && along > 1.0 / 1024;
            if (isBent) way = (normal - last * back) * (1 / along);
            way *= start.Depth;
            RigidPose moved = Moved(pose, way);
            if (moved == pose) moved = Moved(pose, normal * (RoundingOf(pair.PoseA) + RoundingOf(pose)));
            pose = moved;
            if (isBent && Along(pair, pose, (Vector3)(-way)) is { IsHit: true } met)
                pose = Moved(pose, -way * met.Fraction);
            (last, allowed) = (normal, RoundingOf(pair.PoseA) + RoundingOf(pose));
        }

        int index = pair.IndexOf(found.PartA, found.PartB);
        if (index < 0 || pose == pair.PoseB) return false;
        CastResult own = ConvexQuery.Cast(
            pair.PartsA[index / pair.PartsB.Length], pair.PoseA, pair.Motion.A,
            pair.PartsB[index % pair.PartsB.Length], pose, pair.Motion.B, 1,
            CastOptions.OnlyDeeper(RoundingOf(pair.PoseA) + RoundingOf(pose)));
        return own.Status == found.Status && own.Fraction == found.Fraction && own.Normal == found.Result.Normal;
    }

    private static CastResult Along(ConcavePair pair, in RigidPose pose, Vector3 way) => ConcaveQuery.Cast(
        pair.A, pair.PoseA, Vector3.Zero, pair.B, pose, way, pair.Scratch, way == Vector3.Zero ? 0 : 1).Result;

    private static RigidPose Moved(in RigidPose pose, in Double3 way) =>
        new(pose.Rotation, (Vector3)((Double3)pose.Position + way));

    private static float RoundingOf(in RigidPose pose)
    {
        Vector3 at = Vector3.Abs(pose.Position);
        return (float)(((double)at.X + at.Y + at.Z) / (1 << 20));
    }

    public static string? Impacts(ConcavePair pair)
    {
        if (pair.PairCount > MostImpacts || pair.IsUnknown || pair.HasSolid) return null;
        Rng random = pair.Random(8);
        var a = new RigidMotion(pair.PoseA, pair.Motion.A, random.Vector(1));
        var b = new RigidMotion(pair.PoseB, pair.Motion.B, random.Vector(1));
        CastResult[] all = pair.Ask((in ConvexShape x, in ConvexShape y) => ConvexQuery.TimeOfImpact(x, a, y, b));
        return First(pair, all, ConcaveQuery.TimeOfImpact(pair.A, a, pair.B, b, pair.Scratch));
    }

    private static string? First(ConcavePair pair, CastResult[] all, in CastHit found)
    {
        if (all.Any(one => one.Status is not (CastStatus.Hit or CastStatus.Miss or CastStatus.OverlappingAtStart)))
            return null;
        CastResult[] met = [.. all.Where(one => one.IsHit)];
        if (met.Length == 0) return found.Status == CastStatus.Miss ? null : Say.Line($"{found}, but no parts meet");
        CastResult least = met.OrderBy(r => r.Fraction)
            .ThenByDescending(r => r.Status == CastStatus.OverlappingAtStart).ThenByDescending(r => r.Depth).First();
        return found.Status == least.Status && IsAsEarly(found.Fraction, least.Fraction)
            && found.Result.Depth == least.Depth
            ? Own(pair, all, found)
            : Say.Line($"{found}, but {least} of other parts");
    }

    /// <summary>Whether two parts are met at once: what is solved to a part of a float's last place may be rounded to
    /// either side.</summary>
    private static bool IsAsEarly(float found, float least) => found <= MathF.BitIncrement(least);

    /// <summary>What is found is the answer for its own parts: where several are met at one fraction, it may be that of
    /// any of them.</summary>
    private static string? Own(ConcavePair pair, CastResult[] all, in CastHit found)
    {
        if (!found.IsHit) return null;
        CastResult own = all[pair.IndexOf(found.PartA, found.PartB)];
        return own.Status == found.Status && own.Fraction == found.Fraction && own.Normal == found.Result.Normal
            ? null
            : Say.Line($"{found}, but {own} of these parts");
    }
}
