namespace Gjk.Core;

// Rays without a closed form: a point is cast along the ray. A ray that begins far away begins anew where it is about
// to reach the ball around the shape, so that the steps of the cast are of the shape's size.
public static partial class ConvexQuery
{
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void SearchRay<T>(ref T shape, in RigidPose pose, in WorldRay line, out RayMeeting hit)
        where T : struct, ISupportMap
    {
        PointShape point = default;
        var question = new RayQuestion(line);
        PairQuery.Run(shape, pose, point, new RigidPose(line.Origin), ref question, out hit);
    }

    /// <summary>Where a point that is cast meets a core.</summary>
    private struct RayQuestion : IPairSolver<RayMeeting>
    {
        /// <summary>Ratio of the origin's distance to the radius, beyond which the ray begins anew: from further away,
        /// rounding could carry the point through a flat shape. Pinned by TheClosedFormAgreesWithTheCast in
        /// RayCastTests, from below; four times as much would still round by less than what counts as
        /// touching.</summary>
        private const double FarOrigin = 3;

        /// <summary>Ratio to the radius: how far from the foot it begins then, outside the ball.</summary>
        private const double Anew = 2;

        private readonly WorldRay _line;

        /// <summary>Where the cast begins, its direction, how long that is, and the power of two in that.</summary>
        private double _begin, _length, _power;
        private Double3 _direction;
        private CastFinding _cast;

        public RayQuestion(in WorldRay line)
        {
            _line = line;
            _begin = 0;
            _direction = line.Direction;
            _length = line.Length;
            _power = 1;
            Uncleared.Begin(out _cast);
        }

        readonly bool IPairSolver<RayMeeting>.TryFormula<TA, TB>(
            ref TA a, in RigidPose poseA, ref TB b, in RigidPose poseB, out RayMeeting hit)
        {
            hit = default;
            return false;
        }

        bool IPairSolver<RayMeeting>.TryBegin<TA, TB>(
            ref TA a, ref TB b, in RigidPose poseA, ref PairFrame frame, out RayMeeting hit)
        {
            hit = new() { Status = frame.IsValid ? CastStatus.Miss : CastStatus.InvalidInput };
            if (!frame.IsValid) return false;
            if (frame.Translation.LengthSquared > FarOrigin * FarOrigin * frame.RadiusA * frame.RadiusA
                && frame.RadiusA > 0)
            {
                ShapeTraits<TA>.Of.InCoreAxes(a, out Placement? placed);
                VectorDD center = placed is null ? a.Center : placed.ExactCenter;
                LocalRay.MakeFar(poseA, center, _line, out LocalRay ray);
                _begin = ray.Shift - Anew * frame.RadiusA;
                if (_begin < 0 || _begin > _line.Reach || ray.Foot.Length > Anew * frame.RadiusA)
                    return false;

                frame.Translation = frame.RotationA.InverseRotate(ray.At(-Anew * frame.RadiusA));
                frame.Magnitude = frame.Radius + frame.Margins + frame.Translation.SumOfMagnitudes;
                (_direction, _length) = (ray.Direction, 1);
            }

            _power = PowerOfTwo.AtMost(_length);
            return true;
        }

        /// <summary>Casts the point. Its motion is one solver unit long, or nearly.</summary>
        [MethodImpl(MethodImplOptions.NoInlining)]
        void ICoreSolver.Solve<TA, TB>(ref TA a, ref TB b, ref PairFrame frame, ref SolverState state)
        {
            WarmStart unused = default;
            Double3 motion = frame.RotationA.InverseRotate(_direction * (1 / _power));
            double most = (_line.Reach - _begin) / frame.Unit / (_length / _power);
            CastSolver.Solve(ref a, ref b, ref frame, motion, most, ref unused, out _cast);
        }

        readonly void IPairSolver<RayMeeting>.Finish(
            in SolverState state, in PairFrame frame, in RigidPose poseA, in RigidPose poseB, out RayMeeting hit)
        {
            double distance = Math.Min(_begin + _cast.Fraction * (_length / _power) * frame.Unit, _line.Reach);
            hit = default;
            hit.Distance = distance;
            hit.Iterations = _cast.Iterations;
            hit.Status = StatusOf(_cast.Outcome, distance);
            if (hit.Status != CastStatus.Hit) return;
            hit.Normal = frame.RotationA.Rotate(_cast.Normal);
            hit.Point = frame.SurfaceOfA(_cast.OnA, _cast.Normal, poseA.Position);
        }
    }
}
