namespace Gjk.Core;

/// <summary>Makes results of what the solvers find: adds the margins, finds the points and rounds.</summary>
internal static class DistanceFinish
{
    /// <summary>Ratio of the distance to a shape's size and to its offset from its local origin: beyond it a point of
    /// the shape is placed from its own pose, because one that is reached over the distance from the other shape would
    /// lie beside it by rounding alone. At this ratio rounding is 2^-33 of the size: a few times the ratio would do no
    /// harm, and less would only cost time. Pinned by WitnessPointTests.</summary>
    public const double FarApart = 1 << 20;

    /// <summary>Ratio of the radii: where B is smaller than A by more, the points are placed from B's pose. Up to here,
    /// what rounding in A's frame does to them is far below B's floats; 2^20 is too much, as PointPlacementTests show,
    /// and less only costs time.</summary>
    public const double MuchSmaller = 1 << 10;

    /// <summary>Adds the margins, finds the points and rounds.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static void Write(
        in SolverState state, in PairFrame frame, in RigidPose poseA, in RigidPose poseB, double maxDistance,
        bool isSigned, out DistanceResult result)
    {
        if (state.Verdict is Verdict.Contradiction or Verdict.Beyond or Verdict.Enclosed)
        {
            WriteUnmeasured(state, frame, poseA, poseB, out result);
            return;
        }

        state.Simplex.WitnessPoints(state.Weights, out Xyz onA, out Xyz onB);
        double scale = 1 / Math.Sqrt(state.Feature.NormalSquared), distance = Proofs.DistanceOf(state, frame, scale);
        state.Feature.Normal.ToXyz().Times(scale, out Xyz toA);
        Xyz toAInB = default;
        if (frame.MarginB > 0) toAInB = frame.Inverse.Rotate(toA);
        bool isTouching = Proofs.IsTouching(state, distance);
        if (isTouching && !isSigned)
        {
            double core = frame.Margins > 0 ? state.Feature.Height * scale / frame.Margins : 0;
            onA.Plus(toA, -(core * frame.MarginA), out Xyz commonA);
            onB.Plus(toAInB, core * frame.MarginB, out Xyz commonB);
            Common(state, frame, poseA, poseB, commonA, commonB, out result);
            return;
        }

        bool isDeep = isSigned && distance < -GjkTolerances.TouchOf(state.IsCurved) * state.Size.Value;
        double gap = isDeep ? distance : isTouching ? 0 : Math.Max(distance, 0);
        distance = gap * frame.Unit;
        if ((float)distance > Math.Max(maxDistance, 0))
        {
            WriteBeyond(state, frame, out result);
            return;
        }

        onA.OnSurface(toA, -frame.MarginA, frame.CenterA, frame.Unit, out Xyz localA);
        onB.OnSurface(toAInB, frame.MarginB, frame.CenterB, frame.Unit, out Xyz localB);
        frame.RotationA.Opposite(toA, out Xyz normal);
        frame.RotationA.Transform(localA, poseA.Position, out Xyz worldA);
        worldA.Plus(normal, distance, out Xyz worldB);
        if (frame.IsPlaced) OutOfCores(frame, ref localA, ref localB);
        if (IsMuchSmallerB(state, frame) || IsFarApart(gap, frame.RadiusB, frame.CenterB))
        {
            worldB = ToWorld(poseB, localB.ToDouble3()).ToXyz();
            if (!IsFarApart(gap, frame.RadiusA, frame.CenterA)) worldB.Plus(normal, -distance, out worldA);
        }

        GjkStatus status = isTouching ? GjkStatus.Overlapping
            : state.Verdict == Verdict.Apart ? GjkStatus.Separated : GjkStatus.IterationLimit;
        float bound = BoundOf(state, frame, scale, isSigned && status != GjkStatus.Separated, isTouching);
        DistanceResult.Write(
            out result, status, (float)distance, bound, worldA, worldB, normal, localA, localB, state.Iterations);
    }

    /// <summary>The lower bound of the better of the plane and the feature. The plane is the feature's but for a walk
    /// in extended precision that ended on an older, better one.</summary>
    private static float BoundOf(in SolverState state, in PairFrame frame, double scale, bool isSigned, bool isTouching)
    {
        double planeScale = state.Plane.NormalSquared == state.Feature.NormalSquared
            ? scale
            : 1 / Math.Sqrt(state.Plane.NormalSquared);
        double gap = Math.Min(state.Plane.Value * planeScale, state.Feature.Height * scale);
        float bound = LowerBound(gap, state, frame, isSigned);

        // What counts as touching may be apart by less than that counts, and yet no bound is above the distance.
        return isTouching ? Math.Min(bound, 0) : bound;
    }

    /// <summary>Whether B's own pose places the points better than A's: where B is much smaller, and where the curve of
    /// a core or the end of the iterations keeps them apart by far more than rounding, where B is smaller at
    /// all.</summary>
    private static bool IsMuchSmallerB(in SolverState state, in PairFrame frame)
    {
        double ratio = state.IsCurved || state.Verdict == Verdict.Undecided ? 1 : MuchSmaller;
        return IsSmallerB(frame.RadiusA, frame.RadiusB, frame.CenterB, ratio);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool IsSmallerB(double radiusA, double radiusB, in Double3 centerB, double ratio) =>
        radiusB * ratio < radiusA && centerB.SumOfMagnitudes <= FarApart * radiusA;

    /// <summary>Whether a shape's own pose places its point better than the way from the other shape does.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool IsFarApart(double distance, double radius, in Double3 center) =>
        distance > FarApart * radius && distance > FarApart * center.SumOfMagnitudes;

    /// <summary>A common point, given on both cores, and placed from the pose that the two points of shapes apart would
    /// be.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void Common(
        in SolverState state, in PairFrame frame, in RigidPose poseA, in RigidPose poseB, in Xyz onA, in Xyz onB,
        out DistanceResult result)
    {
        Xyz localA = (onA + frame.CenterA.ToXyz()) * frame.Unit, localB = (onB + frame.CenterB.ToXyz()) * frame.Unit;
        Xyz outerA = localA, outerB = localB;
        if (frame.IsPlaced) OutOfCores(frame, ref outerA, ref outerB);
        var world = (Vector3)(IsMuchSmallerB(state, frame)
            ? ToWorld(poseB, outerB.ToDouble3())
            : frame.RotationA.Rotate(localA.ToDouble3()) + poseA.Position);
        outerA.Round(out Vector3 roundedA);
        outerB.Round(out Vector3 roundedB);
        result = new DistanceResult(
            GjkStatus.Overlapping, 0, 0, world, world, Vector3.Zero, roundedA, roundedB, state.Iterations);
    }

    /// <summary>What has no feature that a distance could be measured to.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void WriteUnmeasured(
        in SolverState state, in PairFrame frame, in RigidPose poseA, in RigidPose poseB, out DistanceResult result)
    {
        if (state.Verdict == Verdict.Beyond) WriteBeyond(state, frame, out result);
        else result = DistanceResult.Invalid(GjkStatus.InvalidShape, state.Iterations);
        if (state.Verdict != Verdict.Enclosed) return;
        state.Simplex.WitnessPoints(state.Weights, out Xyz onA, out Xyz onB);
        Common(state, frame, poseA, poseB, onA, onB, out result);
    }

    [MethodImpl(Jit.Step)]
    private static void OutOfCores(in PairFrame frame, ref Xyz localA, ref Xyz localB)
    {
        localA = frame.OutOfA(localA);
        localB = frame.OutOfB(localB);
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void WriteBeyond(in SolverState state, in PairFrame frame, out DistanceResult result)
    {
        double scale = 1 / Math.Sqrt(state.Plane.NormalSquared);
        Double3 normal = state.Plane.Normal * -scale;
        result = DistanceResult.Beyond(
            LowerBound(state.Plane.Value * scale, state, frame), (Vector3)frame.RotationA.Rotate(normal),
            state.Iterations);
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    public static Double3 ToWorld(in RigidPose pose, in Double3 local) =>
        new RotationD(pose.Rotation).Rotate(local) + pose.Position;

    /// <summary>The separating plane's gap less everything that rounding can have added to it, and then rounded
    /// down.</summary>
    private static float LowerBound(double coreGap, in SolverState state, in PairFrame frame, bool isSigned = false)
    {
        // The centres are no further apart than the gap and both sizes, so this is at least the size and the distance
        // of the centres.
        double reach = 2 * state.Size.Value + coreGap;
        double value = (coreGap - frame.Margins - GjkTolerances.LowerBoundError * reach) * frame.Unit;
        return value > 0 || isSigned ? RoundOff.Down(value) : 0;
    }
}
