using System;
using System.Numerics;

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
        ref TA shapeA = ref Inward(a, ref copyA);
        ref TB shapeB = ref Inward(b, ref copyB);
        var bInA = new RelativePose(poseA, poseB, shapeA.Center, shapeB.Center, shapeA.BoundingRadius + shapeB.BoundingRadius);
        if (!bInA.IsValid(poseA, poseB) || float.IsNaN(maxDistance)) return DistanceResult.Invalid(GjkStatus.InvalidInput, 0);

        double marginA = shapeA.Margin, marginB = shapeB.Margin;
        double maxCoreDistance = Math.Max(maxDistance, 0.0) + marginA + marginB + GjkTolerances.SeparatedBand * bInA.Radius;
        GjkOutcome outcome = default;
        SolveCores(ref shapeA, ref shapeB, bInA, maxCoreDistance, ref outcome);
        return Finish(outcome, bInA, poseA, marginA, marginB, maxDistance);
    }

    /// <summary>Adds the margins, finds the points and rounds.</summary>
    private static DistanceResult Finish(
        in GjkOutcome outcome, in RelativePose bInA, in RigidPose poseA, double marginA, double marginB, double maxDistance)
    {
        if (outcome.Status >= GjkStatus.InvalidInput) return DistanceResult.Invalid(outcome.Status, outcome.Iterations);

        float bound = LowerBound(outcome, bInA, marginA + marginB);
        if (outcome.Status == GjkStatus.BeyondMaxDistance) return Beyond(outcome, bInA, bound);

        Vector3D onA = Witness(outcome.Simplex);
        if (outcome.Status == GjkStatus.Overlapping) return Common(outcome, bInA, poseA, onA);

        double scale = 1 / Math.Sqrt(outcome.Feature.NormalSquared);
        Vector3D toA = outcome.Feature.Normal * scale;
        double core = outcome.Feature.Height * scale, distance = core - marginA - marginB;
        if (distance <= GjkTolerances.Touch * bInA.Radius && outcome.Status == GjkStatus.Separated)
        {
            double shared = marginA + marginB > 0 ? core * (marginA / (marginA + marginB)) : 0;
            return Common(outcome, bInA, poseA, onA - toA * shared);
        }

        if (distance > maxDistance) return Beyond(outcome, bInA, bound);

        distance = Math.Max(distance, 0);
        Vector3D pointA = onA - toA * marginA, pointB = pointA - toA * distance;
        Vector3D normal = -bInA.RotationA.Rotate(toA);
        Vector3D localA = pointA + bInA.CenterA, worldA = bInA.RotationA.Rotate(localA) + poseA.Position;
        return new DistanceResult(
            outcome.Status, (float)distance, bound, (Vector3)worldA, (Vector3)(worldA + normal * distance), (Vector3)normal,
            (Vector3)localA, (Vector3)LocalB(bInA, pointB), outcome.Iterations);
    }

    /// <summary>The simplex's nearest point, carried over to A.</summary>
    private static Vector3D Witness(in Simplex s)
    {
        Weights w = s.Count switch
        {
            1 => new Weights(1, 0, 0, 0),
            2 => ClosestPointWeights.Segment(s.A.W, s.B.W),
            3 => ClosestPointWeights.Triangle(s.A.W, s.B.W, s.C.W),
            _ => ClosestPointWeights.Tetrahedron(s.A.W, s.B.W, s.C.W, s.D.W),
        };
        Vector3D point = s.OnA(s.A.Slot) * w.A;
        if (s.Count > 1) point += s.OnA(s.B.Slot) * w.B;
        if (s.Count > 2) point += s.OnA(s.C.Slot) * w.C;
        if (s.Count > 3) point += s.OnA(s.D.Slot) * w.D;
        return point;
    }

    private static DistanceResult Common(in GjkOutcome outcome, in RelativePose bInA, in RigidPose poseA, in Vector3D point)
    {
        Vector3D local = point + bInA.CenterA;
        var world = (Vector3)(bInA.RotationA.Rotate(local) + poseA.Position);
        return new DistanceResult(
            GjkStatus.Overlapping, 0, 0, world, world, Vector3.Zero, (Vector3)local, (Vector3)LocalB(bInA, point), outcome.Iterations);
    }

    private static DistanceResult Beyond(in GjkOutcome outcome, in RelativePose bInA, float bound)
    {
        Vector3D normal = outcome.PlaneNormal * (-1 / Math.Sqrt(outcome.PlaneNormalSquared));
        return DistanceResult.Beyond(bound, (Vector3)bInA.RotationA.Rotate(normal), outcome.Iterations);
    }

    private static Vector3D LocalB(in RelativePose bInA, in Vector3D point) =>
        bInA.Rotation.InverseRotate(point - bInA.Translation) + bInA.CenterB;

    /// <summary>The separating plane's gap less everything that rounding can have added to it, and then rounded down.</summary>
    private static float LowerBound(in GjkOutcome outcome, in RelativePose bInA, double margins)
    {
        double reach = bInA.Radius + bInA.Translation.Length;
        double value = outcome.PlaneValue / Math.Sqrt(outcome.PlaneNormalSquared) - margins - GjkTolerances.LowerBoundError * reach;
        return value > 0 ? RoundDown(value) : 0;
    }
}
