namespace Gjk.Core;

/// <summary>A ray against a shape that has a closed form.</summary>
/// <remarks>
/// The idea: the ray is brought to the shape's axes and measured from the point of its line that is nearest to the
/// shape's centre (<see cref="LocalRay"/>), so nothing that follows knows how far away the ray began. The body cuts an
/// interval out of the line (<see cref="RayBody"/>). The interval says all: beyond the reach, behind the origin, or
/// around it.
/// <para>All of it is in double. What rounding could turn is done again or handed on: a line along a face, or one that
/// nearly touches, is measured in double-double; an origin within 1e-9 of the surface goes to the overlap query, so
/// that both say the same; bodies that are flat to nothing go to the cast (<see cref="CastSolver"/>).</para>
/// <para>Sources: Ericson, Real-Time Collision Detection (2005), section 5.3, and Eberly's notes; there the interval is
/// not measured from the foot, and grazing hits lose half the digits.</para>
/// </remarks>
internal static class RayCaster
{
    /// <summary>Length, as a fraction of the radius: an origin whose ray crosses the surface nearer than this may be on
    /// either side. Above what the queries count as touching (<see cref="GjkTolerances.TouchCurved"/>). The overlap
    /// decides within it, so four times more or less only changes how often it is asked.</summary>
    private const double SurfaceBand = 1e-9;

    /// <summary>Length, as a fraction of the radius: a surface that is no further along the ray is at its start, if the
    /// origin touches it; half of what is promised. Pinned by RayStartTests.</summary>
    private const double StartBand = 5e-8;

    /// <summary>Ratio to the distance and the radius: a hit that is beyond the reach by less is at its end: more than
    /// rounding makes of it. Pinned by RayCastTests.</summary>
    private const double EndError = 32 * RoundOff.Unit;

    /// <summary>Ratio to the distances that the foot is made of: what rounding usually does to it, ten times over, and
    /// more than it ever does (proofs/ray-foot.g). Pinned by RayAccuracyTests.</summary>
    private const double FootError = 64 * RoundOff.Unit;

    /// <summary>Lengths: 2^-120 and 2^120. In between, the fourth powers of lengths and their quotients keep within the
    /// range of double. Pinned by RayCastTests.</summary>
    private const double LeastRadius = 1.0 / (1L << 60) / (1L << 60), MostRadius = (double)(1L << 60) * (1L << 60);

    /// <summary>Casts the ray.</summary>
    /// <param name="form">The body.</param>
    /// <param name="radius">Of a ball about its centre that holds it.</param>
    /// <param name="pose">Its pose in the world.</param>
    /// <param name="turn">2 / |q|² of the pose.</param>
    /// <param name="line">The ray.</param>
    /// <param name="hit">What it met.</param>
    /// <returns>False where there is no closed form.</returns>
    public static bool TryCast(
        in ShapeForm form, double radius, in RigidPose pose, double turn, in WorldRay line, out RayMeeting hit)
    {
        hit = default;
        if (form.IsRounded || !(radius >= LeastRadius && radius <= MostRadius)) return false;
        Double3 between = line.Origin - pose.Position;
        if (form.Kind == FormKind.Ball && form.Center.SumOfMagnitudes == 0)
            return TryCastBall(form.Radius, pose, between, line, ref hit);
        bool isNear = TryApproach(
            form.Center, radius, between, pose, turn, line, ref hit, out RotationD rotation, out LocalRay ray);
        if (hit.Status != CastStatus.None) return true;
        if (!isNear)
        {
            LocalRay.MakeFar(pose, form.Center, line, out ray);
            ray.Foot = rotation.InverseRotate(ray.Foot);
            ray.Direction = rotation.InverseRotate(ray.Direction);
        }

        double shift = ray.Shift;
        RayFinding finding = RayBody.Find(form, ray, out RaySpan span);
        if (finding == RayFinding.Close)
        {
            LocalRay.MakeExact(pose, form, line, out LocalRay exact);
            finding = RayBody.Find(form, exact, out span);
            shift = exact.Shift;
        }

        if (finding == RayFinding.Unfit) return false;
        if (!Judge(finding == RayFinding.Found, span, shift, radius, line.Reach, ref hit)) return true;
        SetSurface(rotation, span, line, ref hit);
        if (!isNear) hit.Point = rotation.Rotate(ray.At(span.Enter) + form.Center) + pose.Position;
        return true;
    }

    /// <summary>A ball or a box about its local origin, of which nothing but the size need be known.</summary>
    /// <param name="form">Which of them.</param>
    /// <param name="size">The ball's radius, three times; or half the box's sides.</param>
    /// <param name="radius">Of a ball about the origin that holds it.</param>
    /// <param name="pose">Its pose in the world.</param>
    /// <param name="turn">2 / |q|² of the pose.</param>
    /// <param name="line">The ray.</param>
    /// <param name="hit">What it met.</param>
    /// <returns>False where it is to be asked as a <see cref="ShapeForm"/>, which knows more.</returns>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static bool TryCastPlain(
        FormKind form, in Double3 size, double radius, in RigidPose pose, double turn, in WorldRay line,
        out RayMeeting hit)
    {
        hit = default;
        if (!(radius >= LeastRadius && radius <= MostRadius)) return false;
        Double3 between = line.Origin - pose.Position;
        if (form == FormKind.Ball) return TryCastBall(size.X, pose, between, line, ref hit);
        bool isNear = TryApproach(
            default, radius, between, pose, turn, line, ref hit, out RotationD rotation, out LocalRay ray);
        if (hit.Status != CastStatus.None) return true;
        if (!isNear || !RayBox.IsSolid(size) || RayBox.IsAlongSide(ray, size)) return false;
        bool isFound = RayBox.TryFind(ray, size, out RaySpan span);
        if (Judge(isFound, span, ray.Shift, radius, line.Reach, ref hit)) SetSurface(rotation, span, line, ref hit);
        return true;
    }

    /// <summary>Brings the ray to the shape's axes, and says if it misses the ball around it.</summary>
    /// <returns>False where the origin, or the centre, is too far away for double.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static bool TryApproach(
        in Double3 center, double radius, in Double3 between, in RigidPose pose, double turn, in WorldRay line,
        ref RayMeeting hit, out RotationD rotation, out LocalRay ray)
    {
        Quaternion q = pose.Rotation;
        RotationD.Set(out rotation, q.X, q.Y, q.Z, q.W, turn);
        Double3 local = rotation.InverseRotate(between) - center;
        double offset = center.SumOfMagnitudes;
        bool isNear = LocalRay.TryMake(local, rotation.InverseRotate(line.Direction), line.Length, radius, out ray)
            && offset <= PairFrame.FarCenter * radius;
        double reach = radius + FootError * (between.SumOfMagnitudes + offset);
        bool isMiss = ray.Foot.LengthSquared > reach * reach || ray.Shift < -reach || ray.Shift - reach > line.Reach;
        if (isMiss) hit.Status = CastStatus.Miss;
        return isNear;
    }

    /// <summary>The normal and the point of a hit near the origin.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void SetSurface(in RotationD rotation, in RaySpan span, in WorldRay line, ref RayMeeting hit)
    {
        Double3 normal = rotation.Rotate(span.Normal);
        double length = normal.Length;

        // Of a body that is thinner than rounding the closed form has none; it is met head on.
        hit.Normal = length > 0 ? normal * (1 / length) : line.Direction * (-1 / line.Length);
        hit.Point = line.At(hit.Distance);
    }

    /// <summary>A ball about its own origin needs no rotation.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static bool TryCastBall(
        double radius, in RigidPose pose, in Double3 between, in WorldRay line, ref RayMeeting hit)
    {
        if (!(radius > 0)) return false;
        bool isNear = LocalRay.TryMake(between, line.Direction, line.Length, radius, out LocalRay ray);
        if (!isNear)
        {
            double reach = radius + FootError * between.SumOfMagnitudes;
            if (ray.Foot.LengthSquared > reach * reach)
            {
                hit.Status = CastStatus.Miss;
                return true;
            }

            LocalRay.MakeFar(pose, default, line, out ray);
        }

        bool found = RayBall.TryFind(ray, radius, out RaySpan span);
        if (span.IsClose && isNear)
        {
            LocalRay.MakeFar(pose, default, line, out ray);
            found = RayBall.TryFind(ray, radius, out span);
        }

        if (!Judge(found, span, ray.Shift, radius, line.Reach, ref hit)) return true;
        hit.Normal = span.Normal * (1 / radius);
        hit.Point = span.Normal + pose.Position;
        return true;
    }

    /// <summary>What the interval says of the ray.</summary>
    /// <returns>Whether it begins where the ray meets the body, at its start perhaps, which no reach is too short
    /// for.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static bool Judge(
        bool isFound, in RaySpan span, double shift, double radius, double reach, ref RayMeeting hit)
    {
        double enter = span.Enter + shift, exit = span.Exit + shift, band = SurfaceBand * radius;
        hit.Status = CastStatus.Miss;
        if (!isFound || exit < -band) return false;
        hit.IsAtSurface = enter <= StartBand * radius && (enter >= -band || exit <= band);
        if (!hit.IsAtSurface && enter <= 0)
        {
            hit.Status = CastStatus.OverlappingAtStart;
            return false;
        }

        hit.Distance = Math.Max(enter, 0);
        if (!(exit >= 0 && enter >= -band)) return false;
        bool isReached = enter - EndError * (enter + radius) <= reach;
        if (isReached) hit.Status = CastStatus.Hit;
        return isReached | hit.IsAtSurface;
    }
}
