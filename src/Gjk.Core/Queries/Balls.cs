namespace Gjk.Core;

/// <summary>Two balls (or points), in closed form: the line through their centres gives the distance and all points. It
/// is done in the world's axes, so no rotation stands between the positions and the answer. Any pair of shapes of which
/// the margins leave nothing comes here, whatever its types, so all of them have the same bits.</summary>
internal static class Balls
{
    /// <summary>Nothing is left of either shape without its margin.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool AreBalls<TA, TB>(ref TA a, ref TB b)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap =>
        a.BoundingRadius + b.BoundingRadius == a.Margin + b.Margin;

    [MethodImpl(MethodImplOptions.NoInlining)]
    public static void Distance<TA, TB>(
        ref TA a, in RigidPose poseA, ref TB b, in RigidPose poseB, float maxDistance, bool isSigned,
        out DistanceResult result)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        Double3 centerA = a.Center, centerB = b.Center;
        double marginA = a.Margin, marginB = b.Margin, margins = marginA + marginB;
        double turnA = RotationScale(poseA.Rotation), turnB = RotationScale(poseB.Rotation);
        Double3 between = PairFrame.BetweenCenters(poseA, centerA, poseB, centerB);
        double gap = BallGap(between, marginA, marginB, out double root);
        if (!IsBallGap(gap, marginA, marginB) || !(turnA > 0) || !(turnB > 0) || float.IsNaN(maxDistance))
        {
            result = DistanceResult.Invalid(GjkStatus.InvalidInput, 0);
            return;
        }

        Double3 normal = root > 0 ? between * (1 / root) : isSigned ? new Double3(1, 0, 0) : default;
        InverseRotate(poseA.Rotation, turnA, normal, out Double3 inA);
        InverseRotate(poseB.Rotation, turnB, normal, out Double3 inB);
        bool touching = gap <= GjkTolerances.Touch * margins;
        if (!touching && (float)gap > Math.Max(maxDistance, 0))
        {
            result = DistanceResult.Beyond(BallBound(root, margins), (Vector3)normal, 1);
            return;
        }

        // Apart, the points of the balls; touching, one that divides the line between the centres as the radii do.
        double share = touching && !isSigned && margins > 0 ? root / margins : 1;
        double reachA = share * marginA, reachB = share * marginB;
        ToWorld(poseA, centerA).Plus(normal, reachA, out Double3 worldA);
        worldA.Plus(normal, gap, out Double3 worldB);
        bool isFromB = DistanceFinish.IsSmallerB(marginA, marginB, centerB, DistanceFinish.MuchSmaller)
            || DistanceFinish.IsFarApart(gap, marginB, centerB);
        if (isFromB)
        {
            ToWorld(poseB, centerB).Plus(normal, -reachB, out worldB);
            if (!DistanceFinish.IsFarApart(gap, marginA, centerA)) worldB.Plus(normal, -gap, out worldA);
        }

        centerA.Plus(inA, reachA, out Double3 localA);
        centerB.Plus(inB, -reachB, out Double3 localB);
        float bound = 0;
        if (!touching || isSigned)
        {
            if (touching) gap = Math.Min(gap, 0);
            bound = BallBound(root, margins, touching);
        }
        else
        {
            if (isFromB) worldA = worldB;
            else worldB = worldA;
            (normal, gap) = (default, 0);
        }

        DistanceResult.Write(
            out result, touching ? GjkStatus.Overlapping : GjkStatus.Separated, (float)gap, bound, worldA.ToXyz(),
            worldB.ToXyz(), normal.ToXyz(), localA.ToXyz(), localB.ToXyz(), 1);
    }

    /// <summary>Overlapping, separated or invalid, as <see cref="Distance"/> says.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static GjkStatus Status<TA, TB>(ref TA a, in RigidPose poseA, ref TB b, in RigidPose poseB)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        Double3 between = PairFrame.BetweenCenters(poseA, a.Center, poseB, b.Center);
        double gap = BallGap(between, a.Margin, b.Margin, out _);
        if (!IsBallGap(gap, a.Margin, b.Margin) || !(RotationScale(poseA.Rotation) > 0)
            || !(RotationScale(poseB.Rotation) > 0))
        {
            return GjkStatus.InvalidInput;
        }

        return gap <= GjkTolerances.Touch * (a.Margin + b.Margin) ? GjkStatus.Overlapping : GjkStatus.Separated;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static double BallGap(in Double3 between, double marginA, double marginB, out double root)
    {
        root = between.Length;
        return root - marginA - marginB;
    }

    /// <summary>Whether the gap is that of valid balls; it is NaN or infinite where a position is.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static bool IsBallGap(double gap, double marginA, double marginB) =>
        marginA >= 0 & marginB >= 0 & Math.Abs(gap) + marginA + marginB <= PairFrame.MaxMagnitude;

    /// <summary>The distance of the centres less the radii, and less what rounding may have done.</summary>
    private static float BallBound(double root, double margins, bool isSigned = false)
    {
        double value = root - margins - GjkTolerances.LowerBoundError * (2 * margins + root);
        return value > 0 || isSigned ? RoundOff.Down(value) : 0;
    }

    /// <summary>2 / |q|², or 0 where that is no rotation.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double RotationScale(in Quaternion q)
    {
        double norm = (double)q.X * q.X + (double)q.Y * q.Y + (double)q.Z * q.Z + (double)q.W * q.W;
        return RigidPose.IsUnit(norm) ? 2 / norm : 0;
    }

    /// <summary>v turned by the inverse of q: v + w t + t × u with t = s v × u and s = 2 / |q|².</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void InverseRotate(in Quaternion q, double s, in Double3 v, out Double3 turned)
    {
        double x = q.X, y = q.Y, z = q.Z, w = q.W;
        double tx = (v.Y * z - v.Z * y) * s, ty = (v.Z * x - v.X * z) * s, tz = (v.X * y - v.Y * x) * s;
        Double3.Write(
            v.X + tx * w + (ty * z - tz * y), v.Y + ty * w + (tz * x - tx * z), v.Z + tz * w + (tx * y - ty * x),
            out turned);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double3 ToWorld(in RigidPose pose, in Double3 center) =>
        center.SumOfMagnitudes == 0 ? pose.Position : DistanceFinish.ToWorld(pose, center);
}
