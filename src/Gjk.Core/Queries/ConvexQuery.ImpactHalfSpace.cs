namespace Gjk.Core;

// When a half-space and a shape that turn come together.
public static unsafe partial class ConvexQuery
{
    private partial struct ImpactQuestion
    {
        void IPairSolver<CastResult>.SolveHalfSpace<T>(
            ref HalfSpacePair pair, ref T other, in RigidPose otherPose, out CastResult result)
        {
            result = CastResult.Nothing(
                pair.Status == GjkStatus.InvalidShape ? CastStatus.InvalidShape : CastStatus.InvalidInput, float.NaN,
                0);
            if (pair.Status is not (GjkStatus.Separated or GjkStatus.Overlapping) || !IsValid) return;
            if (pair.IsSwapped) PairMotion.Make(_motionB, _motionA, pair.Frame, out _motion);
            else PairMotion.Make(_motionA, _motionB, pair.Frame, out _motion);
            _begin = _follows ? _contact.Fraction : 0;
            _end = Math.Min(_maxFraction, SineCosine.MaxAngle / _motion.Rate);
            _isWhole = _end >= _maxFraction;
            double tolerance = ToleranceOf(pair.Frame, _motion, _end);
            if (_isWindow)
            {
                _isWhole = _isWhole || _to <= _end;
                (_begin, _end) = (Math.Max(_begin, _from), Math.Min(_end, _to));
                tolerance *= WindowRoom;
            }

            result = CastResult.Nothing(
                _isWhole ? CastStatus.Miss : CastStatus.IterationLimit, RoundOff.Down(_isWhole ? _maxFraction : _begin),
                0);
            if (!(_begin <= _end)) return;
            var search = new HalfSpaceMotion(pair, _motion, _end, tolerance);
            result = SearchHalfSpace(ref search, ref other);
        }

        /// <summary>Searches for a contact, or follows the one that is known and searches for the next.</summary>
        private readonly CastResult SearchHalfSpace<T>(ref HalfSpaceMotion search, ref T other)
            where T : struct, ISupportMap
        {
            CastResult contact = _contact;
            bool follows = _follows;
            Impact impact = default;
            (impact.Fraction, impact.Iterations) = (_begin, _follows ? _contact.Iterations : 1);
            while (true)
            {
                if (follows)
                {
                    search.Follow(ref other, _options.AllowedDepth, ref impact);
                    if (impact.Outcome != MotionVerdict.Over) break;
                }

                search.Advance(ref other, !_isWindow, ref impact);
                if (impact.Outcome == MotionVerdict.Hit)
                    contact = search.Contact(ref other, _motionA, _motionB, impact);
                follows = _follows && _options.PassesShallow && impact.Outcome == MotionVerdict.Hit
                    && impact.Steps < Impact.MaxSteps;
                if (!follows) break;
            }

            return Ended(contact, impact);
        }
    }
}
