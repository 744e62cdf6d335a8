using System;
using System.Runtime.CompilerServices;

namespace Gjk.Core;

/// <remarks>
/// Rays without a closed form: a point is cast along the ray. A ray that begins far away begins anew where it is about
/// to reach the ball around the shape, so that the steps of the cast are of the shape's size.
/// </remarks>
public static partial class ConvexQuery
{
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void SearchRay<T>(ref T shape, in RigidPose pose, in WorldRay line, out RayMeeting hit)
        where T : struct, ISupportMap
    {
        PointShape point = default;
        var question = new RayQuestion(line);
        Ask(ref shape, pose, ref point, new RigidPose(line.Origin), ref question);
        hit = question.Hit;
    }

    /// <summary>The pipeline of a ray, for any core and a point.</summary>
    private struct RayQuestion : IPairQuestion
    {
        /// <summary>
        /// Ratio of the origin's distance to the radius, beyond which the ray begins anew: from further away, rounding
        /// could carry the point through a flat shape. Pinned by TheClosedFormAgreesWithTheCast in RayCastTests, from
        /// below; four times as much would still round by less than what counts as touching.
        /// </summary>
        private const double FarOrigin = 3;

        /// <summary>Ratio to the radius: how far from the foot it begins then, outside the ball.</summary>
        private const double Anew = 2;

        public RayMeeting Hit;
        private readonly WorldRay _line;

        public RayQuestion(in WorldRay line)
        {
            Hit = default;
            _line = line;
        }

        [MethodImpl(MethodImplOptions.NoInlining)]
        public void Ask<TA, TB>(ref TA a, in RigidPose poseA, ref TB b, in RigidPose poseB)
            where TA : struct, ISupportMap
            where TB : struct, ISupportMap
        {
            PairFrame.Compose(ref a, poseA, ref b, poseB, out PairFrame frame);
            Hit.Status = CastStatus.InvalidInput;
            if (!frame.IsValid) return;
            double begin = 0, length = _line.Length;
            Vector3D direction = _line.Direction;
            if (frame.Translation.LengthSquared > FarOrigin * FarOrigin * frame.RadiusA * frame.RadiusA
                && frame.RadiusA > 0)
            {
                LocalRay.MakeFar(poseA, frame.CenterA, _line, out LocalRay ray);
                begin = ray.Shift - Anew * frame.RadiusA;
                Hit.Status = CastStatus.Miss;
                if (begin < 0 || begin > _line.Reach || ray.Foot.Length > Anew * frame.RadiusA) return;
                frame.Translation = frame.RotationA.InverseRotate(ray.At(-Anew * frame.RadiusA));
                frame.Magnitude = frame.Radius + frame.Margins + frame.Translation.SumOfMagnitudes;
                (direction, length) = (ray.Direction, 1);
            }

            Search(ref a, ref b, ref frame, direction, length, begin, poseA);
        }

        /// <summary>Casts the point. Its motion is one solver unit long, or nearly.</summary>
        private void Search<TA, TB>(
            ref TA a, ref TB b, ref PairFrame frame, in Vector3D direction, double length, double begin,
            in RigidPose poseA)
            where TA : struct, ISupportMap
            where TB : struct, ISupportMap
        {
            WarmStart unused = default;
            CastFinding cast;
            double power = PowerOfTwo.AtMost(length);
            Vector3D motion = frame.RotationA.InverseRotate(direction * (1 / power));
            if (frame.IsOrdinary)
            {
                double most = (_line.Reach - begin) / (length / power);
                CastSolver.Solve(ref a, ref b, ref frame, motion, most, ref unused, out cast);
            }
            else
            {
                SolverState.Begin<TA, TB>(frame, out SolverState state);
                ToUnitSize(ref a, ref b, ref frame, ref state, out UnitSized<TA> unitA, out UnitSized<TB> unitB);
                double most = (_line.Reach - begin) / frame.Unit / (length / power);
                CastSolver.Solve(ref unitA, ref unitB, ref frame, motion, most, ref unused, out cast);
            }

            Hit.Distance = Math.Min(begin + cast.Fraction * (length / power) * frame.Unit, _line.Reach);
            Hit.Iterations = cast.Iterations;
            Hit.Status = cast.Outcome == Verdict.Contradiction ? CastStatus.InvalidShape
                : cast.Outcome == Verdict.Undecided ? CastStatus.IterationLimit
                : cast.Outcome == Verdict.Apart ? CastStatus.Miss
                : Hit.Distance > 0 ? CastStatus.Hit : CastStatus.OverlappingAtStart;
            if (Hit.Status != CastStatus.Hit) return;
            Hit.Normal = frame.RotationA.Rotate(cast.Normal);
            Vector3D onA = cast.OnA + cast.Normal * frame.MarginA + frame.CenterA;
            Hit.Point = frame.RotationA.Rotate(onA * frame.Unit) + poseA.Position;
        }
    }
}
