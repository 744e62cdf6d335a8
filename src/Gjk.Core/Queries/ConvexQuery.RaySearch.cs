using System;
using System.Runtime.CompilerServices;

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
        CoreDispatch.Ask<T, PointShape, RayQuestion, RayMeeting>(
            ref shape, pose, ref point, new RigidPose(line.Origin), ref question, out hit);
    }

    /// <summary>Where a point that is cast meets a core.</summary>
    private struct RayQuestion : IPairProblem<CastFinding, RayMeeting>
    {
        /// <summary>
        /// Ratio of the origin's distance to the radius, beyond which the ray begins anew: from further away, rounding
        /// could carry the point through a flat shape. Pinned by TheClosedFormAgreesWithTheCast in RayCastTests, from
        /// below; four times as much would still round by less than what counts as touching.
        /// </summary>
        private const double FarOrigin = 3;

        /// <summary>Ratio to the radius: how far from the foot it begins then, outside the ball.</summary>
        private const double Anew = 2;

        private readonly WorldRay _line;

        /// <summary>Where the cast begins, its direction, how long that is, and the power of two in that.</summary>
        private double _begin, _length, _power;
        private Double3 _direction;

        public RayQuestion(in WorldRay line)
        {
            _line = line;
            _begin = 0;
            _direction = line.Direction;
            _length = line.Length;
            _power = 1;
        }

        public readonly bool IsValid => true;

        public readonly void Refuse(out RayMeeting result) =>
            result = new() { Status = CastStatus.InvalidInput };

        [MethodImpl(MethodImplOptions.NoInlining)]
        void IPairQuestion<RayMeeting>.Ask<TA, TB>(
            ref TA a, in RigidPose poseA, ref TB b, in RigidPose poseB, in PairPlacement placement, out RayMeeting hit)
        {
            PairFrame.Compose(ref a, poseA, ref b, poseB, placement, out PairFrame frame);
            if (!frame.IsValid)
            {
                Refuse(out hit);
                return;
            }

            if (frame.Translation.LengthSquared > FarOrigin * FarOrigin * frame.RadiusA * frame.RadiusA
                && frame.RadiusA > 0)
            {
                VectorDD center = placement.A is null ? a.Center : placement.A.ExactCenter;
                LocalRay.MakeFar(poseA, center, _line, out LocalRay ray);
                _begin = ray.Shift - Anew * frame.RadiusA;
                if (_begin < 0 || _begin > _line.Reach || ray.Foot.Length > Anew * frame.RadiusA)
                {
                    hit = new RayMeeting { Status = CastStatus.Miss };
                    return;
                }

                frame.Translation = frame.RotationA.InverseRotate(ray.At(-Anew * frame.RadiusA));
                frame.Magnitude = frame.Radius + frame.Margins + frame.Translation.SumOfMagnitudes;
                (_direction, _length) = (ray.Direction, 1);
            }

            _power = PowerOfTwo.AtMost(_length);
            PairProblem.Solve<TA, TB, RayQuestion, CastFinding, RayMeeting>(
                ref a, ref b, ref frame, ref this, out CastFinding cast);
            Finish(cast, frame, poseA, poseB, out hit);
        }

        /// <summary>Casts the point. Its motion is one solver unit long, or nearly.</summary>
        public readonly void Solve<TA, TB>(ref TA a, ref TB b, ref PairFrame frame, out CastFinding cast)
            where TA : struct, ISupportMap
            where TB : struct, ISupportMap
        {
            WarmStart unused = default;
            Double3 motion = frame.RotationA.InverseRotate(_direction * (1 / _power));
            double most = (_line.Reach - _begin) / frame.Unit / (_length / _power);
            CastSolver.Solve(ref a, ref b, ref frame, motion, most, ref unused, out cast);
        }

        public readonly void Finish(
            in CastFinding cast, in PairFrame frame, in RigidPose poseA, in RigidPose poseB, out RayMeeting hit)
        {
            double distance = Math.Min(_begin + cast.Fraction * (_length / _power) * frame.Unit, _line.Reach);
            hit = default;
            hit.Distance = distance;
            hit.Iterations = cast.Iterations;
            hit.Status = StatusOf(cast.Outcome, distance);
            if (hit.Status != CastStatus.Hit) return;
            hit.Normal = frame.RotationA.Rotate(cast.Normal);
            hit.Point = frame.SurfaceOfA(cast.OnA, cast.Normal, poseA.Position);
        }
    }
}
