namespace Gjk.Core;

/// <summary>A ray as a shape sees it: in the shape's axes, and measured from the point of its line that is nearest to
/// the shape's centre, the foot.</summary>
/// <remarks>A hit is a root of small numbers then, however far away the ray begins: no digits are left to cancel. The
/// foot itself is m - e (e · m), with m from the centre to the origin and e the unit direction. That loses 2^-53 |m|;
/// for an origin that is many radii away it is d × (m × d) / d², with the inner product in double-double.</remarks>
internal struct LocalRay
{
    /// <summary>Ratio of the origin's distance to the radius: beyond it the foot is found in double-double. Up to it
    /// double loses less than 1e-13 of the radius, which turns the normal of a grazed ball by less than 1e-6. Pinned by
    /// RayAccuracyTests.</summary>
    private const double FarOrigin = 256;

    /// <summary>Squared ratio: after a pass that has brought the foot nearer than a millionth of its old distance, a
    /// ten-billionth of what remains may be rounding. Pinned by RayThinTests.</summary>
    private const double Farther = 1e-12;

    /// <summary>Ratio to the lengths that cancel: 2^-90, more than double-double loses when it turns a vector twice
    /// (some 2^-97). What is less is nothing: a line in the plane of a face stays in it. Pinned by
    /// RayGrazeTests.</summary>
    private const double ExactError = 1.0 / (1L << 45) / (1L << 45);

    /// <summary>From the centre to the foot.</summary>
    public Double3 Foot;

    /// <summary>Of unit length.</summary>
    public Double3 Direction;

    /// <summary>How far along the direction the foot is from the origin; negative behind it.</summary>
    public double Shift;

    /// <summary>Whether foot and direction are rounded once, and in the axes of the body itself.</summary>
    public bool IsExact;

    /// <summary>The ray as a ball sees it: in the world's axes.</summary>
    /// <param name="between">From the ball's centre to the origin, in the world.</param>
    /// <param name="direction">In the world, of any length.</param>
    /// <param name="length">That length.</param>
    /// <param name="radius">The ball's.</param>
    /// <param name="ray">The ray.</param>
    /// <returns>False where the origin is too far away for double.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool TryMake(in Double3 between, in Double3 direction, double length, double radius, out LocalRay ray)
    {
        ray.Direction = direction * (1 / length);
        ray.Shift = -Double3.Dot(between, ray.Direction);
        ray.Foot = between + ray.Direction * ray.Shift;
        ray.IsExact = false;
        return between.LengthSquared <= FarOrigin * FarOrigin * radius * radius;
    }

    /// <summary>The same in the world's axes for an origin that is far away.</summary>
    /// <param name="pose">The shape's.</param>
    /// <param name="center">Its centre, in its own frame.</param>
    /// <param name="line">The ray in the world.</param>
    /// <param name="ray">The ray.</param>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static void MakeFar(in RigidPose pose, in VectorDD center, in WorldRay line, out LocalRay ray)
    {
        VectorDD between = (VectorDD)line.Origin - (Double3)pose.Position;
        if (((Double3)center).SumOfMagnitudes > 0) between -= VectorDD.Rotate(pose.Rotation, center);
        Double3 direction = line.Direction;
        double inverse = 1 / line.Length;
        var cross = (Double3)VectorDD.Cross(between, direction);
        ray.Foot = Double3.Cross(direction, cross) * inverse * inverse;
        ray.Direction = direction * inverse;
        ray.Shift = -Double3.Dot((Double3)between, ray.Direction);
        ray.IsExact = false;
    }

    /// <summary>The ray in the axes of the body, each number of it rounded once, even where it is what larger ones
    /// leave.</summary>
    /// <param name="pose">The shape's.</param>
    /// <param name="form">The body.</param>
    /// <param name="line">The ray in the world.</param>
    /// <param name="ray">The ray.</param>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static void MakeExact(in RigidPose pose, in ShapeForm form, in WorldRay line, out LocalRay ray)
    {
        Quaternion back = Quaternion.Conjugate(pose.Rotation);
        VectorDD between = VectorDD.Rotate(back, (VectorDD)line.Origin - (Double3)pose.Position);
        VectorDD direction = VectorDD.Rotate(back, line.Direction) * (1 / line.Length);
        between = between - form.Center - form.CenterError;
        if (form.IsPlaced)
        {
            between = VectorDD.Rotate(form.Turn.Conjugate, between);
            direction = VectorDD.Rotate(form.Turn.Conjugate, direction);
        }

        DoubleDouble shift = -VectorDD.Dot(between, direction) / VectorDD.Dot(direction, direction);
        double magnitude = ((Double3)between).SumOfMagnitudes + form.Center.SumOfMagnitudes;
        ray.Foot = RoundingOf(between + direction * shift, magnitude);
        ray.Direction = RoundingOf(direction, 1);
        ray.Shift = (double)shift;
        ray.IsExact = true;
    }

    /// <summary>To double, and to 0 where no digit is left.</summary>
    private static Double3 RoundingOf(in VectorDD v, double magnitude)
    {
        double error = ExactError * magnitude;
        var rounded = (Double3)v;
        return new Double3(
            Math.Abs(rounded.X) > error ? rounded.X : 0, Math.Abs(rounded.Y) > error ? rounded.Y : 0,
            Math.Abs(rounded.Z) > error ? rounded.Z : 0);
    }

    /// <summary>Moves the point from which a line is measured to the one nearest to the centre, in axes that may be
    /// scaled.</summary>
    /// <remarks>A body that is thin in its own axes is a ball or a circle in scaled ones, and the line begins there as
    /// far away as the body is thin. Each pass leaves the rounding of the last way, so there are more until it is
    /// nothing.</remarks>
    /// <param name="foot">The point; moved.</param>
    /// <param name="direction">Of any length.</param>
    /// <returns>How far it was moved, in lengths of the direction.</returns>
    public static double MoveToFoot(ref Double3 foot, in Double3 direction)
    {
        double square = direction.LengthSquared, shift = 0;
        while (true)
        {
            double before = foot.LengthSquared, way = -Double3.Dot(foot, direction) / square;
            foot += direction * way;
            shift += way;
            if (!(foot.LengthSquared < Farther * before)) return shift;
        }
    }

    /// <summary>A point of the ray, measured from the centre.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly Double3 At(double t) => Foot + Direction * t;
}
