namespace Gjk.Core;

public static unsafe partial class ConvexQuery
{
    /// <summary>The distance query, telling a trace what it does: for teaching, drawing and finding out. The result is
    /// the ordinary query's, bit for bit.</summary>
    /// <typeparam name="TA">The first shape's type.</typeparam>
    /// <typeparam name="TB">The second shape's type.</typeparam>
    /// <typeparam name="TTrace">The trace's type.</typeparam>
    /// <param name="a">The first shape.</param>
    /// <param name="poseA">Pose of A in the world.</param>
    /// <param name="b">The second shape.</param>
    /// <param name="poseB">Pose of B in the world.</param>
    /// <param name="trace">Told of every support and reduction. Two spheres, which a formula solves, are told as the
    /// one round that it stands for. Invalid input tells nothing, and neither does a half-space.</param>
    /// <param name="maxDistance">As in <c>Distance</c>.</param>
    /// <returns>See <see cref="DistanceResult"/>. What the trace throws passes through.</returns>
    public static DistanceResult Explain<TA, TB, TTrace>(
        in TA a, in RigidPose poseA, in TB b, in RigidPose poseB, ref TTrace trace,
        float maxDistance = float.PositiveInfinity)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
        where TTrace : struct, IGjkTrace
    {
        var solver = new DistanceSolver<TTrace>(maxDistance) { Trace = trace };
        PairQuery.Run(a, poseA, b, poseB, ref solver, out DistanceResult result);
        trace = solver.Trace;
        return result;
    }

    /// <summary>The query for the signed distance, telling a trace how it searches for the depth. The result is that of
    /// <c>SignedDistance</c>, bit for bit.</summary>
    /// <typeparam name="TA">The first shape's type.</typeparam>
    /// <typeparam name="TB">The second shape's type.</typeparam>
    /// <typeparam name="TTrace">The trace's type.</typeparam>
    /// <param name="a">The first shape.</param>
    /// <param name="poseA">Pose of A in the world.</param>
    /// <param name="b">The second shape.</param>
    /// <param name="poseB">Pose of B in the world.</param>
    /// <param name="trace">Told of the surface that grows inside the Minkowski difference of the cores. Two boxes
    /// without margins are answered by their 15 separating axes; a surface is grown for the trace alone then, and ends
    /// at the same depth. Nothing is told where nothing is searched: of invalid input, of two spheres, of a half-space,
    /// and of shapes with margins whose cores are apart, whose signed distance is that of the cores less the margins
    /// (<c>Explain</c> tells of it).</param>
    /// <returns>As <c>SignedDistance</c> gives it. What the trace throws passes through.</returns>
    public static DistanceResult ExplainDepth<TA, TB, TTrace>(
        in TA a, in RigidPose poseA, in TB b, in RigidPose poseB, ref TTrace trace)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
        where TTrace : struct, IPolytopeTrace
    {
        var solver = new SignedDistanceSolver<TTrace> { Trace = trace };
        PairQuery.Run(a, poseA, b, poseB, ref solver, out DistanceResult result);
        trace = solver.Trace;
        return result;
    }
}
