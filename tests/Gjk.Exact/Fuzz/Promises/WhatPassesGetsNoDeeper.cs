namespace Gjk.Exact.Fuzz.Promises;

/// <summary>A cast that passes what gets no deeper says the same as without the option, or misses; and then no place on
/// the way is deeper than is allowed.</summary>
internal static class WhatPassesGetsNoDeeper
{
    /// <summary>Places on the way that are looked at.</summary>
    private const int Looks = 8;

    /// <summary>Ratio of a position: what rounding it to float does to a depth, twice over.</summary>
    private const double PoseRounding = 2.5e-7;

    /// <summary>Ratio of the way: the slope that counts as a slide, with room.</summary>
    private const double Slope = 1.1 / (1 << 20);

    public static string? Broken(FuzzPair pair)
    {
        foreach (double part in (ReadOnlySpan<double>)[0, 0.01])
        {
            var allowed = (float)(part * pair.Scale);
            if (float.IsFinite(allowed) && Problem(pair, allowed) is { } problem) return problem;
        }

        return null;
    }

    private static string? Problem(FuzzPair pair, float allowed)
    {
        CastResult r = pair.Cast, s = ConvexQuery.Cast(
            pair.A, pair.PoseA, pair.Motion.A, pair.B, pair.PoseB, pair.Motion.B, 1, CastOptions.OnlyDeeper(allowed));
        if (s.Status != CastStatus.Miss || r.Status == CastStatus.Miss)
            return SameCast.BitProblem(r, s, Say.Line($"up to {allowed:R} deep"));
        return Deeper(pair, 1, Math.Max(allowed, r.Depth));
    }

    /// <summary>Where the pair gets deeper than is allowed, or null, by the signed distances on the way.</summary>
    public static string? Deeper(FuzzPair pair, double most, double allowed)
    {
        Double3 way = pair.Motion.Relative * most, from = (Double3)pair.PoseB.Position;
        double slack = Accuracy.CurvedRatio * pair.Scale + Slope * way.Length + Accuracy.LeastFloat
            + PoseRounding * (pair.BodyA.Position.Length + from.Length + way.Length);
        for (int i = 1; i <= Looks; i++)
        {
            var at = new RigidPose(pair.PoseB.Rotation, (Vector3)(from + way * ((double)i / Looks)));
            DistanceResult d = ConvexQuery.SignedDistance(pair.A, pair.PoseA, pair.B, at);
            if (d.Status == GjkStatus.Overlapping && -d.Distance > allowed + slack)
                return Say.Line($"it passes, but after {i} parts of {Looks} it is {-d.Distance:R} deep");
        }

        return null;
    }
}
