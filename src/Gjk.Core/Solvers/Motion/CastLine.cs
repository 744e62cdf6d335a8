namespace Gjk.Core;

/// <summary>The motion of a cast, seen from A: B's centre moves along a line, and from where it is nearest to A's
/// centre all lengths on the line are measured. So nothing cancels, however far away B begins.</summary>
internal struct CastLine
{
    /// <summary>Length, a fraction of the radii and of the way to the nearest point: what rounding does to the place of
    /// the line, 32 roundings, twice the most (proofs/cast-line.g). A plane that is nearer proves no miss. Pinned by
    /// CastToleranceTests.</summary>
    private const double Rounding = 32 * RoundOff.Unit;

    /// <summary>Ratio to the radii: how much larger the balls are taken, so that cores that begin to touch with them
    /// are still apart there by more than rounding. Pinned by CastToleranceTests.</summary>
    private const double BallBand = 1e-12;

    /// <summary>Of the motion, of unit length.</summary>
    public Double3 Axis;

    /// <summary>The translation where the centres are nearest; perpendicular to the axis.</summary>
    public Double3 Nearest;

    /// <summary>The fraction at which they are.</summary>
    public double Middle;

    /// <summary>The motion's length for the fraction 1.</summary>
    public double Speed;

    /// <summary>The length, before and after the nearest point, in which the bounding balls overlap.</summary>
    public double HalfChord;

    /// <summary>How far rounding may have moved the line.</summary>
    public double Error;

    /// <summary>Makes the line.</summary>
    /// <param name="frame">The pair at the start.</param>
    /// <param name="motion">Of B, in A's frame, for the fraction 1.</param>
    /// <param name="line">The line, where there is one and the balls meet.</param>
    /// <returns>Hit where the bounding balls overlap somewhere on the line, Miss where they do not. Undecided where
    /// there is no motion: the line is a point then, the start.</returns>
    public static MotionVerdict Make(in PairFrame frame, in Double3 motion, out CastLine line)
    {
        line = default;
        double squared = motion.LengthSquared;
        line.Speed = Math.Sqrt(squared);
        line.Axis = motion * (1 / line.Speed);
        double way = -Double3.Dot(frame.Translation, line.Axis);
        line.Middle = way / line.Speed;
        if (!line.Axis.IsFinite || !Guard.IsFinite(line.Middle))
        {
            line = default;
            return MotionVerdict.Undecided;
        }

        // Twice, since the first time leaves what rounding does to the way.
        Double3 nearest = frame.Translation + line.Axis * way;
        line.Nearest = nearest - line.Axis * Double3.Dot(nearest, line.Axis);
        line.Error = Rounding * (frame.Radius + Math.Abs(way));
        double reach = frame.Radius * (1 + BallBand) + line.Error;
        double free = reach * reach - line.Nearest.LengthSquared;
        if (free < 0) return MotionVerdict.Miss;
        line.HalfChord = Math.Sqrt(free);
        return MotionVerdict.Hit;
    }

    /// <summary>The translation so far along the line.</summary>
    public readonly Double3 At(double along) => Nearest + Axis * along;

    /// <summary>The fraction at which B's centre is so far along the line.</summary>
    public readonly double FractionAt(double along) => Middle + along / Speed;
}
