namespace Gjk.Core;

/// <summary>The place of B on the line of a cast: up to where the two are apart, from where on they touch, and where to
/// look next.</summary>
/// <remarks>
/// <para>The distance along the line is convex. Where it falls at a place at which they are apart, they are apart
/// before it too; so such a place may be jumped to, and is as good as one that planes have proved step by step. A place
/// where they touch already bounds the first contact from behind.</para>
/// <para>With margins the distance is curved: the line meets a ball about a vertex, a cylinder about an edge, a plane
/// beside a face. If the feature that is nearest now is the one that is touched, the jump ends the cast (Ericson 2004,
/// section 5.3, for the ray against each).</para>
/// </remarks>
internal struct CastJump
{
    /// <summary>Ratio to the line's error: how far behind a plane that was crossed its shape still counts as met.
    /// Pinned by CastToleranceTests.</summary>
    private const double Through = 4;

    /// <summary>Ratio of squares: four times what a touching gap adds to the square of the radii. Pinned by
    /// TouchingStartTests.</summary>
    private const double StartBand = 8 * GjkTolerances.TouchCurved;

    /// <summary>Where B is now, a length along the line.</summary>
    public double Along;

    /// <summary>Up to here they are apart.</summary>
    public double Left;

    /// <summary>Where the start is, and the end, with what rounding may do to it.</summary>
    private double _start, _end;

    /// <summary>Up to here the plane at <see cref="Left"/> proves them apart.</summary>
    private double _safe;

    /// <summary>From here on they touch, as far as is known.</summary>
    private double _right;

    /// <summary>Whether the last move was a jump.</summary>
    private bool _isJump;

    /// <summary>Begins where the bounding balls begin to overlap; or at the start, if that is later, or may count as
    /// touching.</summary>
    public static void Make(in CastLine line, double most, out CastJump place)
    {
        place = default;
        place._start = -line.Middle * line.Speed;
        place._end = (most - line.Middle) * line.Speed + line.Error;
        place._right = double.PositiveInfinity;
        place.Along = place._start < -line.HalfChord && !IsAtBalls(place._start, line)
            ? -line.HalfChord
            : place._start;
        place.Left = place._safe = place.Along;
    }

    /// <summary>Whether the start is so near to where the bounding balls touch that it may count as touching: then the
    /// distance there must say whether it does.</summary>
    private static bool IsAtBalls(double start, in CastLine line)
    {
        double chord = line.HalfChord * line.HalfChord, reach = chord + line.Nearest.LengthSquared;
        return start * start - chord <= StartBand * reach;
    }

    /// <summary>False at the very start, which has its own translation, exact to the last bit.</summary>
    public readonly bool IsPastStart => Along > _start;

    /// <summary>The fraction of a place: 0 at the start and nowhere else.</summary>
    public readonly double FractionOf(in CastLine line, double along) =>
        along > _start ? Math.Max(line.FractionAt(along), double.Epsilon) : 0;

    /// <summary>Ends the cast, or moves on.</summary>
    /// <param name="state">The distance where B is.</param>
    /// <param name="frame">The pair there.</param>
    /// <param name="line">The line.</param>
    /// <param name="gap">How far behind the contact a jump may end.</param>
    /// <param name="cast">Gets the end.</param>
    public bool TryEnd(in SolverState state, in PairFrame frame, in CastLine line, double gap, ref CastFinding cast)
    {
        bool isApart = state.Verdict == Verdict.Apart;
        double scale = isApart ? 1 / Math.Sqrt(state.Plane.NormalSquared) : 0;
        Double3 normal = state.Plane.Normal * scale;
        double slope = Double3.Dot(normal, line.Axis), away = state.Plane.Value * scale - frame.Margins;
        double ahead = away / slope;
        bool isTouching = !isApart || Proofs.IsTouching(
            state, Proofs.DistanceOf(state, frame, 1 / Math.Sqrt(state.Feature.NormalSquared)));
        if (isTouching && (!_isJump || (slope > 0 && -ahead <= gap)))
        {
            if (isApart && frame.Margins > 0 && IsPastStart && slope > 0) cast.Normal = -normal;
            return End(line, MotionVerdict.Hit, ref cast);
        }

        if (!isTouching && slope > 0)
        {
            cast.Normal = -normal;
            Left = Along;
            _safe = Math.Max(Along + ahead, -line.HalfChord);
            if (_safe > _end) return End(line, MotionVerdict.Miss, ref cast);
            if (!(_safe > Along))
            {
                // The bounds of a curved core's distance can be on either side of touching: what is not overlapping at
                // the start is hit, however soon.
                End(line, MotionVerdict.Hit, ref cast);
                cast.Fraction = Math.Max(cast.Fraction, double.Epsilon);
                return true;
            }

            MoveTo(Along + AheadTo(state, frame, line.Axis));
            return false;
        }

        if (!isTouching && !_isJump)
        {
            // Where nothing is behind the plane that was crossed, rounding may have gone through it.
            bool isThrough = Left < Along && away <= Through * line.Error;
            return End(line, isThrough ? MotionVerdict.Hit : MotionVerdict.Miss, ref cast);
        }

        // The first contact, if there is one, is behind.
        _right = Along;
        MoveTo(isApart ? Along + AheadTo(state, frame, line.Axis) : double.NaN);
        return false;
    }

    private readonly bool End(in CastLine line, MotionVerdict outcome, ref CastFinding cast)
    {
        // A jump may have gone past the end: where it went does not depend on the end.
        cast.Outcome = Along > _end ? MotionVerdict.Miss : outcome;
        cast.Fraction = FractionOf(line, Along);
        return true;
    }

    /// <summary>Jumps, where that gains anything, or goes as far as the plane has proved.</summary>
    private void MoveTo(double jump)
    {
        _isJump = jump > _safe && jump < _right;
        Along = _isJump ? jump : _safe;
    }

    /// <summary>How far it is to where the line meets the margin about the nearest feature, as if that had no end; NaN
    /// where it does not, or where the plane's own step is as good.</summary>
    private static double AheadTo(in SolverState state, in PairFrame frame, in Double3 axis)
    {
        double radius = frame.Margins;
        if (state.IsCurved || radius == 0 || state.Simplex.Count > 2) return double.NaN;
        Double3 corner = state.Simplex.WA;
        if (state.Simplex.Count == 1)
        {
            double nearest = Double3.Dot(corner, axis);
            return nearest - Math.Sqrt(radius * radius - (corner - axis * nearest).LengthSquared);
        }

        // Project along the edge: the cylinder becomes a circle. Solve |p + t u| = r; the projection shortens the line
        // by this factor.
        Double3 edge = state.Simplex.WB - corner, across = Double3.Cross(edge, axis);
        double lengthSquared = edge.LengthSquared, speedSquared = across.LengthSquared / lengthSquared;
        double middle = Double3.Dot(Double3.Cross(edge, corner), across) / lengthSquared;
        double passing = Double3.Dot(across, corner);
        double chordSquared = radius * radius * speedSquared - passing * passing / lengthSquared;
        return (middle - Math.Sqrt(chordSquared)) / speedSquared;
    }
}
