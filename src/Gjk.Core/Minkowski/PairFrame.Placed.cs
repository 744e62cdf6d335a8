using System.Runtime.CompilerServices;

namespace Gjk.Core;

/// <remarks>Cores that are placed in the frames of their shapes: the frame is that of the cores.</remarks>
internal partial struct PairFrame
{
    /// <summary>The same for cores that have their own axes and centres in the frames of the shapes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Compose<TA, TB>(
        ref TA a, in RigidPose poseA, ref TB b, in RigidPose poseB, in PairPlacement placement, out PairFrame frame)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        if (placement.IsNone) Compose(ref a, poseA, ref b, poseB, out frame);
        else ComposePlaced(ref a, poseA, ref b, poseB, placement, out frame);
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void ComposePlaced<TA, TB>(
        ref TA a, in RigidPose poseA, ref TB b, in RigidPose poseB, in PairPlacement placement, out PairFrame frame)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        Placement inA = placement.A ?? Placement.None, inB = placement.B ?? Placement.None;
        frame._turnA = inA.Turn;
        frame._turnB = inB.Turn;
        PoseComposition.Compose(
            poseA, inA.Turn, poseB, inB.Turn, out frame.RotationA, out frame.Rotation, out frame.Inverse,
            out frame._areRotations);
        frame.IsPlaced = true;
        frame.CenterA = placement.A is null ? a.Center : inA.CenterInCore;
        frame.CenterB = placement.B is null ? b.Center : inB.CenterInCore;
        frame.RadiusA = a.BoundingRadius;
        frame.RadiusB = b.BoundingRadius;
        frame.MarginA = a.Margin;
        frame.MarginB = b.Margin;
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
                    poseA, poseB, placement.A is null ? a.Center : inA.ExactCenter,
                    placement.B is null ? b.Center : inB.ExactCenter));
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
