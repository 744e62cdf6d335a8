namespace Gjk.Exact.Certificates;

/// <summary>Holds a result to the library's own <see cref="AnswerCheck"/>, which needs no solver, and to what it leaves
/// to the query: an answer at all, and a bound that is near the distance. Works for any support map.</summary>
public static class Certificate
{
    /// <summary>Room for a least float where products vanish.</summary>
    private const double Denormal = 1e-44;

    /// <summary>What is wrong with the result, or null.</summary>
    /// <param name="a">The first shape.</param>
    /// <param name="poseA">Pose of A in the world.</param>
    /// <param name="b">The second shape.</param>
    /// <param name="poseB">Pose of B in the world.</param>
    /// <param name="r">What the query said.</param>
    /// <param name="scale">Of the pair, contract 6.</param>
    /// <param name="curved">Whether the pair is held to the curved shapes' accuracy.</param>
    public static string? Problem<TA, TB>(
        in TA a, in RigidPose poseA, in TB b, in RigidPose poseB, in DistanceResult r, double scale,
        bool curved = false)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap =>
        Problem(AnswerCheck.Distance(a, poseA, b, poseB, r), r, scale, curved);

    /// <summary>What is wrong with a signed distance, or null. Of an overlap it proves that the way out is one, that it
    /// is as long as the result says and that it ends at the points; not that no other is shorter.</summary>
    /// <inheritdoc cref="Problem{TA, TB}"/>
    public static string? ProblemOfSigned<TA, TB>(
        in TA a, in RigidPose poseA, in TB b, in RigidPose poseB, in DistanceResult r, double scale,
        bool curved = false)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap =>
        Problem(AnswerCheck.SignedDistance(a, poseA, b, poseB, r), r, scale, curved);

    /// <summary>How far apart the planes across a unit direction stand that touch A and B; negative where the shapes
    /// reach past each other.</summary>
    public static double Gap<TA, TB>(Body<TA> a, Body<TB> b, in Double3 n)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        Double3 centers = new ExactProblem([b.Center], 0, b.Pose, [a.Center], 0, a.Pose).FirstVertex();
        return Double3.Dot(n, centers) - a.HeightOverCenter(n) - b.HeightOverCenter(-n);
    }

    private static string? Problem(in CheckedAnswer check, in DistanceResult r, double scale, bool curved)
    {
        if (r.Status is not (GjkStatus.Separated or GjkStatus.Overlapping))
            return $"status is {r.Status} after {r.Iterations} iterations";
        if (check.Status == CheckStatus.Refuted) return $"the check says {check} of {r}";

        // Contract 6: where there is no scale (two points), errors are relative to the distance.
        double d = r.Distance, size = Math.Abs(d), unit = scale == 0 ? size : scale;
        double band = curved ? Accuracy.CurvedBand(size, unit) : Accuracy.Band(size, unit);
        return r.LowerBound <= d && r.LowerBound >= d - band - Denormal - Accuracy.DistanceScale * unit
            ? null
            : $"the lower bound is {r.LowerBound:R}, the distance {r.Distance:R}";
    }
}
