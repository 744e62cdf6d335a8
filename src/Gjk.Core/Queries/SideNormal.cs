using System;
using System.Runtime.CompilerServices;

namespace Gjk.Core;

/// <summary>
/// The normal of a round side along which another body touches: of two parallel cylinders it is the direction from the
/// one's axis to the other's. The searches for curved cores end within a part of a length, which leaves the angle round
/// such a side open by its root, up to 1e-3, and puts the deepest points on different lines.
/// </summary>
/// <remarks>
/// The shape tells of its axis by the edge that it shows (<see cref="FaceCorners.SideRadius"/>); the axis of the other
/// body goes through its centre, or the direction is not the shortest way. So nothing is assumed: the direction is
/// taken if a support proves that it separates the bodies at least as far as the plane that is known, and if their
/// furthest points in it, which supports a little to both sides give, are opposite each other.
/// </remarks>
internal static class SideNormal
{
    /// <summary>
    /// Length: bodies that are further apart than this need no sharp normal. More than a solver's frames move a body at
    /// rest. Pinned by ParallelContactTests.
    /// </summary>
    private const double Near = 1e-2;

    /// <summary>
    /// Ratio: how far the supports at both ends lean, small against the slope of any end and large against rounding.
    /// Four times more or less changes nothing.
    /// </summary>
    private const double Lean = 1e-3;

    /// <summary>
    /// Length: ends that are this level are of one line. Between the rounding of two poses, 1e-7, which the axes of
    /// bodies that were placed in parallel are off by, and what leaning costs on a rounded side. Pinned by
    /// ParallelContactTests.
    /// </summary>
    private const double Level = 4e-7;

    /// <summary>
    /// Length: the two points are this near to one line along the normal; a rounding to float, and less than the line
    /// of a short body's ends may be off. Pinned by PointPlacementTests.
    /// </summary>
    private const double Beside = 1.0 / (1 << 23);

    /// <summary>Cosine: a search is never off by more.</summary>
    private const double LeastCosine = 0.99;

    /// <summary>Makes normal and points sharper where a round side is touched, of what a query found.</summary>
    /// <param name="a">The first core.</param>
    /// <param name="b">The second one.</param>
    /// <param name="frame">Where B is.</param>
    /// <param name="state">Of cores that are apart or overlap; a positive distance stays as it is.</param>
    /// <param name="trace">Is told of the supports.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Sharpen<TA, TB, TTrace>(
        ref TA a, ref TB b, in PairFrame frame, ref SolverState state, ref TTrace trace)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
        where TTrace : struct, IGjkTrace
    {
        if (state.IsCurved && state.Verdict == Verdict.Apart) SharpenNear(ref a, ref b, frame, ref state, ref trace);
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void SharpenNear<TA, TB, TTrace>(
        ref TA a, ref TB b, in PairFrame frame, ref SolverState state, ref TTrace trace)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
        where TTrace : struct, IGjkTrace
    {
        double scale = 1 / Math.Sqrt(state.Feature.NormalSquared);
        Vector3D known = state.Feature.Normal * -scale;
        if (!(state.Feature.Height * scale - frame.Margins <= Near * state.Size.Value)) return;
        bool isOfA = TryGetAxis(ref a, known, out Vector3D axis);
        if (!isOfA)
        {
            if (!TryGetAxis(ref b, frame.Rotation.InverseRotate(-known), out axis)) return;
            axis = frame.Rotation.Rotate(axis);
        }

        // Axes that only rounding has turned against each other: the direction is across that of the body whose side
        // is touched, by the other one's end.
        if (TryTake(ref a, ref b, frame, axis, known, ref state, ref trace, out Simplex ends)) return;
        axis = isOfA ? frame.Rotation.Rotate(ends.OnB(1) - ends.OnB(0)) : ends.OnA(1) - ends.OnA(0);
        if (!(axis.LengthSquared > 0)) return;
        TryTake(ref a, ref b, frame, axis * (1 / axis.Length), known, ref state, ref trace, out ends);
    }

    /// <summary>Takes the direction across an axis, if it is as good as the one that is known.</summary>
    /// <returns>False where it is not; the first two vertices are the furthest points of both bodies then.</returns>
    private static bool TryTake<TA, TB, TTrace>(
        ref TA a, ref TB b, in PairFrame frame, in Vector3D axis, in Vector3D known, ref SolverState state,
        ref TTrace trace, out Simplex ends)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
        where TTrace : struct, IGjkTrace
    {
        Vector3D normal = frame.Translation - axis * Vector3D.Dot(axis, frame.Translation);
        normal *= 1 / normal.Length;
        Simplex.Begin(out ends);
        Vector3D p = Ask(ref a, ref b, frame, axis * Lean - normal, ref state, ref trace, ref ends, 0);
        Vector3D q = Ask(ref a, ref b, frame, axis * -Lean - normal, ref state, ref trace, ref ends, 1);
        Vector3D w = Ask(ref a, ref b, frame, -normal, ref state, ref trace, ref ends, 2);
        double gap = -Vector3D.Dot(normal, w), level = Level * state.Size.Value;
        bool isLevel = -Vector3D.Dot(normal, p) - gap <= level && -Vector3D.Dot(normal, q) - gap <= level;
        bool isOpposite = Vector3D.Dot(axis, p) <= 0 && Vector3D.Dot(axis, q) >= 0;
        bool isAsGood = gap >= state.Plane.Distance && Vector3D.Dot(normal, known) >= LeastCosine;
        if (!(isLevel && isOpposite && isAsGood)) return false;
        ends.Select(2, 0, 1, 0, 0);
        Weights weights = ClosestPointWeights.Of(ends);
        if (!((ends.PointOf(weights) + normal * gap).Length <= Beside * state.Size.Value)) return false;
        double distance = state.Feature.Height / Math.Sqrt(state.Feature.NormalSquared);
        state.Simplex = ends;
        state.Weights = weights;
        state.Feature.Normal = -normal;
        state.Feature.NormalSquared = 1;
        state.Feature.Height = distance > 0 ? distance : Math.Min(gap, 0);
        state.Plane.Set(state.Feature, Math.Min(gap, state.Feature.Height));
        return true;
    }

    private static Vector3D Ask<TA, TB, TTrace>(
        ref TA a, ref TB b, in PairFrame frame, in Vector3D normal, ref SolverState state, ref TTrace trace,
        ref Simplex ends, int slot)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
        where TTrace : struct, IGjkTrace
    {
        Vector3D w = MinkowskiDifference.Support(ref a, ref b, frame, normal, ref ends, slot, out _);
        state.Iterations++;
        if (trace.IsOn) trace.OnSupport(new TracedSupport(frame, normal, ends, slot, false));
        return w;
    }

    /// <summary>The axis of the round side that a shape shows in a direction, as a unit vector.</summary>
    private static unsafe bool TryGetAxis<T>(ref T shape, in Vector3D direction, out Vector3D axis)
        where T : struct, ISupportMap
    {
        FaceCorner* memory = stackalloc FaceCorner[FaceCorners.Capacity];
        var corners = new FaceCorners(memory);
        FaceOf<T>.Get(shape, direction, ref corners);
        axis = default;
        if (corners.Count != 2 || !(corners.SideRadius > 0)) return false;
        axis = corners[0] - corners[1];
        axis *= 1 / axis.Length;
        return true;
    }
}
