namespace Gjk.Core;

/// <remarks>Cores that are placed in the frames of their shapes: the frame is that of the cores.</remarks>
internal partial struct PairFrame
{
    /// <summary>The same for shapes of which one is placed: the frame of their cores, in the cores' axes.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static void ComposePlaced<TA, TB>(
        in TA a, in RigidPose poseA, in TB b, in RigidPose poseB, out PairFrame frame)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        TA coreA = ShapeTraits<TA>.Of.InCoreAxes(a, out Placement? placedA);
        TB coreB = ShapeTraits<TB>.Of.InCoreAxes(b, out Placement? placedB);
        Placement inA = placedA ?? Placement.None, inB = placedB ?? Placement.None;
        frame._turnA = inA.Turn;
        frame._turnB = inB.Turn;
        PoseComposition.Compose(
            poseA, inA.Turn, poseB, inB.Turn, out frame.RotationA, out frame.Rotation, out frame.Inverse,
            out frame._areRotations);
        frame.IsPlaced = true;
        frame.CenterA = placedA is null ? coreA.Center : inA.CenterInCore;
        frame.CenterB = placedB is null ? coreB.Center : inB.CenterInCore;
        frame.RadiusA = coreA.BoundingRadius;
        frame.RadiusB = coreB.BoundingRadius;
        frame.MarginA = coreA.Margin;
        frame.MarginB = coreB.Margin;
        frame.Unit = 1;
        frame.End = 0;
        double offset = frame.CenterA.SumOfMagnitudes + frame.CenterB.SumOfMagnitudes;
        if (!(offset > FarCenter * TightRadius<TA, TB>(frame.RadiusA, frame.RadiusB)))
        {
            frame.Translation = frame.RotationA.InverseRotate((Double3)poseB.Position - poseA.Position)
                + (frame.Rotation.Rotate(frame.CenterB) - frame.CenterA);
        }
        else
        {
            frame.Translation = frame.RotationA.InverseRotate(
                BetweenFarCenters(
                    poseA, poseB, placedA is null ? coreA.Center : inA.ExactCenter,
                    placedB is null ? coreB.Center : inB.ExactCenter));
        }

        frame.Magnitude =
            frame.RadiusA + frame.RadiusB + (frame.MarginA + frame.MarginB) + frame.Translation.SumOfMagnitudes;
    }

    /// <summary>The rotation of A's core in A's frame; null where neither core is placed.</summary>
    public readonly QuaternionD? TurnOfA => IsPlaced ? _turnA : null;

    /// <summary>The rotation of B's core in B's frame; null where neither core is placed.</summary>
    public readonly QuaternionD? TurnOfB => IsPlaced ? _turnB : null;

    /// <summary>A point or direction in the axes of A's core, in A's frame, if one of the cores is placed.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public readonly Xyz OutOfA(Xyz v) => _turnA.Rotate(v);

    /// <summary>The same for B's core.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public readonly Xyz OutOfB(Xyz v) => _turnB.Rotate(v);
}
