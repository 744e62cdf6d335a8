namespace Gjk.Exact.Fuzz.Promises;

/// <summary>How a cast begins and ends, and what changes none. <see cref="CastProof"/> holds it to the truth.</summary>
internal static class CastPromises
{
    /// <summary>A cast says that shapes overlap at its start exactly where the signed distance says so, with its depth
    /// and normal. Shapes that only touch there are a hit at 0 or a miss.</summary>
    public static string? BeginAsTheDepthSays(FuzzPair pair)
    {
        CastResult r = pair.Cast;
        DistanceResult start = pair.Signed;
        bool isLimit = start.Status == GjkStatus.IterationLimit;
        double depth = isLimit ? -start.LowerBound : -start.Distance;
        if (r.Status == CastStatus.OverlappingAtStart)
        {
            return pair.Answer.IsOverlapping && r.Normal.Equals(start.Normal) && r.Depth == Math.Max(depth, 0)
                ? null
                : Say.Line($"the cast says {r}, the signed distance {start.Status}, {start.Distance:R}");
        }

        if (!pair.Answer.IsOverlapping) return null;
        if (IsDeep(pair)) return Say.Line($"the cast says {r}, but the depth is {depth:R}");
        bool isTouch = r.Status == CastStatus.Miss || (r.Status == CastStatus.Hit && r.Fraction == 0);
        return isTouch ? null : Say.Line($"the cast says {r.Status}, {r.Fraction:R}, but they touch at the start");
    }

    /// <summary>Whether the shapes overlap at the start by more than what may be called touching.</summary>
    public static bool IsDeep(FuzzPair pair)
    {
        DistanceResult start = pair.Signed;
        if (start.Status == GjkStatus.IterationLimit) return true;
        return pair.Answer.IsOverlapping
            && -start.Distance > (pair.IsCurved ? Accuracy.CurvedRatio * pair.Scale : 0);
    }

    /// <summary>A largest fraction cuts a cast off: before it nothing changes, to the last bit, and what comes after it
    /// is a miss.</summary>
    public static string? EndAtTheLargestFraction(FuzzPair pair)
    {
        CastResult r = pair.Cast;
        float f = r.Status == CastStatus.Hit ? r.Fraction : 1;
        foreach (float most in (ReadOnlySpan<float>)[-1, 0, f * 0.5f, f * 0.999f, f, f * 1.001f, 2])
        {
            if (Cut(pair, Cast(pair, most), Math.Max(most, 0)) is { } problem)
                return Say.Line($"up to {most:R}: {problem}");
        }

        return Cast(pair, float.NaN).Status == CastStatus.InvalidInput
            ? null
            : "a largest fraction that is NaN is taken";
    }

    /// <summary>With A and B exchanged the cast is the same, mirrored, within the accuracy.</summary>
    public static string? Mirror(FuzzPair pair)
    {
        CastResult s = ConvexQuery.Cast(pair.B, pair.PoseB, pair.Motion.B, pair.A, pair.PoseA, pair.Motion.A);
        return SameCast.Problem(pair, s.Swapped, "exchanged");
    }

    /// <summary>Moving both shapes by one more vector over the cast changes neither the fraction nor the normal, where
    /// the sums of floats are exact.</summary>
    public static string? CountTheRelativeMotion(FuzzPair pair)
    {
        Vector3 a = pair.Motion.A, b = pair.Motion.B;
        foreach (Vector3 shared in (ReadOnlySpan<Vector3>)[-a, -b, new(1024, -2048, 512), a - b])
        {
            if (!ExactSums.TryAdd(a, shared, out Vector3 withA) || !ExactSums.TryAdd(b, shared, out Vector3 withB))
                continue;
            CastResult r = pair.Cast, s = ConvexQuery.Cast(pair.A, pair.PoseA, withA, pair.B, pair.PoseB, withB);
            if (r.Status != s.Status || !r.Fraction.Equals(s.Fraction) || !r.Normal.Equals(s.Normal))
                return Say.Line($"{shared} more: {s.Status}, {s.Fraction:R}; as given: {r.Status}, {r.Fraction:R}");
        }

        return null;
    }

    /// <summary>A warm start changes a cast by no more than the accuracy: an empty one, what the cast itself left, and
    /// what the distance did.</summary>
    public static string? AreColdWhenWarm(FuzzPair pair)
    {
        WarmStart own = default, ofDistance = default;
        ConvexQuery.Distance(pair.A, pair.PoseA, pair.B, pair.PoseB, ref ofDistance);
        return Warm(ref own, "first, empty") ?? Warm(ref own, "its own") ?? Warm(ref ofDistance, "the distance's");

        string? Warm(ref WarmStart warm, string name) => SameCast.Problem(
            pair,
            ConvexQuery.Cast(pair.A, pair.PoseA, pair.Motion.A, pair.B, pair.PoseB, pair.Motion.B, ref warm, 1),
            name);
    }

    private static CastResult Cast(FuzzPair pair, float most) =>
        ConvexQuery.Cast(pair.A, pair.PoseA, pair.Motion.A, pair.B, pair.PoseB, pair.Motion.B, most);

    private static string? Cut(FuzzPair pair, in CastResult s, float most)
    {
        CastResult r = pair.Cast;
        if (r.Status == CastStatus.IterationLimit || s.Status == CastStatus.IterationLimit) return null;
        bool isBefore = r.Status == CastStatus.OverlappingAtStart
            || (r.Status == CastStatus.Hit && r.Fraction < most);

        // A fraction that was rounded down to the limit is beyond it.
        bool isAt = most <= 1 && r.Status == CastStatus.Hit && r.Fraction == most && s.Status == CastStatus.Hit;
        if (isBefore || isAt) return SameCast.BitProblem(r, s, "with the limit");
        if (most > 1) return CastProof.Problem(pair, s, most);
        return s.Status == CastStatus.Miss && s.Fraction == most
            ? null
            : Say.Line($"{s.Status}, {s.Fraction:R}; without it {r.Status}, {r.Fraction:R}");
    }
}
