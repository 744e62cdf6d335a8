namespace Gjk.Exact.Fuzz.Promises;

/// <summary>The check that users can make refutes no answer, and where the truth is known it is between the check's
/// bounds.</summary>
internal static class TheCheckAgrees
{
    public static string? Broken(FuzzPair pair)
    {
        (ConvexShape a, ConvexShape b, RigidPose poseA, RigidPose poseB) = (pair.A, pair.B, pair.PoseA, pair.PoseB);
        CheckedAnswer distance = AnswerCheck.Distance(a, poseA, b, poseB, pair.Answer);
        return Problem(pair, distance, "the distance")
            ?? Problem(pair, AnswerCheck.SignedDistance(a, poseA, b, poseB, pair.Signed), "the signed distance")
            ?? Problem(pair, AnswerCheck.Overlaps(a, poseA, b, poseB, pair.Answer.IsOverlapping), "the flag")
            ?? Refuted(
                AnswerCheck.Cast(a, poseA, pair.Motion.A, b, poseB, pair.Motion.B, pair.Cast), "the cast");
    }

    private static string? Problem(FuzzPair pair, in CheckedAnswer check, string name)
    {
        if (Refuted(check, name) is { } refuted) return refuted;
        if (!pair.Truth.IsKnown) return null;

        // The exact answer of an overlap is no depth, but it is not above 0.
        double truth = pair.Truth.Answer.Distance, rounding = Accuracy.Rounding * truth;
        bool holds = check.LowerBound <= truth + rounding
            && (pair.Truth.Answer.Overlap || check.UpperBound >= truth - rounding);
        return holds ? null : Say.Line($"{name}: the check says {check}, but it is {truth:R}");
    }

    private static string? Refuted(in CheckedAnswer check, string name) =>
        check.Status == CheckStatus.Refuted ? Say.Line($"{name}: {check}") : null;
}
