using System;
using System.Numerics;
using System.Runtime.CompilerServices;

namespace Gjk.Core;

// Two balls (or points), in closed form: the line through their centres gives the distance and all points. It is done
// in the world's axes, so no rotation stands between the positions and the answer. Any pair of shapes of which the
// margins leave nothing comes here, whatever its types, so all of them have the same bits.
public static partial class ConvexQuery
{
    /// <summary>Nothing is left of either shape without its margin.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static bool AreBalls<TA, TB>(ref TA a, ref TB b)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap =>
        a.BoundingRadius + b.BoundingRadius == a.Margin + b.Margin;

    [MethodImpl(MethodImplOptions.NoInlining)]
    private static DistanceResult DistanceOfBalls<TA, TB>(
        ref TA a, in RigidPose poseA, ref TB b, in RigidPose poseB, float maxDistance, bool isSigned = false)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        double turnA = InverseTurn(poseA.Rotation), turnB = InverseTurn(poseB.Rotation);
        Double3 between = PairFrame.BetweenCenters(poseA, a.Center, poseB, b.Center);
        double gap = BallGap(between, a.Margin, b.Margin, out double root);
        if (!IsBallGap(gap, a.Margin, b.Margin) || !(turnA > 0) || !(turnB > 0) || float.IsNaN(maxDistance))
            return DistanceResult.Invalid(GjkStatus.InvalidInput, 0);

        double margins = a.Margin + b.Margin;
        Double3 normal = root > 0 ? between * (1 / root) : isSigned ? new Double3(1, 0, 0) : default;
        Double3 inA = Back(poseA.Rotation, turnA, normal), inB = Back(poseB.Rotation, turnB, normal);
        bool touching = gap <= GjkTolerances.Touch * margins;
        if (!touching && (float)gap > Math.Max(maxDistance, 0))
        {
            return DistanceResult.Beyond(BallBound(root, margins), (Vector3)normal, 1);
        }

        // Apart, the points of the balls; touching, one that divides the line between the centres as the radii do.
        double share = touching && !isSigned && margins > 0 ? root / margins : 1;
        double reachA = share * a.Margin, reachB = share * b.Margin;
        Double3 worldA = Place(poseA, a.Center) + normal * reachA;
        Double3 worldB = worldA + normal * gap;
        bool isFromB = IsSmallerB(a.Margin, b.Margin, b.Center, MuchSmaller) || IsFarApart(gap, b.Margin, b.Center);
        if (isFromB)
        {
            worldB = Place(poseB, b.Center) - normal * reachB;
            if (!IsFarApart(gap, a.Margin, a.Center)) worldA = worldB - normal * gap;
        }

        var localA = (Vector3)(inA * reachA + a.Center);
        var localB = (Vector3)(inB * -reachB + b.Center);
        if (!touching || isSigned)
        {
            if (touching) gap = Math.Min(gap, 0);
            return new DistanceResult(
                touching ? GjkStatus.Overlapping : GjkStatus.Separated, (float)gap,
                BallBound(root, margins, touching), (Vector3)worldA, (Vector3)worldB,
                (Vector3)normal, localA, localB, 1);
        }

        var common = (Vector3)(isFromB ? worldB : worldA);
        return new DistanceResult(GjkStatus.Overlapping, 0, 0, common, common, Vector3.Zero, localA, localB, 1);
    }

    /// <summary>Overlapping, separated or invalid, as <see cref="DistanceOfBalls"/> says.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static GjkStatus StatusOfBalls<TA, TB>(ref TA a, in RigidPose poseA, ref TB b, in RigidPose poseB)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        Double3 between = PairFrame.BetweenCenters(poseA, a.Center, poseB, b.Center);
        double gap = BallGap(between, a.Margin, b.Margin, out _);
        if (!IsBallGap(gap, a.Margin, b.Margin) || !(InverseTurn(poseA.Rotation) > 0)
            || !(InverseTurn(poseB.Rotation) > 0))
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
    private static double InverseTurn(Quaternion q)
    {
        double norm = (double)q.X * q.X + (double)q.Y * q.Y + (double)q.Z * q.Z + (double)q.W * q.W;
        return RigidPose.IsUnit(norm) ? 2 / norm : 0;
    }

    /// <summary>v turned by the inverse of q: v + w t + t × u with t = s v × u and s = 2 / |q|².</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Double3 Back(Quaternion q, double s, in Double3 v)
    {
        var u = new Double3(q.X, q.Y, q.Z);
        Double3 t = Double3.Cross(v, u) * s;
        return v + t * q.W + Double3.Cross(t, u);
    }

    /// <summary>A shape's centre in the world.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Double3 Place(in RigidPose pose, in Double3 center) =>
        center.SumOfMagnitudes == 0 ? pose.Position : ToWorld(pose, center);
}
