namespace Gjk.Core;

/// <summary>A half-space and another shape, in closed form: the support of the other against the normal is its point
/// nearest to the plane, or deepest under it (van den Bergen, Collision Detection in Interactive 3D Environments, 2004,
/// section 3.2). The half-space is A; where it is B, answers are exchanged at the end, so both orders have the same
/// bits.</summary>
/// <remarks>The frame is that of the half-space's local origin, a point, and the other's core. What touches is measured
/// by the other's size, as the half-space has none.</remarks>
internal struct HalfSpacePair
{
    /// <summary>Ratio to the lengths that a gap is made of: 16 roundings, twice what the sums and products of a turned
    /// support point lose. Pinned by HalfSpaceTests.</summary>
    private const double Rounding = 16 * RoundOff.Unit;

    /// <summary>Ratio to the other's size: what rounding may leave open of a gap, half of the promised 1e-14 of the
    /// scale; where it is more, and more than <see cref="GapRatio"/>, the gap is found in 106 bits. Pinned by
    /// HalfSpaceTests.</summary>
    private const double SizeRatio = 64 * RoundOff.Unit;

    /// <summary>Ratio to the gap: what rounding may leave open of it, a hundredth of a float's rounding.</summary>
    private const double GapRatio = 1.0 / (1 << 30);

    /// <summary>From the half-space's local origin, without margin, to the other's core.</summary>
    public PairFrame Frame;

    /// <summary>Out of the half-space, of unit length, in its own axes.</summary>
    public Double3 Normal;

    /// <summary>How far the plane is from the local origin, along the normal.</summary>
    public double PlaneDistance;

    /// <summary>How far the shapes are apart: negative where they overlap, 0 where they touch. World units.</summary>
    public double Gap;

    /// <summary>Separated, Overlapping (touching included), or why there is no answer.</summary>
    public GjkStatus Status;

    /// <summary>Whether the half-space is B of the query.</summary>
    public bool IsSwapped;

    private Double3 _onOther;
    private double _least;

    /// <summary>Whether a shape is a half-space; known when the code is compiled for all types but one.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool IsHalfSpace<T>(ref T shape)
        where T : struct, ISupportMap =>
        typeof(T) == typeof(ConvexShape) && UnsafeRef.As<T, ConvexShape>(ref shape).Kind == ShapeKind.HalfSpace;

    /// <summary>Answers a pair of which one shape is a half-space.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static void Solve<TA, TB, TSolver, TResult>(
        ref TA a, in RigidPose poseA, ref TB b, in RigidPose poseB, ref TSolver solver, out TResult result)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
        where TSolver : struct, IPairSolver<TResult>
    {
        if (IsHalfSpace(ref a))
            Solve(UnsafeRef.As<TA, ConvexShape>(ref a), poseA, ref b, poseB, false, ref solver, out result);
        else
            Solve(UnsafeRef.As<TB, ConvexShape>(ref b), poseB, ref a, poseA, true, ref solver, out result);
    }

    private static void Solve<T, TSolver, TResult>(
        in ConvexShape halfSpace, in RigidPose pose, ref T other, in RigidPose otherPose, bool isSwapped,
        ref TSolver solver, out TResult result)
        where T : struct, ISupportMap
        where TSolver : struct, IPairSolver<TResult>
    {
        T core = CoreOf.IsPlaced(ref other) ? ShapeTraits<T>.Instance.InCoreAxes(other) : other;
        Measure(halfSpace, pose, ref other, ref core, otherPose, out HalfSpacePair pair);
        pair.IsSwapped = isSwapped;
        solver.SolveHalfSpace(ref pair, ref core, otherPose, out result);
    }

    /// <summary>Measures the pair.</summary>
    /// <param name="halfSpace">The half-space.</param>
    /// <param name="pose">Its pose in the world.</param>
    /// <param name="other">The other shape.</param>
    /// <param name="core">The same in the axes of its core.</param>
    /// <param name="otherPose">Its pose.</param>
    /// <param name="pair">Gets what was found.</param>
    public static void Measure<T>(
        in ConvexShape halfSpace, in RigidPose pose, ref T other, ref T core, in RigidPose otherPose,
        out HalfSpacePair pair)
        where T : struct, ISupportMap
    {
        pair = default;
        PointShape origin = default;
        Placement? placed = CoreOf.IsPlaced(ref other) ? ShapeTraits<T>.Instance.PlacementOf(ref other) : null;
        PairFrame.ComposePlaced(ref origin, pose, null, ref core, otherPose, placed, out pair.Frame);

        pair.Frame.TightenRadii(ref origin, ref other);
        HalfSpaceCore plane = halfSpace.AsHalfSpace;
        pair.Normal = plane.Unit;
        pair.PlaneDistance = plane.PlaneDistance;
        pair.Status = IsHalfSpace(ref other) ? GjkStatus.InvalidShape : GjkStatus.InvalidInput;
        if (IsHalfSpace(ref other) || !pair.Frame.IsValid) return;
        double gap = pair.GapIn(pair.Frame, ref core, out pair._onOther);
        double size = pair.Frame.RadiusB, reach = Math.Abs(pair.PlaneDistance) + size
            + pair.Frame.CenterB.SumOfMagnitudes + pair.Frame.Translation.SumOfMagnitudes;
        double error = Rounding * reach;
        if (error > SizeRatio * size && error > GapRatio * Math.Abs(gap))
        {
            gap = pair.ExactGap(plane, pose, ref other, otherPose);
            error = Rounding * (Math.Abs(gap) + size);
        }

        if (!(Math.Abs(gap) <= PairFrame.MaxMagnitude)) return;
        pair._least = gap - error;
        bool isTouching = Math.Abs(gap) <= GjkTolerances.Touch * size;
        pair.Gap = isTouching ? 0 : gap;
        pair.Status = pair.Gap <= 0 ? GjkStatus.Overlapping : GjkStatus.Separated;
    }

    /// <summary>How far the other is out of the half-space at any place, and its nearest point, from its
    /// centre.</summary>
    public readonly double GapIn<T>(in PairFrame frame, ref T core, out Double3 onOther)
        where T : struct, ISupportMap
    {
        core.Support(frame.Rotation.InverseRotate(-Normal), out onOther);
        return Double3.Dot(Normal, frame.Translation + frame.Rotation.Rotate(onOther)) - PlaneDistance - frame.MarginB;
    }

    /// <summary>The gap in 106 bits: far from the origin of the half-space double would lose it.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private readonly double ExactGap<T>(
        in HalfSpaceCore plane, in RigidPose pose, ref T other, in RigidPose otherPose)
        where T : struct, ISupportMap
    {
        Placement? placed = ShapeTraits<T>.Instance.PlacementOf(ref other);
        Double3 onOther = placed is null ? _onOther : Frame.OutOfB(_onOther.ToXyz()).ToDouble3();
        VectorDD local = (placed is null ? other.Center : placed.ExactCenter) + (VectorDD)onOther;
        VectorDD between = VectorDD.ToWorld(otherPose, local) - (Double3)pose.Position;
        return plane.Outside(pose.Rotation, between) / plane.Length - Frame.MarginB;
    }

    /// <summary>Out of the half-space, in the world.</summary>
    public readonly Double3 Outward => Frame.RotationA.Rotate(Normal);

    /// <summary>From A to B of the query, in the world.</summary>
    public readonly Vector3 FromAToB => IsSwapped ? Opposite.Of((Vector3)Outward) : (Vector3)Outward;

    /// <summary>The point of the other that is nearest or deepest, from the half-space's origin in its axes.</summary>
    public readonly Double3 OnOther =>
        Frame.Translation + Frame.Rotation.Rotate(_onOther) - Normal * Frame.MarginB;

    /// <summary>The same in the world.</summary>
    public readonly Double3 OnOtherInWorld(in RigidPose otherPose) =>
        DistanceFinish.ToWorld(otherPose, LocalOnOther.ToDouble3());

    /// <summary>The same in the other's frame.</summary>
    private readonly Xyz LocalOnOther
    {
        get
        {
            Double3 inOther = Frame.Rotation.InverseRotate(Normal);
            Xyz local = (Frame.CenterB + _onOther - inOther * Frame.MarginB).ToXyz();
            return Frame.IsPlaced ? Frame.OutOfB(local) : local;
        }
    }

    /// <summary>The point of the plane under it, from the half-space's origin in its axes.</summary>
    public readonly Double3 Foot => OnOther + Normal * (PlaneDistance - Double3.Dot(Normal, OnOther));

    /// <summary>When the shapes meet; the gap changes at a constant rate.</summary>
    /// <param name="motion">Of the other, seen from the half-space, for the fraction 1; in the world.</param>
    /// <param name="most">The largest fraction; NaN is no input.</param>
    /// <param name="fraction">When they meet; 0 where they do not, or at the start.</param>
    public readonly CastStatus Meet(in Double3 motion, double most, out double fraction)
    {
        fraction = 0;
        if (Status == GjkStatus.InvalidShape) return CastStatus.InvalidShape;
        if (Status == GjkStatus.InvalidInput || double.IsNaN(most)) return CastStatus.InvalidInput;
        if (Status == GjkStatus.Overlapping) return CastStatus.OverlappingAtStart;
        double rate = RateOf(motion);
        if (!(rate < 0) || CastSolver.IsBeyond(Gap / -rate, most)) return CastStatus.Miss;
        fraction = Gap / -rate;
        return CastStatus.Hit;
    }

    /// <summary>Whether a motion takes the shapes deeper into each other than is allowed: as
    /// <see cref="DeepeningSolver{TA, TB}"/> has it, and deepest at the end.</summary>
    /// <param name="motion">Of the other, seen from the half-space, for the fraction 1; in the world.</param>
    /// <param name="range">From where on, to where, and what is allowed.</param>
    public readonly MotionVerdict Deepens(in Double3 motion, in DeepeningRange range)
    {
        double rate = RateOf(motion), from = Gap + rate * range.From;
        double limit = GjkTolerances.Touch * Frame.RadiusB + Math.Max(range.Allowed, range.From > 0 ? 0 : -from);
        if (from < -limit) return MotionVerdict.Hit;
        rate += range.Slope * motion.Length;
        bool isDeep = rate < 0 && from + rate * (range.To - range.From) < -limit;
        return isDeep ? MotionVerdict.Hit : MotionVerdict.Miss;
    }

    /// <summary>How the gap changes; a motion along the plane but for rounding does not change it.</summary>
    private readonly double RateOf(in Double3 motion)
    {
        double rate = Double3.Dot(Outward, motion);
        return Math.Abs(rate) <= Rounding * motion.Length ? 0 : rate;
    }

    /// <summary>Where the contact is, with the half-space as A and its foot as A's centre.</summary>
    public readonly void Set(ref ContactPlane plane)
    {
        plane.Frame = Frame;
        plane.Frame.CenterA = Foot;
        plane.Frame.Translation -= plane.Frame.CenterA;
        plane.Set(Normal, Gap + Frame.MarginB, Frame.RadiusB);
    }

    /// <summary>The distance, or the signed distance, in the order of the query.</summary>
    public readonly DistanceResult Result(in RigidPose otherPose, bool isSigned, double maxDistance)
    {
        if (Status is GjkStatus.InvalidInput or GjkStatus.InvalidShape || double.IsNaN(maxDistance))
            return DistanceResult.Invalid(Status == GjkStatus.InvalidShape ? Status : GjkStatus.InvalidInput, 0);
        bool isTouching = Status == GjkStatus.Overlapping;
        float bound = isSigned || _least > 0 ? RoundOff.Down(_least) : 0;
        if (isTouching) bound = Math.Min(bound, 0);
        if (!isTouching && (float)Gap > Math.Max(maxDistance, 0))
            return DistanceResult.Beyond(bound, FromAToB, 1);
        Double3 onOther = OnOtherInWorld(otherPose), normal = Outward;
        bool isCommon = isTouching && !isSigned;
        double gap = isCommon ? 0 : Gap;
        if (isCommon) normal = default;
        var found = new DistanceResult(
            Status, (float)gap, bound, (Vector3)(onOther - normal * gap), (Vector3)onOther, (Vector3)normal,
            (Vector3)(isCommon ? OnOther : Foot), (Vector3)LocalOnOther.ToDouble3(), 1);
        return IsSwapped ? found.Swapped : found;
    }
}
