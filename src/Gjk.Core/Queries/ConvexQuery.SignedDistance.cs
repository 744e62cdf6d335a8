namespace Gjk.Core;

public static unsafe partial class ConvexQuery
{
    /// <summary>How far apart two convex shapes are, or how deep they overlap: apart, what <c>Distance</c> says, bit
    /// for bit; overlapping, minus the length of the shortest translation that separates them.</summary>
    /// <typeparam name="TA">The first shape's type.</typeparam>
    /// <typeparam name="TB">The second shape's type.</typeparam>
    /// <param name="a">The first shape.</param>
    /// <param name="poseA">Pose of A in the world.</param>
    /// <param name="b">The second shape.</param>
    /// <param name="poseB">Pose of B in the world.</param>
    /// <returns>Overlapping: <see cref="DistanceResult.Distance"/> is minus the depth, the true one rounded to float,
    /// and <see cref="DistanceResult.Normal"/> the direction in which B leaves A: moved along it by the depth, B only
    /// touches A. The points are the deepest ones, and PointB = PointA + Normal · Distance, as it is apart.
    /// <see cref="DistanceResult.LowerBound"/> is at most the true signed distance. Touching, the distance is 0, and
    /// there is a normal too. Of several ways out that are equally short it is always the same one for the same input.
    /// On curved cores (those that <c>Distance</c> names) the depth is within 1e-6 of the size, and the direction
    /// within 1e-6 rad where the way out ends on a smooth point and bends. Where the surface that the search builds
    /// outgrows its room (curved shapes that are concentric, hulls of thousands of vertices deep in each other), the
    /// status is <see cref="GjkStatus.IterationLimit"/>, and the true signed distance is between
    /// <see cref="DistanceResult.LowerBound"/> and <see cref="DistanceResult.Distance"/>.</returns>
    public static DistanceResult SignedDistance<TA, TB>(in TA a, in RigidPose poseA, in TB b, in RigidPose poseB)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        SignedDistanceSolver<NoPolytopeTrace> solver = default;
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
    /// <param name="simplex">Apart, as <c>Distance</c> gives it. Overlapping, the face of the Minkowski difference that
    /// the way out ends on. Empty when the input is invalid.</param>
    /// <returns>See the first overload.</returns>
    public static DistanceResult SignedDistance<TA, TB>(
        in TA a, in RigidPose poseA, in TB b, in RigidPose poseB, out FinalSimplex simplex)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        simplex = default;
        fixed (FinalSimplex* end = &simplex)
        {
            var solver = new SignedDistanceSolver<NoPolytopeTrace> { Simplex = end };
            PairQuery.Run(a, poseA, b, poseB, ref solver, out DistanceResult result);
            return result;
        }
    }

    /// <summary>As the first, beginning where the last query of the pair ended: faster for pairs that move
    /// little.</summary>
    /// <typeparam name="TA">The first shape's type.</typeparam>
    /// <typeparam name="TB">The second shape's type.</typeparam>
    /// <param name="a">The first shape.</param>
    /// <param name="poseA">Pose of A in the world.</param>
    /// <param name="b">The second shape.</param>
    /// <param name="poseB">Pose of B in the world.</param>
    /// <param name="warmStart">Kept by the caller, one per pair, in the same order of A and B; updated. It may be the
    /// one that <c>Distance</c> uses.</param>
    /// <returns>See the first overload. Within the accuracy that of the cold query.</returns>
    public static DistanceResult SignedDistance<TA, TB>(
        in TA a, in RigidPose poseA, in TB b, in RigidPose poseB, ref WarmStart warmStart)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        fixed (WarmStart* warm = &warmStart)
        {
            var solver = new SignedDistanceSolver<NoPolytopeTrace> { Warm = warm };
            PairQuery.Run(a, poseA, b, poseB, ref solver, out DistanceResult result);
            return result;
        }
    }
}
