namespace Gjk.Core;

/// <summary>When a half-space and a shape that move and turn come together: conservative advancement as in
/// <see cref="AdvancementSolver{TA, TB}"/> and <see cref="ContactFollower{TA, TB}"/>, with the gap in closed
/// form.</summary>
/// <remarks>
/// <para>The gap is the least of n · x over the other's points. In the half-space's axes n stands still, and such a
/// point is a sum of turned vectors, whose second derivative is bounded: with q from pivot to point, v the velocity
/// between the pivots, w and o the rates of half-space and other and R the other's reach, by w² |q| + 2 w (|v| + o R) +
/// o² R. So between two fractions the gap is at least its chord less the bound's parabola, as
/// <see cref="TurningPlane"/> proves it.</para>
/// <para>It terminates as the advancement does: each step leaves a floor, and what is left open is several
/// floors.</para>
/// </remarks>
/// <param name="pair">The pair at the fraction 0.</param>
/// <param name="motion">How it moves, the half-space as A.</param>
/// <param name="end">The last fraction.</param>
/// <param name="tolerance">The largest gap of a hit, in world units.</param>
internal struct HalfSpaceMotion(in HalfSpacePair pair, in PairMotion motion, double end, double tolerance)
{
    /// <summary>Counts: after so many steps it pays to measure how far the other reaches from its axis, and in how many
    /// directions. They change the cost alone, and keep a wheel that rolls from running out of steps.</summary>
    private const int MeasureAfter = 8, MeasuredDirections = 64;

    private readonly double _end = end, _tolerance = tolerance;
    private readonly double _floor = Impact.FloorRatio * tolerance, _accepted = Impact.MostAccepted * tolerance;
    private HalfSpacePair _pair = pair;
    private PairMotion _motion = motion;

    /// <summary>Whether they overlap, or touch, at the fraction 0.</summary>
    private readonly bool IsOverlapping => _pair.Status == GjkStatus.Overlapping;

    /// <summary>Goes on until they are within the tolerance.</summary>
    /// <param name="other">The other's core.</param>
    /// <param name="leaves">Whether what is within the tolerance and parts goes on.</param>
    /// <param name="impact">From where on; gets the end.</param>
    public void Advance<T>(ref T other, bool leaves, ref Impact impact)
        where T : struct, ISupportMap
    {
        while (true)
        {
            TurningPlane plane = PlaneAt(ref other, impact.Fraction, 0);
            impact.Steps++;
            impact.Iterations++;
            impact.Outcome = MotionVerdict.Hit;
            if (impact.Fraction == 0 && IsOverlapping) return;
            if (impact.Steps == MeasureAfter) _motion.B.Measure(ref other, MeasuredDirections);
            double next;
            if (plane.Gap <= _accepted)
            {
                if (!leaves || !(plane.Rate >= 0) || !TryEnd(ref other, plane, 0, 2 * _accepted, out next)) return;
            }
            else
            {
                next = Step(ref other, plane, 0);
            }

            if (!impact.TryGoTo(next, _end)) return;
        }
    }

    /// <summary>Follows a contact until it ends, gets deeper than is allowed, or lasts.</summary>
    /// <param name="other">The other's core.</param>
    /// <param name="allowed">World units: how deep they may get, if they are not deeper at the fraction 0
    /// already.</param>
    /// <param name="impact">From where on; gets the end.</param>
    public void Follow<T>(ref T other, double allowed, ref Impact impact)
        where T : struct, ISupportMap
    {
        // Beside far more than they can get to, the gaps would be lost.
        double depth = impact.Fraction > 0 ? 0 : -_pair.Gap;
        double deepest = Fastest(impact.Fraction) * (_end - impact.Fraction)
            + Math.Abs(PlaneAt(ref other, impact.Fraction, 0).Gap);
        double shrunk = Math.Max(Math.Min(allowed, deepest), depth) + _tolerance + _accepted;
        _motion.B.Measure(ref other, MeasuredDirections);
        while (true)
        {
            TurningPlane plane = PlaneAt(ref other, impact.Fraction, shrunk);
            double gap = plane.Gap - shrunk;
            impact.Steps++;
            impact.Iterations++;
            impact.Outcome = gap > 0 ? MotionVerdict.Over : MotionVerdict.Hit;
            if (plane.Gap <= _accepted || gap >= 2 * _tolerance) return;
            bool isOver = TryEnd(ref other, plane, shrunk, shrunk + 2 * _tolerance, out double next);
            if (!isOver) next = Step(ref other, plane, shrunk);
            bool goesOn = impact.TryGoTo(next, _end);
            if (isOver && impact.Outcome != MotionVerdict.Miss) impact.Outcome = MotionVerdict.Over;
            if (isOver || !goesOn) return;
        }
    }

    /// <summary>The contact that was found, in the order of the query.</summary>
    public readonly CastResult Contact<T>(
        ref T other, in RigidMotion motionA, in RigidMotion motionB, in Impact impact)
        where T : struct, ISupportMap
    {
        float fraction = RoundOff.Down(impact.Fraction);
        PairFrame frame = _pair.Frame;
        _motion.MoveTo(fraction, ref frame);
        double gap = _pair.GapIn(frame, ref other, out Double3 on);
        Double3 local = frame.Translation + frame.Rotation.Rotate(on) - _pair.Normal * frame.MarginB;
        if (!_pair.IsSwapped) local -= _pair.Normal * gap;
        RigidMotion plane = _pair.IsSwapped ? motionB : motionA;
        Double3 position = (Double3)plane.Pose.Position + (Double3)plane.Velocity * fraction;
        var outward = (Vector3)frame.RotationA.Rotate(_pair.Normal);
        bool isStart = impact.Fraction == 0 && IsOverlapping;
        return new CastResult(
            isStart ? CastStatus.OverlappingAtStart : CastStatus.Hit, impact.Fraction,
            (Vector3)(frame.RotationA.Rotate(local) + position),
            isStart ? Vector3.Zero : _pair.IsSwapped ? Opposite.Of(outward) : outward, impact.Iterations).At(fraction);
    }

    /// <summary>The gap at a fraction, added to what both may overlap, and how it changes.</summary>
    private TurningPlane PlaneAt<T>(ref T other, double fraction, double shrunk)
        where T : struct, ISupportMap
    {
        _motion.MoveTo(fraction, ref _pair.Frame);
        ref PairFrame frame = ref _pair.Frame;
        TurningPlane plane = default;
        plane.Start = fraction;
        plane.Gap = _pair.GapIn(frame, ref other, out Double3 on) + shrunk;
        Double3 fromB = frame.RotationA.Rotate(frame.Rotation.Rotate(on + _motion.B.Offset));
        Double3 normal = _pair.Outward, point = _motion.Between(fraction) + fromB;
        plane.Rate = Double3.Dot(Double3.Cross(_motion.A.AngularVelocity, normal), point)
            + Double3.Dot(normal, _motion.Velocity + Double3.Cross(_motion.B.AngularVelocity, fromB));
        double rate = _motion.A.Rate, turned = _motion.B.Rate * _motion.B.Reach;
        double length = Math.Max(point.Length, _motion.Between(_end).Length) + _motion.B.Reach;
        plane.Curvature = rate * (rate * length + 2 * (_motion.Velocity.Length + turned)) + _motion.B.Rate * turned;
        return plane;
    }

    /// <summary>Goes as far as is proved, towards where the gap is half of what is accepted.</summary>
    private readonly double Step<T>(ref T other, in TurningPlane plane, double shrunk)
        where T : struct, ISupportMap
    {
        // The first root of gap + rate s - bend s², with which the chord is proved for certain, or the whole way.
        double above = plane.Gap - 0.5 * _accepted, bend = 0.5 * plane.Curvature;
        double root = Math.Sqrt(plane.Rate * plane.Rate + 4 * bend * above), step = 2 * above / (root - plane.Rate);
        double next = step > 0 ? Math.Min(plane.Start + step, _end) : _end;
        double gap = GapAt(ref other, next) + shrunk, length = next - plane.Start;
        if (!plane.IsProved(length, gap, _floor))
            next = plane.Start + length * plane.ProvedPart(length, gap, _floor);
        return Math.Max(next, Sweep(plane.Start, shrunk));
    }

    /// <summary>Up to where a half-space that does not turn is out of reach of all that the other can turn to: a wheel
    /// rolls along it in one step.</summary>
    private readonly double Sweep(double start, double shrunk)
    {
        if (_motion.A.IsTurning) return start;
        Double3 normal = _pair.Outward;
        double gap = Double3.Dot(normal, _motion.Between(start)) - _motion.B.SweptReach(-normal) - _pair.PlaneDistance
            - _pair.Frame.MarginB + shrunk - _floor;
        double rate = Double3.Dot(normal, _motion.Velocity);
        return !(gap > 0) ? start : rate < 0 ? Math.Min(start - gap / rate, _end) : _end;
    }

    /// <summary>Searches for a proved step that ends well outside, or at the end; each try goes four times further,
    /// since a body may leave, turn, and come back.</summary>
    private readonly bool TryEnd<T>(
        ref T other, in TurningPlane plane, double shrunk, double outside, out double next)
        where T : struct, ISupportMap
    {
        const int mostTries = 32, further = 4;
        double step = Math.Max(outside - plane.Gap, _floor) / Fastest(plane.Start);
        next = plane.Start;
        for (int i = 0; i < mostTries && next < _end; i++, step *= further)
        {
            next = Math.Min(plane.Start + step, _end);
            double gap = GapAt(ref other, next) + shrunk;
            if (!plane.IsProved(next - plane.Start, gap, _floor)) return false;
            if (gap >= outside) return true;
        }

        return next >= _end;
    }

    /// <summary>No gap changes faster from a fraction on.</summary>
    private readonly double Fastest(double from) => _motion.Speed
        + _motion.A.Rate * (Math.Max(_motion.Between(from).Length, _motion.Between(_end).Length) + _motion.B.Reach);

    private readonly double GapAt<T>(ref T other, double fraction)
        where T : struct, ISupportMap
    {
        PairFrame frame = _pair.Frame;
        _motion.MoveTo(fraction, ref frame);
        return _pair.GapIn(frame, ref other, out _);
    }
}
