namespace Gjk.Exact.Fuzz.Promises;

/// <summary>Comparisons with the cold cast.</summary>
internal static class SameCast
{
    /// <summary>How an answer to the same question differs from the cold one by more than the accuracy, or null. Where
    /// a graze was called the other way, both answers must have their proof.</summary>
    public static string? Problem(FuzzPair pair, in CastResult other, string name)
    {
        CastResult r = pair.Cast;
        if (BitProblem(r, other, name) is not { } differs) return null;
        double slack = 2 * CastProof.Slack(pair, r.Fraction);
        if (r.Status == other.Status && Math.Abs((double)r.Fraction - other.Fraction) <= slack) return null;
        string? problem = CastProof.Problem(pair, other, 1) ?? CastProof.Problem(pair, r, 1);
        return problem is null ? null : $"{differs}: {problem}";
    }

    /// <summary>How two casts differ in any bit, or null; iterations do not count.</summary>
    public static string? BitProblem(in CastResult r, in CastResult s, string name) =>
        r.Status == s.Status && r.Fraction.Equals(s.Fraction) && r.Point.Equals(s.Point) && r.Normal.Equals(s.Normal)
            && r.Depth.Equals(s.Depth)
            ? null
            : Say.Line(
                $"{name}: {s.Status}, {s.Fraction:R}, {s.Point}; as given: {r.Status}, {r.Fraction:R}, {r.Point}");
}
