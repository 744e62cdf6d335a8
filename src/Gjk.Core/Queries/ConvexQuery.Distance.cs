namespace Gjk.Core;

public static unsafe partial class ConvexQuery
{
    /// <summary>The distance between two convex shapes, with the closest points, or that they overlap.</summary>
    /// <typeparam name="TA">The first shape's type.</typeparam>
    /// <typeparam name="TB">The second shape's type.</typeparam>
    /// <param name="a">The first shape.</param>
    /// <param name="poseA">Pose of A in the world.</param>
    /// <param name="b">The second shape.</param>
    /// <param name="poseB">Pose of B in the world.</param>
    /// <param name="maxDistance">In world units. When the distance, rounded to float, is larger, the query ends early
    /// with <see cref="GjkStatus.BeyondMaxDistance"/>. Below 0 counts as 0; NaN gives
    /// <see cref="GjkStatus.InvalidInput"/>.</param>
    /// <returns>The true distance of the shapes as given, rounded to float; on curved cores (cylinder, cone, ellipsoid,
    /// tapered capsule, and whatever has a margin that was scaled unevenly) within 1e-6 of the larger of size and
    /// distance. A <c>default</c> pose or shape, or a NaN, gives <see cref="GjkStatus.InvalidInput"/>. See
    /// <see cref="DistanceResult"/>.</returns>
    public static DistanceResult Distance<TA, TB>(
        in TA a, in RigidPose poseA, in TB b, in RigidPose poseB, float maxDistance = float.PositiveInfinity)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        var solver = new DistanceSolver<NoTrace>(maxDistance);
        PairQuery.Run(a, poseA, b, poseB, ref solver, out DistanceResult result);
        return result;
    }

    /// <summary>As the first, with the simplex that the answer came from.</summary>
    /// <typeparam name="TA">The first shape's type.</typeparam>
    /// <typeparam name="TB">The second shape's type.</typeparam>
    /// <param name="a">The first shape.</param>
    /// <param name="poseA">Pose of A in the world.</param>
    /// <param name="b">The second shape.</param>
    /// <param name="poseB">Pose of B in the world.</param>
    /// <param name="simplex">The support points of the nearest feature with their weights; empty when the input is
    /// invalid. When the shapes are further apart than asked, the last feature, if there was one.</param>
    /// <param name="maxDistance">As in the first overload.</param>
    /// <returns>See <see cref="DistanceResult"/>.</returns>
    public static DistanceResult Distance<TA, TB>(
        in TA a, in RigidPose poseA, in TB b, in RigidPose poseB, out FinalSimplex simplex,
        float maxDistance = float.PositiveInfinity)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        simplex = default;
        fixed (FinalSimplex* end = &simplex)
        {
            var solver = new DistanceSolver<NoTrace>(maxDistance, null, end);
            PairQuery.Run(a, poseA, b, poseB, ref solver, out DistanceResult result);
            return result;
        }
    }

    /// <summary>As the first, beginning where the last query of the pair ended: much faster for pairs that move
    /// little.</summary>
    /// <typeparam name="TA">The first shape's type.</typeparam>
    /// <typeparam name="TB">The second shape's type.</typeparam>
    /// <param name="a">The first shape.</param>
    /// <param name="poseA">Pose of A in the world.</param>
    /// <param name="b">The second shape.</param>
    /// <param name="poseB">Pose of B in the world.</param>
    /// <param name="warmStart">Kept by the caller, one per pair, in the same order of A and B; updated.</param>
    /// <param name="maxDistance">As in the first overload.</param>
    /// <returns>See <see cref="DistanceResult"/>. It agrees with the cold query's within the accuracy, not always to
    /// the last bit.</returns>
    public static DistanceResult Distance<TA, TB>(
        in TA a, in RigidPose poseA, in TB b, in RigidPose poseB, ref WarmStart warmStart,
        float maxDistance = float.PositiveInfinity)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        DistanceResult result;
        fixed (WarmStart* warm = &warmStart)
        {
            var solver = new DistanceSolver<NoTrace>(maxDistance, warm);
            PairQuery.Run(a, poseA, b, poseB, ref solver, out result);
        }

        return result;
    }
}
