namespace Gjk.Core;

public static partial class ConvexQuery
{
    /// <summary>Whether two convex shapes share a point, touching included: exactly when <c>Distance(a, b)</c> says
    /// <see cref="GjkStatus.Overlapping"/>, for supports in double.</summary>
    /// <typeparam name="TA">The first shape's type.</typeparam>
    /// <typeparam name="TB">The second shape's type.</typeparam>
    /// <param name="a">The first shape.</param>
    /// <param name="poseA">Pose of A in the world.</param>
    /// <param name="b">The second shape.</param>
    /// <param name="poseB">Pose of B in the world.</param>
    /// <returns>False too when the input is invalid; the other overload tells.</returns>
    public static bool Overlaps<TA, TB>(in TA a, in RigidPose poseA, in TB b, in RigidPose poseB)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap =>
        Overlaps(a, poseA, b, poseB, out _);

    /// <summary>As the other, with the status: Separated, Overlapping, or why there is no answer.</summary>
    /// <typeparam name="TA">The first shape's type.</typeparam>
    /// <typeparam name="TB">The second shape's type.</typeparam>
    /// <param name="a">The first shape.</param>
    /// <param name="poseA">Pose of A in the world.</param>
    /// <param name="b">The second shape.</param>
    /// <param name="poseB">Pose of B in the world.</param>
    /// <param name="status">Separated or Overlapping; otherwise why the return value is false.</param>
    /// <returns>True when the shapes share a point.</returns>
    public static bool Overlaps<TA, TB>(in TA a, in RigidPose poseA, in TB b, in RigidPose poseB, out GjkStatus status)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        OverlapSolver solver = default;
        PairQuery.Run(a, poseA, b, poseB, ref solver, out status);
        return status == GjkStatus.Overlapping;
    }
}
