namespace Gjk.Core;

/// <summary>How a pair moves: the frame at any fraction, composed in double from double rotations. A pose rounded to
/// float would be off by 6e-8 of the size and of the way.</summary>
internal struct PairMotion
{
    /// <summary>Ratio: 16 roundings of the lengths that a gap is computed from, twice what the sums and products of a
    /// rotated support point lose. Pinned by TimeOfImpactTests.</summary>
    private const double RoundingRatio = 16 * RoundOff.Unit;

    /// <summary>Ratio to the reach: how much larger the balls are than they need be, so that shapes that fill them do
    /// not touch yet where their balls do. Above the touch tolerance of curved cores, 4e-10. Pinned by
    /// TimeOfImpactTests.</summary>
    private const double BallPad = 1e-7;

    public TurningBody A, B;

    /// <summary>From A's pivot to B's at the fraction 0, in the world's axes.</summary>
    public Double3 Start;

    /// <summary>How that changes over the fraction 1.</summary>
    public Double3 Velocity;

    /// <summary>Radians per fraction 1, of the body that turns faster.</summary>
    public readonly double Rate => Math.Max(A.Rate, B.Rate);

    /// <param name="motionA">A's motion.</param>
    /// <param name="motionB">B's.</param>
    /// <param name="frame">The pair at the start.</param>
    /// <param name="motion">Gets the pair's motion.</param>
    public static void Make(in RigidMotion motionA, in RigidMotion motionB, in PairFrame frame, out PairMotion motion)
    {
        TurningBody.Make(motionA, frame.TurnOfA, frame.CenterA, frame.RadiusA - frame.MarginA, out motion.A);
        TurningBody.Make(motionB, frame.TurnOfB, frame.CenterB, frame.RadiusB - frame.MarginB, out motion.B);
        motion.Start = frame.RotationA.Rotate(
            frame.Translation + motion.A.Offset - frame.Rotation.Rotate(motion.B.Offset));
        motion.Velocity = (Double3)motionB.Velocity - motionA.Velocity;
    }

    /// <summary>From A's pivot to B's at a fraction, in the world's axes.</summary>
    public readonly Double3 Between(double fraction) => Start + Velocity * fraction;

    /// <summary>Brings the frame to a fraction.</summary>
    public readonly void MoveTo(double fraction, ref PairFrame frame)
    {
        QuaternionD a = A.At(fraction), b = B.At(fraction), bInA = a.Conjugate * b;
        RotationD.Set(out frame.RotationA, a.X, a.Y, a.Z, a.W, A.Scale);
        RotationD.Set(out frame.Rotation, bInA.X, bInA.Y, bInA.Z, bInA.W, 0.5 * A.Scale * B.Scale);
        frame.Rotation.Transpose(out frame.Inverse);
        frame.Translation =
            frame.RotationA.InverseRotate(Between(fraction)) + frame.Rotation.Rotate(B.Offset) - A.Offset;
    }

    /// <summary>Upper bound of the speed of a point of one core, seen from a point of the other.</summary>
    public readonly double Speed => Velocity.Length + A.Rate * A.Reach + B.Rate * B.Reach;

    /// <summary>What rounding can do to a gap at a fraction: to the positions, the angles and the supports'
    /// values.</summary>
    public readonly double Rounding(double fraction, double margins) =>
        RoundingRatio * (Start.Length + A.Reach + B.Reach + margins + fraction * Speed);

    /// <summary>The fractions between which the balls about the pivots that hold the shapes overlap; outside they are
    /// apart.</summary>
    /// <param name="margins">Both margins.</param>
    /// <param name="most">The largest fraction.</param>
    /// <param name="begin">The first such fraction, rounded down.</param>
    /// <param name="end">The last one, rounded up.</param>
    /// <returns>False where they never do.</returns>
    public readonly bool TryReach(double margins, double most, out double begin, out double end)
    {
        begin = 0;
        end = most;
        double distance = Start.Length, speed = Velocity.Length;
        double pad = RoundingRatio * (distance + A.Reach + B.Reach + margins);
        double reach = (A.Reach + B.Reach + margins) * (1 + BallPad) + pad;
        if (!(speed > 0)) return !(distance > reach);

        // The pivots' line passes at across / speed; the cross product does not cancel where the way is long.
        double across = Double3.Cross(Start, Velocity).Length / speed;
        if (across > reach) return false;
        double half = Math.Sqrt(Math.Max(reach * reach - across * across, 0)) + pad;
        double middle = -Double3.Dot(Start, Velocity) / speed;
        double first = (middle - half) / speed, last = (middle + half) / speed;

        // Not finite for sizes at the end of double's range: then nothing is left out.
        if (first > 0) begin = first * (1 - 4 * RoundOff.Unit);
        if (last < most) end = last * (1 + 4 * RoundOff.Unit);
        return begin <= most && end >= 0;
    }

    /// <summary>The same motion in other units.</summary>
    public void Resize(double factor)
    {
        A.Resize(factor);
        B.Resize(factor);
        Start *= factor;
        Velocity *= factor;
    }
}
