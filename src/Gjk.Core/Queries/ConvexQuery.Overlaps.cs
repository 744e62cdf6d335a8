namespace Gjk.Core;

public static partial class ConvexQuery
{
    /// <summary>Whether two convex shapes share a point, touching included: exactly when <c>Distance(a, b)</c> says <see cref="GjkStatus.Overlapping"/>.</summary>
    /// <typeparam name="TA">The first shape's type.</typeparam>
    /// <typeparam name="TB">The second shape's type.</typeparam>
    /// <param name="a">The first shape.</param>
    /// <param name="poseA">Where it is.</param>
    /// <param name="b">The second shape.</param>
    /// <param name="poseB">Where it is.</param>
    /// <returns>False too when the input is invalid; the other overload tells.</returns>
    public static bool Overlaps<TA, TB>(in TA a, in RigidPose poseA, in TB b, in RigidPose poseB)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap =>
        Overlaps(a, poseA, b, poseB, out _);

    /// <summary>As the other, with the status: Separated, Overlapping, or why there is no answer.</summary>
    /// <typeparam name="TA">The first shape's type.</typeparam>
    /// <typeparam name="TB">The second shape's type.</typeparam>
    /// <param name="a">The first shape.</param>
    /// <param name="poseA">Where it is.</param>
    /// <param name="b">The second shape.</param>
    /// <param name="poseB">Where it is.</param>
    /// <param name="status">Separated or Overlapping; otherwise why the return value is false.</param>
    /// <returns>True when the shapes share a point.</returns>
    public static bool Overlaps<TA, TB>(in TA a, in RigidPose poseA, in TB b, in RigidPose poseB, out GjkStatus status)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        TA copyA = default;
        TB copyB = default;
        return OverlapsOf(ref Inward(a, ref copyA), poseA, ref Inward(b, ref copyB), poseB, out status);
    }

    private static bool OverlapsOf<TA, TB>(ref TA a, in RigidPose poseA, ref TB b, in RigidPose poseB, out GjkStatus status)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        if (AreMeshes(ref a, ref b, out ConvexMesh meshA, out ConvexMesh meshB))
            return OverlapsOf(ref meshA, poseA, ref meshB, poseB, out status);
        if (AreBoxes(ref a, ref b, out BoxCore boxA, out BoxCore boxB))
            return OverlapsOf(ref boxA, poseA, ref boxB, poseB, out status);

        RelativePose.Compose(poseA, poseB, a.Center, b.Center, a.BoundingRadius + b.BoundingRadius, out RelativePose bInA);
        if (!bInA.IsValid || !AreMargins(a.Margin, b.Margin))
        {
            status = GjkStatus.InvalidInput;
            return false;
        }

        // The balls around the shapes are apart by more than rounding could close, and so are the shapes.
        if (bInA.Translation.LengthSquared > Square(bInA.Radius * (1 + GjkTolerances.SeparatedBand)))
        {
            status = GjkStatus.Separated;
            return false;
        }

        double margins = a.Margin + b.Margin;
        if (margins == 0)
        {
            GjkOverlap.Answer answer = GjkOverlap.Solve(ref a, ref b, bInA, FirstNormal(bInA));
            if (answer != GjkOverlap.Answer.Unknown)
            {
                status = answer == GjkOverlap.Answer.Overlapping ? GjkStatus.Overlapping : GjkStatus.Separated;
                return answer == GjkOverlap.Answer.Overlapping;
            }
        }

        GjkOutcome.Start(out GjkOutcome outcome);
        NoTrace trace = default;
        SolveCores(ref a, ref b, bInA, margins + GjkTolerances.SeparatedBand * bInA.Radius, ref outcome, ref trace);
        status = OverlapStatus(outcome, margins + GjkTolerances.Touch * bInA.Radius);
        return status == GjkStatus.Overlapping;
    }

    private static double Square(double x) => x * x;

    /// <summary>The distance solver's outcome, reduced to the boolean question.</summary>
    private static GjkStatus OverlapStatus(in GjkOutcome outcome, double reach)
    {
        if (outcome.Status == GjkStatus.BeyondMaxDistance) return GjkStatus.Separated;
        if (outcome.Status != GjkStatus.Separated) return outcome.Status;
        return outcome.Feature.Height <= reach * System.Math.Sqrt(outcome.Feature.NormalSquared) ? GjkStatus.Overlapping : GjkStatus.Separated;
    }
}
