namespace Gjk.Core;

// A point is a convex shape, so these methods call the pair queries.
public static partial class ConcaveQuery
{
    /// <summary>Whether a point is in a shape, its surface included.</summary>
    /// <param name="shape">The shape.</param>
    /// <param name="pose">Its pose in the world.</param>
    /// <param name="point">In the world.</param>
    /// <param name="scratch">Memory for the search.</param>
    /// <returns>For a solid also where its winding number about the point, which is exact, is not 0; false too when the
    /// input is invalid.</returns>
    public static bool Contains(in AnyShape shape, in RigidPose pose, Vector3 point, ConcaveScratch scratch) =>
        Guard.IsFinite(point) && Overlaps(shape, pose, Point, new RigidPose(point), scratch);

    /// <summary>How far a point is from a shape, and where the shape is closest.</summary>
    /// <param name="shape">The shape: A of the result.</param>
    /// <param name="pose">Its pose in the world.</param>
    /// <param name="point">In the world: B of the result.</param>
    /// <param name="scratch">Memory for the search.</param>
    /// <param name="maxDistance">World units: further apart, the query may end early.</param>
    /// <returns>What <c>Distance</c> says of the shape and a point; 0 inside a solid.</returns>
    public static PairDistance Distance(
        in AnyShape shape, in RigidPose pose, Vector3 point, ConcaveScratch scratch,
        float maxDistance = float.PositiveInfinity) =>
        Guard.IsFinite(point) ? Distance(shape, pose, Point, new RigidPose(point), scratch, maxDistance) : Invalid;

    /// <summary>The point of a shape that is closest to a point.</summary>
    /// <param name="shape">The shape.</param>
    /// <param name="pose">Its pose in the world.</param>
    /// <param name="point">In the world.</param>
    /// <param name="scratch">Memory for the search.</param>
    /// <returns>In the world: the point itself where the shape contains it; NaN when the input is invalid.</returns>
    public static Vector3 ClosestPoint(in AnyShape shape, in RigidPose pose, Vector3 point, ConcaveScratch scratch)
    {
        PairDistance nearest = Distance(shape, pose, point, scratch);
        return nearest.IsOverlapping ? point : nearest.Result.PointA;
    }

    /// <summary>How far a point is from a shape's surface, negative inside a convex shape or a solid.</summary>
    /// <param name="shape">The shape: A of the result.</param>
    /// <param name="pose">Its pose in the world.</param>
    /// <param name="point">In the world: B of the result.</param>
    /// <param name="scratch">Memory for the search.</param>
    /// <returns>PointA is the nearest point of the surface, and the point is PointA + Normal · Distance, with either
    /// sign. A surface has no inside, and a compound's has no single depth, unless it is of one
    /// solid alone: 0 there.</returns>
    public static PairDistance SignedDistance(
        in AnyShape shape, in RigidPose pose, Vector3 point, ConcaveScratch scratch) =>
        Guard.IsFinite(point) ? SignedDistance(shape, pose, Point, new RigidPose(point), scratch) : Invalid;

    private static AnyShape Point => AnyShape.Of(ConvexShape.Point());
}
