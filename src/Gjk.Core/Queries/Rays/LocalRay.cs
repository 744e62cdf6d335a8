using System.Runtime.CompilerServices;

namespace Gjk.Core;

/// <summary>
/// A ray as a shape sees it: in the shape's axes, and measured from the point of its line that is nearest to the
/// shape's centre, the foot.
/// </summary>
/// <remarks>
/// A hit is a root of small numbers then, however far away the ray begins: no digits are left to cancel. The foot
/// itself is m - u (u · m), with m from the centre to the origin and u the unit direction. That loses |m| u; from an
/// origin that is many radii away it is d × (m × d) / d², with the inner product in double-double.
/// </remarks>
internal struct LocalRay
{
    /// <summary>
    /// Ratio of the origin's distance to the radius: beyond it the foot is found in double-double. Up to it double
    /// loses less than 1e-13 of the radius, which turns the normal of a grazed ball by less than 1e-6. Pinned by
    /// RayAccuracyTests.
    /// </summary>
    private const double FarOrigin = 256;

    /// <summary>From the centre to the foot.</summary>
    public Vector3D Foot;

    /// <summary>Of unit length.</summary>
    public Vector3D Direction;

    /// <summary>How far along the direction the foot is from the origin; negative behind it.</summary>
    public double Shift;

    /// <summary>The ray as a ball sees it: in the world's axes.</summary>
    /// <param name="between">From the ball's centre to the origin, in the world.</param>
    /// <param name="direction">In the world, of any length.</param>
    /// <param name="length">That length.</param>
    /// <param name="radius">The ball's.</param>
    /// <param name="ray">The ray.</param>
    /// <returns>False where the origin is too far away for double.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool TryMake(
        in Vector3D between, in Vector3D direction, double length, double radius, out LocalRay ray)
    {
        ray.Direction = direction * (1 / length);
        ray.Shift = -Vector3D.Dot(between, ray.Direction);
        ray.Foot = between + ray.Direction * ray.Shift;
        return between.LengthSquared <= FarOrigin * FarOrigin * radius * radius;
    }

    /// <summary>The same in the world's axes for an origin that is far away.</summary>
    /// <param name="pose">The shape's.</param>
    /// <param name="center">Its centre, in its own frame.</param>
    /// <param name="line">The ray in the world.</param>
    /// <param name="ray">The ray.</param>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static void MakeFar(in RigidPose pose, in Vector3D center, in WorldRay line, out LocalRay ray)
    {
        VectorDD between = (VectorDD)(Vector3D)line.Origin - (Vector3D)pose.Position;
        if (center.SumOfMagnitudes > 0) between -= VectorDD.Rotate(pose.Rotation, center);
        Vector3D direction = line.Direction;
        double inverse = 1 / line.Length;
        var cross = (Vector3D)VectorDD.Cross(between, direction);
        ray.Foot = Vector3D.Cross(direction, cross) * inverse * inverse;
        ray.Direction = direction * inverse;
        ray.Shift = -Vector3D.Dot((Vector3D)between, ray.Direction);
    }

    /// <summary>A point of the ray, measured from the centre.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly Vector3D At(double t) => Foot + Direction * t;
}
