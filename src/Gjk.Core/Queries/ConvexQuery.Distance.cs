using System;
using System.Numerics;
using System.Runtime.CompilerServices;

namespace Gjk.Core;

public static partial class ConvexQuery
{
    /// <summary>The distance between two convex shapes, with the closest points, or that they overlap.</summary>
    /// <typeparam name="TA">The first shape's type.</typeparam>
    /// <typeparam name="TB">The second shape's type.</typeparam>
    /// <param name="a">The first shape.</param>
    /// <param name="poseA">Where it is.</param>
    /// <param name="b">The second shape.</param>
    /// <param name="poseB">Where it is.</param>
    /// <returns>
    /// The true distance of the shapes as given, rounded to float; see <see cref="DistanceResult"/>. A <c>default</c> pose or shape, or a NaN, gives
    /// <see cref="GjkStatus.InvalidInput"/>.
    /// </returns>
    public static DistanceResult Distance<TA, TB>(in TA a, in RigidPose poseA, in TB b, in RigidPose poseB)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap =>
        Distance(a, poseA, b, poseB, float.PositiveInfinity);

    /// <summary>As the other, but ends early, with <see cref="GjkStatus.BeyondMaxDistance"/>, when the shapes are further apart than the caller cares to know.</summary>
    /// <typeparam name="TA">The first shape's type.</typeparam>
    /// <typeparam name="TB">The second shape's type.</typeparam>
    /// <param name="a">The first shape.</param>
    /// <param name="poseA">Where it is.</param>
    /// <param name="b">The second shape.</param>
    /// <param name="poseB">Where it is.</param>
    /// <param name="maxDistance">In world units; below 0 counts as 0; NaN gives <see cref="GjkStatus.InvalidInput"/>.</param>
    /// <returns>See <see cref="DistanceResult"/>.</returns>
    public static DistanceResult Distance<TA, TB>(in TA a, in RigidPose poseA, in TB b, in RigidPose poseB, float maxDistance)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        TA copyA = default;
        TB copyB = default;
        NoTrace trace = default;
        return DistanceOf(ref Inward(a, ref copyA), poseA, ref Inward(b, ref copyB), poseB, maxDistance, ref trace);
    }

    /// <summary>As the first, with the simplex that the answer came from.</summary>
    /// <typeparam name="TA">The first shape's type.</typeparam>
    /// <typeparam name="TB">The second shape's type.</typeparam>
    /// <param name="a">The first shape.</param>
    /// <param name="poseA">Where it is.</param>
    /// <param name="b">The second shape.</param>
    /// <param name="poseB">Where it is.</param>
    /// <param name="simplex">The support points of the nearest feature with their weights; empty when the input is invalid.</param>
    /// <returns>See <see cref="DistanceResult"/>.</returns>
    public static DistanceResult Distance<TA, TB>(in TA a, in RigidPose poseA, in TB b, in RigidPose poseB, out FinalSimplex simplex)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        TA copyA = default;
        TB copyB = default;
        ref TA shapeA = ref Inward(a, ref copyA);
        ref TB shapeB = ref Inward(b, ref copyB);
        simplex = default;
        RelativePose.Compose(poseA, poseB, shapeA.Center, shapeB.Center, shapeA.BoundingRadius + shapeB.BoundingRadius, out RelativePose bInA);
        if (!bInA.IsValid || !AreMargins(shapeA.Margin, shapeB.Margin)) return DistanceResult.Invalid(GjkStatus.InvalidInput, 0);

        GjkOutcome.Start(out GjkOutcome outcome);
        NoTrace trace = default;
        if (ArePoints(bInA, shapeA.Margin + shapeB.Margin))
            GjkDistance.SolvePoints(bInA, ref outcome);
        else
            SolveCores(ref shapeA, ref shapeB, bInA, double.PositiveInfinity, ref outcome, ref trace);
        if (outcome.Status < GjkStatus.InvalidInput) simplex = new FinalSimplex(outcome.Simplex, bInA);
        return Finish(outcome, bInA, poseA, shapeA.Margin, shapeB.Margin, float.PositiveInfinity);
    }

    /// <summary>As the others, beginning where the last query of the pair ended: much faster for pairs that move little.</summary>
    /// <typeparam name="TA">The first shape's type.</typeparam>
    /// <typeparam name="TB">The second shape's type.</typeparam>
    /// <param name="a">The first shape.</param>
    /// <param name="poseA">Where it is.</param>
    /// <param name="b">The second shape.</param>
    /// <param name="poseB">Where it is.</param>
    /// <param name="warmStart">Kept by the caller, one per pair, in the same order of A and B; updated.</param>
    /// <param name="maxDistance">As in the other overload.</param>
    /// <returns>See <see cref="DistanceResult"/>. It agrees with the cold query's within the accuracy, not always to the last bit.</returns>
    public static DistanceResult Distance<TA, TB>(
        in TA a, in RigidPose poseA, in TB b, in RigidPose poseB, ref WarmStart warmStart, float maxDistance = float.PositiveInfinity)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        TA copyA = default;
        TB copyB = default;
        return DistanceOf(ref Inward(a, ref copyA), poseA, ref Inward(b, ref copyB), poseB, maxDistance, ref warmStart);
    }

    /// <summary>The cold query. Two plain meshes in the clothes of <see cref="ConvexShape"/> are solved as meshes, without a look at the kind in each support.</summary>
    private static DistanceResult DistanceOf<TA, TB, TTrace>(
        ref TA a, in RigidPose poseA, ref TB b, in RigidPose poseB, float maxDistance, ref TTrace trace)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
        where TTrace : struct, IGjkTrace
    {
        if (AreMeshes(ref a, ref b, out ConvexMesh meshA, out ConvexMesh meshB))
            return DistanceOf(ref meshA, poseA, ref meshB, poseB, maxDistance, ref trace);
        if (AreBoxes(ref a, ref b, out BoxCore boxA, out BoxCore boxB))
            return DistanceOf(ref boxA, poseA, ref boxB, poseB, maxDistance, ref trace);

        RelativePose.Compose(poseA, poseB, a.Center, b.Center, a.BoundingRadius + b.BoundingRadius, out RelativePose bInA);
        double marginA = a.Margin, marginB = b.Margin;
        if (!bInA.IsValid || !AreMargins(marginA, marginB) || float.IsNaN(maxDistance)) return DistanceResult.Invalid(GjkStatus.InvalidInput, 0);

        GjkOutcome.Start(out GjkOutcome outcome);
        if (ArePoints(bInA, marginA + marginB))
        {
            GjkDistance.SolvePoints(bInA, ref outcome);
            if (trace.IsOn) TellPoints(bInA, outcome, ref trace);
        }
        else
        {
            SolveCores(ref a, ref b, bInA, CoreReach(maxDistance, marginA + marginB, bInA), ref outcome, ref trace);
        }

        return Finish(outcome, bInA, poseA, marginA, marginB, maxDistance);
    }

    /// <summary>The warm query.</summary>
    private static DistanceResult DistanceOf<TA, TB>(
        ref TA a, in RigidPose poseA, ref TB b, in RigidPose poseB, float maxDistance, ref WarmStart warmStart)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        if (AreMeshes(ref a, ref b, out ConvexMesh meshA, out ConvexMesh meshB))
            return DistanceOf(ref meshA, poseA, ref meshB, poseB, maxDistance, ref warmStart);
        if (AreBoxes(ref a, ref b, out BoxCore boxA, out BoxCore boxB))
            return DistanceOf(ref boxA, poseA, ref boxB, poseB, maxDistance, ref warmStart);

        RelativePose.Compose(poseA, poseB, a.Center, b.Center, a.BoundingRadius + b.BoundingRadius, out RelativePose bInA);
        double marginA = a.Margin, marginB = b.Margin;
        if (!bInA.IsValid || !AreMargins(marginA, marginB) || float.IsNaN(maxDistance)) return DistanceResult.Invalid(GjkStatus.InvalidInput, 0);

        GjkOutcome.Start(out GjkOutcome outcome);
        if (ArePoints(bInA, marginA + marginB))
            GjkDistance.SolvePoints(bInA, ref outcome);
        else
            SolveCoresWarm(ref a, ref b, bInA, CoreReach(maxDistance, marginA + marginB, bInA), ref warmStart, ref outcome);
        return Finish(outcome, bInA, poseA, marginA, marginB, maxDistance);
    }

    /// <summary>Nothing is left of either shape without its margin: points and spheres.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static bool ArePoints(in RelativePose bInA, double margins) => bInA.Radius == margins;

    /// <summary>How far apart the cores may be before the query may end early; the band keeps its answer that of the full query.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static double CoreReach(float maxDistance, double margins, in RelativePose bInA) =>
        Math.Max(maxDistance, 0.0) + margins + GjkTolerances.SeparatedBand * bInA.Radius;

    /// <summary>Adds the margins, finds the points and rounds.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static DistanceResult Finish(
        in GjkOutcome outcome, in RelativePose bInA, in RigidPose poseA, double marginA, double marginB, double maxDistance)
    {
        if (outcome.Status >= GjkStatus.InvalidInput) return DistanceResult.Invalid(outcome.Status, outcome.Iterations);
        if (outcome.Status == GjkStatus.BeyondMaxDistance) return Beyond(outcome, bInA, marginA + marginB);
        if (outcome.Status == GjkStatus.Overlapping)
            return Common(outcome, bInA, poseA, outcome.Simplex.PointOnA(ClosestPointWeights.Of(outcome.Simplex)));

        Vector3D onA = outcome.Simplex.PointOnA(ClosestPointWeights.OfFeature(outcome.Simplex, outcome.Feature));
        double scale = 1 / Math.Sqrt(outcome.Feature.NormalSquared);
        Vector3D toA = outcome.Feature.Normal * scale;
        double core = outcome.Feature.Height * scale, distance = core - marginA - marginB;
        if (distance <= GjkTolerances.Touch * bInA.Radius && outcome.Status == GjkStatus.Separated)
        {
            double shared = marginA + marginB > 0 ? core * (marginA / (marginA + marginB)) : 0;
            return Common(outcome, bInA, poseA, onA - toA * shared);
        }

        if (distance > maxDistance) return Beyond(outcome, bInA, marginA + marginB);

        // The plane is the feature's but for a walk in extended precision that ended on an older, better one.
        double planeScale = outcome.PlaneNormalSquared == outcome.Feature.NormalSquared ? scale : 1 / Math.Sqrt(outcome.PlaneNormalSquared);
        distance = Math.Max(distance, 0);
        Vector3D pointA = onA - toA * marginA, pointB = pointA - toA * distance;
        Vector3D normal = -bInA.RotationA.Rotate(toA);
        Vector3D localA = pointA + bInA.CenterA, worldA = bInA.RotationA.Rotate(localA) + poseA.Position;
        return new DistanceResult(
            outcome.Status, (float)distance, LowerBound(outcome.PlaneValue * planeScale, bInA, marginA + marginB), (Vector3)worldA,
            (Vector3)(worldA + normal * distance), (Vector3)normal, (Vector3)localA, (Vector3)LocalB(bInA, pointB), outcome.Iterations);
    }

    private static DistanceResult Common(in GjkOutcome outcome, in RelativePose bInA, in RigidPose poseA, in Vector3D point)
    {
        Vector3D local = point + bInA.CenterA;
        var world = (Vector3)(bInA.RotationA.Rotate(local) + poseA.Position);
        return new DistanceResult(
            GjkStatus.Overlapping, 0, 0, world, world, Vector3.Zero, (Vector3)local, (Vector3)LocalB(bInA, point), outcome.Iterations);
    }

    private static DistanceResult Beyond(in GjkOutcome outcome, in RelativePose bInA, double margins)
    {
        double scale = 1 / Math.Sqrt(outcome.PlaneNormalSquared);
        Vector3D normal = outcome.PlaneNormal * -scale;
        return DistanceResult.Beyond(
            LowerBound(outcome.PlaneValue * scale, bInA, margins), (Vector3)bInA.RotationA.Rotate(normal), outcome.Iterations);
    }

    private static Vector3D LocalB(in RelativePose bInA, in Vector3D point) =>
        bInA.Rotation.InverseRotate(point - bInA.Translation) + bInA.CenterB;

    /// <summary>The separating plane's gap less everything that rounding can have added to it, and then rounded down.</summary>
    private static float LowerBound(double coreGap, in RelativePose bInA, double margins)
    {
        // The centres are no further apart than the gap and both radii, so this is at least radius + distance of the centres.
        double reach = 2 * bInA.Radius + coreGap;
        double value = coreGap - margins - GjkTolerances.LowerBoundError * reach;
        return value > 0 ? RoundDown(value) : 0;
    }
}
