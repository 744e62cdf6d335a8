namespace Gjk.Core.Tests.Support;

/// <summary>Holds an answer against the distances along the way: from each fraction it goes on by what the fastest
/// points need for the gap there, at least a hundred thousandth of the way, so that it sees no less than 1e5 samples
/// would.</summary>
internal static class MotionJudge
{
    /// <summary>Part of the way: the least step.</summary>
    private const double LeastStep = 1e-5;

    /// <summary>Ratio to the scale: nearer than this, the reference calls it contact.</summary>
    private const double Touching = 1e-11;

    /// <summary>Ratio to the scale: what the reference's own accuracy leaves open.</summary>
    private const double Open = 1e-9;

    /// <summary>Ratio to a fraction: the distance to the next float, at most.</summary>
    private const double FloatStep = 1.0 / (1 << 23);

    /// <summary>What is wrong with the answer, or null.</summary>
    public static string? Fault(MotionPair p, in CastResult r, double maxFraction = 1)
    {
        var oracle = new MotionOracle(p);
        double scale = p.Scale;
        (double least, double most) = oracle.At(0);
        if (r.Status == CastStatus.OverlappingAtStart)
            return least > Open * scale ? $"apart by {least:R} at the start" : null;
        if (r.Status is not (CastStatus.Hit or CastStatus.Miss)) return "no answer";
        if (most < -Open * scale) return "they overlap at the start";
        double end = r.Status == CastStatus.Miss ? maxFraction : r.Fraction;
        if (Late(p, oracle, end) is { } late) return late;
        if (r.Status == CastStatus.Miss) return null;
        (least, most) = oracle.At(end);
        double allowed = Allowed(p, end) * (1 + 1e-6) + Open * scale;
        if (least > allowed) return $"the gap is {least:R}, more than {allowed:R}";
        return most < -Open * scale ? $"they overlap by {-most:R}" : null;
    }

    /// <summary>The tolerance, or with it the way between two floats where that is larger.</summary>
    private static double Allowed(MotionPair p, double fraction) =>
        Math.Max(p.Promised, p.Promised / 8 + p.Speed * fraction * FloatStep);

    private static string? Late(MotionPair p, MotionOracle oracle, double end)
    {
        double step = LeastStep * end, speed = p.Speed;
        for (double f = step; f < end;)
        {
            (double least, double most) = oracle.At(f);
            if (most <= Touching * p.Scale) return $"they touch at {f:R} already";
            f += Math.Max(least / speed, step);
        }

        return null;
    }
}
