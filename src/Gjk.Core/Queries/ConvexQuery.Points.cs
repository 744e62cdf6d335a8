namespace Gjk.Core;

// A point is a shape, too, the least of all, so these ask the pair queries: contains is overlaps, and both speak of
// the same point.
public static partial class ConvexQuery
{
    /// <summary>Whether a point is in a shape, its surface included.</summary>
    /// <typeparam name="T">The shape's type.</typeparam>
    /// <param name="shape">The shape.</param>
    /// <param name="pose">Its pose in the world.</param>
    /// <param name="point">In the world.</param>
    /// <returns>Exactly what <c>Overlaps</c> says of the shape and the point; false too when the input is
    /// invalid.</returns>
    public static bool Contains<T>(in T shape, in RigidPose pose, Vector3 point)
        where T : struct, ISupportMap =>
        Guard.IsFinite(point) && Overlaps(shape, pose, default(PointShape), new RigidPose(point));

    /// <summary>How far a point is from a shape, and where the shape is closest.</summary>
    /// <typeparam name="T">The shape's type.</typeparam>
    /// <param name="shape">The shape: A of the result.</param>
    /// <param name="pose">Its pose in the world.</param>
    /// <param name="point">In the world: B of the result.</param>
    /// <param name="maxDistance">World units: further apart, the query may end early.</param>
    /// <returns>What <c>Distance</c> says of the shape and a <see cref="PointShape"/>, bit for bit.</returns>
    public static DistanceResult Distance<T>(
        in T shape, in RigidPose pose, Vector3 point, float maxDistance = float.PositiveInfinity)
        where T : struct, ISupportMap =>
        Guard.IsFinite(point)
            ? Distance(shape, pose, default(PointShape), new RigidPose(point), maxDistance)
            : DistanceResult.Invalid(GjkStatus.InvalidInput, 0);

    /// <summary>The point of a shape that is closest to a point.</summary>
    /// <typeparam name="T">The shape's type.</typeparam>
    /// <param name="shape">The shape.</param>
    /// <param name="pose">Its pose in the world.</param>
    /// <param name="point">In the world.</param>
    /// <returns>In the world: the point itself where the shape contains it; NaN when the input is invalid.</returns>
    public static Vector3 ClosestPoint<T>(in T shape, in RigidPose pose, Vector3 point)
        where T : struct, ISupportMap
    {
        DistanceResult nearest = Distance(shape, pose, point);
        return nearest.IsOverlapping ? point : nearest.PointA;
    }

    /// <summary>How far a point is from a shape's surface, negative inside.</summary>
    /// <typeparam name="T">The shape's type.</typeparam>
    /// <param name="shape">The shape: A of the result.</param>
    /// <param name="pose">Its pose in the world.</param>
    /// <param name="point">In the world: B of the result.</param>
    /// <returns>What <c>SignedDistance</c> says of the shape and a <see cref="PointShape"/>, bit for bit: PointA is the
    /// nearest point of the surface, and the point is PointA + Normal · Distance, with either sign.</returns>
    public static DistanceResult SignedDistance<T>(in T shape, in RigidPose pose, Vector3 point)
        where T : struct, ISupportMap =>
        Guard.IsFinite(point)
            ? SignedDistance(shape, pose, default(PointShape), new RigidPose(point))
            : DistanceResult.Invalid(GjkStatus.InvalidInput, 0);
}
