using Gjk.Exact.Fuzz.Promises;

namespace Gjk.Exact.Fuzz.HalfSpaces;

/// <summary>All promises about half-spaces, those first that the others build on.</summary>
internal static class HalfSpacePromises
{
    /// <summary>Ratio to the motion: what rounding may leave open of how fast it leaves the plane. The library counts
    /// 16 roundings as none.</summary>
    private const double OfMotion = 32.0 / (1L << 53);

    /// <summary>How many rays are sent at a half-space.</summary>
    private const int Rays = 3;

    public static IReadOnlyList<Promise<HalfSpacePair>> All { get; } =
    [
        new("the signed distance is that of the support, exact", Signed),
        new("Distance and Overlaps say what the signed distance says", TheSame),
        new("exchanging the half-space and the other mirrors the bits", Mirrored),
        new("a cast meets the plane when the support does", Casts),
        new("a ray meets the plane where it is", RaysOf),
    ];

    private static string? Signed(HalfSpacePair pair)
    {
        DistanceResult r = pair.Signed;
        double band = pair.Noise + Accuracy.DistanceRatio * Math.Abs(pair.Gap);
        bool isRight = r.Status is GjkStatus.Separated or GjkStatus.Overlapping
            && Math.Abs(r.Distance - pair.Gap) <= band && r.IsOverlapping == r.Distance <= 0
            && r.LowerBound <= pair.Gap + (pair.IsCurved ? pair.Noise : 0) && r.LowerBound >= pair.Gap - 4 * band
            && ((Double3)r.Normal - pair.Outward).Length <= Accuracy.UnitLength;
        return isRight
            ? null
            : Say.Line($"{r.Status}, {r.Distance:R}, at least {r.LowerBound:R}, along {r.Normal}; truly {pair.Gap:R}");
    }

    private static string? TheSame(HalfSpacePair pair)
    {
        DistanceResult r = pair.Signed;
        DistanceResult distance = ConvexQuery.Distance(pair.Plane, pair.PlanePose, pair.Other, pair.Pose);
        bool overlaps = ConvexQuery.Overlaps(pair.Plane, pair.PlanePose, pair.Other, pair.Pose);
        if (overlaps != r.IsOverlapping || distance.Status != r.Status || distance.Distance != Math.Max(r.Distance, 0))
            return Say.Line($"{r.Status}, {r.Distance:R}; {distance.Status}, {distance.Distance:R}; {overlaps}");

        // Where rounding leaves open on which side of the plane it is, a signed distance may be below 0.
        return overlaps ? null : Same.BitProblem(r, distance, "Distance", Math.Max(r.LowerBound, 0));
    }

    private static string? Mirrored(HalfSpacePair pair) => Same.BitProblem(
        pair.Signed, ConvexQuery.SignedDistance(pair.Other, pair.Pose, pair.Plane, pair.PlanePose).Swapped, "swapped");

    private static string? Casts(HalfSpacePair pair)
    {
        PairMotion m = pair.Motion;
        CastResult r = ConvexQuery.Cast(pair.Plane, pair.PlanePose, m.A, pair.Other, pair.Pose, m.B);
        double rate = pair.RateOf(m.Relative), noise = OfMotion * ((Double3)m.A).Length + OfMotion * m.Length;
        return Met(r.Status, r.Fraction, 1, pair.Gap, pair.Noise, rate, noise);
    }

    private static string? RaysOf(HalfSpacePair pair)
    {
        for (int i = 0; i < Rays; i++)
        {
            // From the shape's own place and along its motion, so that shrinking keeps the ray.
            Vector3 origin = pair.Pose.Position + pair.Motion.A * i;
            Vector3 direction = i == 1 ? -pair.Motion.B : pair.Motion.B;
            if (direction == default || !float.IsFinite(origin.LengthSquared())) continue;
            RayCastResult r = ConvexQuery.RayCast(pair.Plane, pair.PlanePose, origin, direction);
            double gap = pair.HeightOf(origin), length = ((Double3)direction).Length;
            double noise = Accuracy.LeastFloat + Accuracy.Offset * ((Double3)origin - pair.PlanePose.Position).Length;
            double rate = pair.RateOf(direction) / length;
            if (Met(r.Status, r.Distance, double.PositiveInfinity, gap, noise, rate, OfMotion) is { } wrong)
                return Say.Line($"from {origin} along {direction}: {wrong}");
        }

        return null;
    }

    /// <summary>How a meeting is not that of a gap that changes at a constant rate, or null.</summary>
    /// <param name="status">What the query says.</param>
    /// <param name="at">When it says that they meet.</param>
    /// <param name="most">How long the motion takes.</param>
    /// <param name="gap">The true gap at the start, and what may be noise of it.</param>
    /// <param name="noise">What may be noise of the gap.</param>
    /// <param name="rate">How the gap changes.</param>
    /// <param name="rateNoise">What may be noise of that.</param>
    private static string? Met(
        CastStatus status, double at, double most, double gap, double noise, double rate, double rateNoise)
    {
        bool isRight = status switch
        {
            CastStatus.OverlappingAtStart => gap <= noise,
            CastStatus.Miss => gap >= -noise && (rate + rateNoise >= 0
                || gap * (1 + Accuracy.DistanceRatio) + noise + (rate + rateNoise) * most >= 0),
            CastStatus.Hit => gap >= -noise && at >= 0 && at <= most && Math.Abs(gap + rate * at)
                <= noise + rateNoise * at + Accuracy.DistanceRatio * gap + Accuracy.LeastFloat * Math.Abs(rate),
            _ => false,
        };
        return isRight ? null : Say.Line($"{status} at {at:R}, but the gap is {gap:R} and changes by {rate:R}");
    }
}
