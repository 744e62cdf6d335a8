using System;
using System.Numerics;
using System.Runtime.CompilerServices;

namespace Gjk.Core;

public static partial class ConvexQuery
{
    /// <summary>
    /// Ratio of the distance to a shape's size and to its offset from its local origin: further apart, a point of it
    /// that is reached from the other shape over the distance would lie beside it by rounding alone, so it is placed
    /// from its own pose. Here rounding is 2^-33 of the size, so a few times as much would do no harm, and less would
    /// only cost time. WitnessPointTests have all distances.
    /// </summary>
    internal const double FarApart = 1 << 20;

    /// <summary>
    /// Ratio of the radii: where B is smaller than A by more, the points are placed from B's pose. Up to here, what
    /// rounding in A's frame does to them is far below B's floats; 2^20 is too much, as PointPlacementTests show, and
    /// less only costs time.
    /// </summary>
    internal const double MuchSmaller = 1 << 10;

    /// <summary>Adds the margins, finds the points and rounds.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static DistanceResult Finish(
        in SolverState state, in PairFrame frame, in RigidPose poseA, in RigidPose poseB, double maxDistance,
        bool isSigned = false)
    {
        if (state.Verdict == Verdict.Contradiction)
            return DistanceResult.Invalid(GjkStatus.InvalidShape, state.Iterations);
        if (state.Verdict == Verdict.Beyond) return Beyond(state, frame);
        if (state.Verdict == Verdict.Enclosed)
        {
            return Common(
                state, frame, poseA, poseB, state.Simplex.PointOnA(state.Weights),
                state.Simplex.PointOnB(state.Weights));
        }

        Xyz onA = state.Simplex.PointOnA(state.Weights), onB = state.Simplex.PointOnB(state.Weights);
        double scale = 1 / Math.Sqrt(state.Feature.NormalSquared), distance = Proofs.DistanceOf(state, frame, scale);
        Xyz toA = state.Feature.Normal.ToXyz() * scale;
        Xyz toAInB = frame.MarginB > 0 ? frame.Inverse.Rotate(toA) : default;
        bool isTouching = Proofs.IsTouching(state, distance);
        if (isTouching && !isSigned)
        {
            double core = frame.Margins > 0 ? state.Feature.Height * scale / frame.Margins : 0;
            return Common(
                state, frame, poseA, poseB, onA - toA * (core * frame.MarginA), onB + toAInB * (core * frame.MarginB));
        }

        bool isDeep = isSigned && distance < -GjkTolerances.TouchOf(state.IsCurved) * state.Size.Value;
        double gap = isDeep ? distance : isTouching ? 0 : Math.Max(distance, 0);
        distance = gap * frame.Unit;
        if ((float)distance > Math.Max(maxDistance, 0)) return Beyond(state, frame);

        Xyz localA = (onA - toA * frame.MarginA + frame.CenterA.ToXyz()) * frame.Unit;
        Xyz localB = (onB + toAInB * frame.MarginB + frame.CenterB.ToXyz()) * frame.Unit;
        Xyz normal = -frame.RotationA.Rotate(toA);
        Xyz worldA = frame.RotationA.Rotate(localA) + ((Double3)poseA.Position).ToXyz();
        Xyz worldB = worldA + normal * distance;
        if (frame.IsPlaced)
        {
            localA = frame.OutOfA(localA);
            localB = frame.OutOfB(localB);
        }

        if (IsMuchSmallerB(state, frame) || IsFarApart(gap, frame.RadiusB, frame.CenterB))
        {
            worldB = ToWorld(poseB, localB.ToVector3D()).ToXyz();
            if (!IsFarApart(gap, frame.RadiusA, frame.CenterA)) worldA = worldB - normal * distance;
        }

        // The plane is the feature's but for a walk in extended precision that ended on an older, better one.
        double planeScale = state.Plane.NormalSquared == state.Feature.NormalSquared
            ? scale
            : 1 / Math.Sqrt(state.Plane.NormalSquared);
        double coreGap = Math.Min(state.Plane.Value * planeScale, state.Feature.Height * scale);
        GjkStatus status = isTouching ? GjkStatus.Overlapping
            : state.Verdict == Verdict.Apart ? GjkStatus.Separated : GjkStatus.IterationLimit;
        float bound = LowerBound(coreGap, state, frame, isSigned && status != GjkStatus.Separated);

        // What counts as touching may be apart by less than that counts, and yet no bound is above the distance.
        if (isTouching) bound = Math.Min(bound, 0);
        return new DistanceResult(
            status, (float)distance, bound, worldA.ToSingle(), worldB.ToSingle(), normal.ToSingle(),
            localA.ToSingle(), localB.ToSingle(), state.Iterations);
    }

    /// <summary>
    /// Whether B's own pose places the points better than A's: where B is much smaller, and where the curve of a core
    /// or the end of the iterations keeps them apart by far more than rounding, where B is smaller at all.
    /// </summary>
    private static bool IsMuchSmallerB(in SolverState state, in PairFrame frame)
    {
        double ratio = state.IsCurved || state.Verdict == Verdict.Undecided ? 1 : MuchSmaller;
        return IsSmallerB(frame.RadiusA, frame.RadiusB, frame.CenterB, ratio);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static bool IsSmallerB(double radiusA, double radiusB, in Double3 centerB, double ratio) =>
        radiusB * ratio < radiusA && centerB.SumOfMagnitudes <= FarApart * radiusA;

    /// <summary>Whether a shape's own pose places its point better than the way from the other shape does.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static bool IsFarApart(double distance, double radius, in Double3 center) =>
        distance > FarApart * radius && distance > FarApart * center.SumOfMagnitudes;

    /// <summary>
    /// A common point, given on both cores, and placed from the pose that the two points of shapes apart would be.
    /// </summary>
    private static DistanceResult Common(
        in SolverState state, in PairFrame frame, in RigidPose poseA, in RigidPose poseB, Xyz onA, Xyz onB)
    {
        Xyz localA = (onA + frame.CenterA.ToXyz()) * frame.Unit, localB = (onB + frame.CenterB.ToXyz()) * frame.Unit;
        Xyz outerA = localA, outerB = localB;
        if (frame.IsPlaced) (outerA, outerB) = (frame.OutOfA(localA), frame.OutOfB(localB));
        var world = (Vector3)(IsMuchSmallerB(state, frame)
            ? ToWorld(poseB, outerB.ToVector3D())
            : frame.RotationA.Rotate(localA.ToVector3D()) + poseA.Position);
        return new DistanceResult(
            GjkStatus.Overlapping, 0, 0, world, world, Vector3.Zero, outerA.ToSingle(), outerB.ToSingle(),
            state.Iterations);
    }

    private static DistanceResult Beyond(in SolverState state, in PairFrame frame)
    {
        double scale = 1 / Math.Sqrt(state.Plane.NormalSquared);
        Double3 normal = state.Plane.Normal * -scale;
        return DistanceResult.Beyond(
            LowerBound(state.Plane.Value * scale, state, frame), (Vector3)frame.RotationA.Rotate(normal),
            state.Iterations);
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private static Double3 ToWorld(in RigidPose pose, in Double3 local) =>
        new RotationD(pose.Rotation).Rotate(local) + pose.Position;

    /// <summary>
    /// The separating plane's gap less everything that rounding can have added to it, and then rounded down.
    /// </summary>
    private static float LowerBound(
        double coreGap, in SolverState state, in PairFrame frame, bool isSigned = false)
    {
        // The centres are no further apart than the gap and both sizes, so this is at least the size and the distance
        // of the centres.
        double reach = 2 * state.Size.Value + coreGap;
        double value = (coreGap - frame.Margins - GjkTolerances.LowerBoundError * reach) * frame.Unit;
        return value > 0 || isSigned ? RoundOff.Down(value) : 0;
    }
}
