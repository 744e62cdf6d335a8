namespace Gjk.Core;

public static partial class ConvexQuery
{
    /// <summary>Where a ray first meets a shape.</summary>
    /// <typeparam name="T">The shape's type.</typeparam>
    /// <param name="shape">The shape.</param>
    /// <param name="pose">Its pose in the world.</param>
    /// <param name="origin">Where the ray begins, in the world.</param>
    /// <param name="direction">Any finite vector but zero; its length does not matter.</param>
    /// <param name="maxDistance">World units: how far the ray reaches, +infinity for all the way; less than 0 counts as
    /// 0, which asks whether the origin is inside.</param>
    /// <param name="options">Which contacts are passed; by default none. The depth is that of the point.</param>
    /// <param name="sides">Which sides are met; by default both, of a solid shape. A ray that begins inside a hollow
    /// one gets what <c>RayExit</c> says, whatever the options.</param>
    /// <returns>The first point of the ray that is in the closed shape, or <see cref="CastStatus.Miss"/>, or
    /// <see cref="CastStatus.OverlappingAtStart"/> where the origin is inside. The distance is the true one, rounded to
    /// float: within 1e-7 of the size or the way, whichever is larger, however far away the ray begins; the normal is
    /// within 1e-6 of the true one where there is only one, of cylinders and cones with thin margins within 1e-5. Hit
    /// or miss is what exact geometry says, but for rays that pass the surface within 1e-9 of the size; one that is so
    /// near all along, as in the plane of a hull that is as flat as that, may meet it anywhere there. From an origin on
    /// the surface, where the signed distance is 0, a ray that goes in hits at 0, and one that slides or leaves
    /// misses.</returns>
    /// <remarks>Spheres, capsules, boxes, cylinders, cones, ellipsoids, triangles, half-spaces, and hulls of up to some
    /// 250 corners have closed forms, scaled and placed, too. The rest is cast as a point: shapes of your own, tapered
    /// capsules, shapes rounded that are not spheres or capsules then, and flat ones.</remarks>
    public static RayCastResult RayCast<T>(
        in T shape, in RigidPose pose, Vector3 origin, Vector3 direction, float maxDistance = float.PositiveInfinity,
        in CastOptions options = default, RaySides sides = RaySides.Both)
        where T : struct, ISupportMap
    {
        ref T inward = ref PairQuery.AsRef(shape);
        var line = new WorldRay(origin, direction, ((Double3)direction).Length, Math.Max(maxDistance, 0));
        CastRay(ref inward, pose, line, out RayMeeting hit);
        if (!options.Settles(hit.Status))
            return SettleRay(ref inward, pose, line, options, sides, hit);
        if (hit.Status == CastStatus.Hit)
        {
            return new RayCastResult(
                CastStatus.Hit, hit.Distance, (Vector3)hit.Point, (Vector3)hit.Normal, hit.Iterations);
        }

        return RayCastResult.Nothing(
            hit.Status, FractionOf(hit.Status, hit.Distance, (float)line.Reach), hit.Iterations);
    }

    /// <summary>A contact at the origin, or one that may be passed.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static RayCastResult SettleRay<T>(
        ref T shape, in RigidPose pose, in WorldRay line, in CastOptions options, RaySides sides, in RayMeeting hit)
        where T : struct, ISupportMap
    {
        PointShape point = default;
        bool isStart = hit.Status == CastStatus.OverlappingAtStart, isHollow = isStart && sides.Has(RaySides.Hollow);
        double fraction = isStart ? 0 : hit.Distance;
        var contact = new SettledContact
        {
            Status = hit.Status,
            Point = (Vector3)hit.Point,
            Normal = (Vector3)hit.Normal,
        };
        Settle(
            ref shape, pose, ref point, new RigidPose((Vector3)line.Origin), line.Direction * (1 / line.Length),
            fraction, line.Reach, isHollow ? default : options, ref contact);
        int iterations = hit.Iterations + contact.Iterations;
        if (isHollow && contact.Status == CastStatus.OverlappingAtStart)
        {
            if (!sides.Has(RaySides.FrontOnly)) return ExitOf(ref shape, pose, line, hit);
            contact.Status = CastStatus.Miss;
        }

        if (contact.Status is CastStatus.Hit or CastStatus.OverlappingAtStart)
        {
            return new RayCastResult(
                contact.Status, fraction, isStart ? (Vector3)line.Origin : contact.Point, contact.Normal, iterations,
                contact.Depth);
        }

        return RayCastResult.Nothing(
            contact.Status, FractionOf(contact.Status, double.NaN, (float)line.Reach), iterations);
    }

    /// <summary>By a closed form where there is one, else by a cast.</summary>
    /// <param name="shape">The shape.</param>
    /// <param name="pose">Its pose in the world.</param>
    /// <param name="line">The ray; may be invalid.</param>
    /// <param name="hit">What it met.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void CastRay<T>(ref T shape, in RigidPose pose, in WorldRay line, out RayMeeting hit)
        where T : struct, ISupportMap
    {
        double turn = Balls.RotationScale(pose.Rotation);
        if (!IsRay(pose, turn, line))
        {
            hit = default;
            hit.Status = CastStatus.InvalidInput;
        }
        else if (!TryClosedForm(ref shape, pose, turn, line, out hit))
        {
            SearchRay(ref shape, pose, line, out hit);
        }
        else if (hit.IsAtSurface && IsInside(ref shape, pose, new RigidPose((Vector3)line.Origin)))
        {
            hit.Status = CastStatus.OverlappingAtStart;
        }
    }

    /// <summary>What a ray meets, where a closed form says it.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static bool TryClosedForm<T>(
        ref T shape, in RigidPose pose, double turn, in WorldRay line, out RayMeeting hit)
        where T : struct, ISupportMap
    {
        FormKind form = ShapeTraits<T>.Instance.GetPlain(ref shape, out Double3 size);
        hit = default;
        bool isPlain = form == FormKind.Ball || (form == FormKind.Box && shape.Margin == 0);
        return (isPlain && shape.Center.SumOfMagnitudes == 0
                && RayCaster.TryCastPlain(form, size, shape.BoundingRadius, pose, turn, line, out hit))
            || TryTarget(ref shape, pose, turn, line, out hit);
    }

    /// <summary>The same for any body; a method of its own, so that the commonest do not clear its form.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static bool TryTarget<T>(ref T shape, in RigidPose pose, double turn, in WorldRay line, out RayMeeting hit)
        where T : struct, ISupportMap
    {
        hit = default;
        return ShapeTraits<T>.Instance.TryGetForm(ref shape, out ShapeForm form)
            && RayCaster.TryCast(form, shape.BoundingRadius, pose, turn, line, out hit);
    }

    /// <summary>Whether the numbers are those of a ray and a rotation.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static bool IsRay(in RigidPose pose, double turn, in WorldRay line) =>
        turn > 0 & line.Length > 0 & line.Length <= PairFrame.MaxMagnitude & line.Reach >= 0
            & line.Origin.SumOfMagnitudes < double.PositiveInfinity & Guard.IsFinite(pose.Position);

    /// <summary>Whether a point touches a shape, as the overlap of the pair in its own order says it: another order
    /// rounds otherwise.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static bool IsInside<T>(ref T shape, in RigidPose pose, in RigidPose point, bool isPointFirst = false)
        where T : struct, ISupportMap
    {
        PointShape at = default;
        return isPointFirst ? Overlaps(at, point, shape, pose) : Overlaps(shape, pose, at, point);
    }

    /// <summary>Rays without a closed form: a point is cast along the ray. A ray that begins far away begins anew where
    /// it is about to reach the ball around the shape, so that the steps of the cast are of the shape's size.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void SearchRay<T>(ref T shape, in RigidPose pose, in WorldRay line, out RayMeeting hit)
        where T : struct, ISupportMap
    {
        PointShape point = default;
        var question = new RayQuestion(line);
        var at = new RigidPose(line.Ball > 0 ? pose.Position : (Vector3)line.Origin);
        PairQuery.Run(shape, pose, point, at, ref question, out hit);
    }

    /// <summary>Where a point that is cast meets a core.</summary>
    private struct RayQuestion(in WorldRay line) : IPairSolver<RayMeeting>
    {
        /// <summary>Ratio of the origin's distance to the radius, beyond which the ray begins anew: from further away,
        /// rounding could carry the point through a flat shape. Pinned by TheClosedFormAgreesWithTheCast in
        /// RayCastTests, from below; four times as much would still round by less than what counts as
        /// touching.</summary>
        private const double FarOrigin = 3;

        /// <summary>Ratio to the radius: how far from the foot it begins then, outside the ball.</summary>
        private const double Anew = 2;

        private readonly WorldRay _line = line;

        /// <summary>Where the cast begins, its direction, how long that is, and the power of two in that.</summary>
        private double _begin = 0, _length = line.Length, _power = 1;
        private Double3 _direction = line.Direction;
        private CastFinding _cast;

        readonly bool IPairSolver<RayMeeting>.TryFormula<TA, TB>(
            ref TA a, in RigidPose poseA, ref TB b, in RigidPose poseB, out RayMeeting hit)
        {
            hit = default;
            return false;
        }

        readonly void IPairSolver<RayMeeting>.SolveHalfSpace<T>(
            ref HalfSpacePair pair, ref T other, in RigidPose otherPose, out RayMeeting hit)
        {
            hit = default;
            hit.Status = pair.Meet(_line.Direction * (1 / _line.Length), _line.Reach, out hit.Distance);
            hit.Point = _line.At(hit.Distance);
            hit.Normal = pair.Outward;
            hit.Iterations = 1;
        }

        bool IPairSolver<RayMeeting>.TryBegin<TA, TB>(
            ref TA a, ref TB b, in RigidPose poseA, ref PairFrame frame, out RayMeeting hit)
        {
            hit = new() { Status = frame.IsValid ? CastStatus.Miss : CastStatus.InvalidInput };
            if (!frame.IsValid) return false;
            frame.TightenRadii(ref a, ref b);
            double radius = _line.Ball > 0 ? _line.Ball : frame.RadiusA;
            bool isFar = frame.Translation.LengthSquared > FarOrigin * FarOrigin * radius * radius && radius > 0;
            if (isFar || _line.Ball > 0)
            {
                Placement? placed = ShapeTraits<TA>.Instance.PlacementOf(ref a);
                VectorDD center = placed is null ? a.Center : placed.ExactCenter;
                LocalRay.MakeFar(poseA, center, _line, out LocalRay ray);
                _begin = ray.Shift - Anew * radius;
                if (_begin < 0 || _begin > _line.Reach || ray.Foot.Length > Anew * radius)
                    return false;

                frame.Translation = frame.RotationA.InverseRotate(ray.At(-Anew * radius));
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
