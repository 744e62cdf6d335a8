using System;

namespace Gjk.Core;

/// <summary>
/// How deep two bodies of revolution with parallel axes overlap. Turned about its axis a body is the same, so a way out
/// is shortest when it lies in the plane of both axes, and there the search is one of directions on half a circle.
/// </summary>
/// <remarks>
/// <para>
/// Between two directions A - B lies beyond the chord from the one's support point to the other's. So no direction
/// between them has a shorter way out than the chord's height, or than the two have, and that ends it where this is no
/// less than the shortest way that was found. Otherwise the support point over the chord divides the two into halves.
/// The halves are walked from one end of the half circle to the other, those still to come on a stack.
/// </para>
/// <para>
/// The general search (<see cref="GjkDepth"/>) proves the same with a surface of triangles. About a common axis it
/// needs thousands of them, since all directions around it are equally good.
/// </para>
/// <para>
/// It terminates because a support point lies above its chord by more than the noise, so that a curve of A - B is cut
/// into finitely many pieces, and because supports are counted. Verdicts: Enclosed when the bounds met and Apart as
/// those of the general search; Contradiction when a support was NaN or lay below its chord; Undecided hands over to
/// it, where the shapes touch by rounding or the supports are spent.
/// </para>
/// </remarks>
internal static unsafe class AxialDepth
{
    /// <summary>
    /// Length: what may be left between the bounds. Balls about one centre need a support for every root of it. Pinned
    /// by CoaxialDepthTests.
    /// </summary>
    private const double Noise = 1e-7;

    /// <summary>Count: supports at most; balls about one centre need half of it. Pinned by CoaxialDepthTests.</summary>
    private const int MostSupports = 8192;

    /// <summary>Count: pieces still to be walked; each is far shorter than the one under it.</summary>
    private const int MostWaiting = 64;

    /// <summary>Finds the depth; the state gets a feature of negative height, as if the shapes were apart.</summary>
    public static DepthVerdict Solve<TA, TB>(
        ref TA a, ref TB b, in PairFrame frame, in WayOut plane, ref SolverState state)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        int before = state.Iterations;
        DepthBounds depth = DepthBounds.None;
        DepthVerdict verdict = plane.IsDirection
            ? Look(ref a, ref b, frame, plane, ref state, ref depth)
            : Turn(ref a, ref b, frame, plane, ref state, ref depth);
        double band = GjkTolerances.SeparatedBandOf(state.IsCurved) * state.Size.Value + 2 * state.DepthNoise;
        if (verdict == DepthVerdict.Enclosed && !(depth.Above > band)) verdict = DepthVerdict.Undecided;
        if (verdict == DepthVerdict.Undecided) state.Iterations = before;
        else verdict = DepthEnd.Settle(ref a, ref b, frame, depth, verdict, ref state);
        return verdict;
    }

    /// <summary>The direction is known.</summary>
    private static DepthVerdict Look<TA, TB>(
        ref TA a, ref TB b, in PairFrame frame, in WayOut way, ref SolverState state, ref DepthBounds depth)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        Ask(ref a, ref b, frame, way, 1, 0, ref state, ref depth);
        return !(depth.Above <= double.MaxValue) ? DepthVerdict.Contradiction
            : depth.IsApart(state) ? DepthVerdict.Apart : DepthVerdict.Enclosed;
    }

    /// <summary>
    /// Searches the plane, or where the bodies are only nearly coaxial one plane after the other all around the axis:
    /// each proves those beside it as far as the slope lets it.
    /// </summary>
    private static DepthVerdict Turn<TA, TB>(
        ref TA a, ref TB b, in PairFrame frame, in WayOut way, ref SolverState state, ref DepthBounds depth)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        int limit = state.Iterations + MostSupports;
        DepthVerdict verdict = Walk(ref a, ref b, frame, way, 0, limit, ref state, ref depth);
        double angle = 0, half = Math.PI / 4;
        while (way.Slope > 0 && angle < 2 * Math.PI && verdict == DepthVerdict.Enclosed)
        {
            WayOut plane = way.Turned(angle + half);
            verdict = Walk(ref a, ref b, frame, plane, half * way.Slope, limit, ref state, ref depth);
            bool isTooWide = verdict == DepthVerdict.Flat;
            if (isTooWide) verdict = DepthVerdict.Enclosed;
            else angle += 2 * half;
            half = isTooWide ? half / 2 : Math.Min(2 * half, Math.PI / 4);
        }

        return verdict;
    }

    /// <summary>
    /// Proves that every way out in a plane is longer than the shortest that was found, by as much as those in the
    /// planes beside it may be shorter: whatever the direction, since a body that leans is moved as a whole when it is
    /// turned about the other's axis.
    /// </summary>
    /// <returns>Flat where one is not.</returns>
    private static DepthVerdict Walk<TA, TB>(
        ref TA a, ref TB b, in PairFrame frame, in WayOut plane, double less, int limit, ref SolverState state,
        ref DepthBounds depth)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        Side* waiting = stackalloc Side[MostWaiting];
        Side begin = Ask(ref a, ref b, frame, plane, 0, -1, ref state, ref depth);
        waiting[1] = Ask(ref a, ref b, frame, plane, 1, 0, ref state, ref depth);
        waiting[0] = Ask(ref a, ref b, frame, plane, 0, 1, ref state, ref depth);
        if (!(depth.Above <= double.MaxValue)) return DepthVerdict.Contradiction;
        int count = 2;
        double noise = Noise * state.Size.Value, contradiction = GjkTolerances.Contradiction * state.Size.Value;
        double least = Math.Min(Math.Min(begin.Height, waiting[1].Height), waiting[0].Height);
        while (count > 0)
        {
            if (depth.IsApart(state)) return DepthVerdict.Apart;
            double proved = depth.Above + less - noise;
            if (least < proved) return DepthVerdict.Flat;
            Side end = waiting[count - 1];
            if (begin.TryGetChord(end, out double x, out double y, out double height) && height < proved)
            {
                if (count == MostWaiting || state.Iterations >= limit) return DepthVerdict.Undecided;
                Side between = Ask(ref a, ref b, frame, plane, x, y, ref state, ref depth);
                least = Math.Min(least, between.Height);
                if (!(between.Height - height >= -contradiction)) return DepthVerdict.Contradiction;
                if (between.Height - height > noise)
                {
                    waiting[count++] = between;
                    continue;
                }
            }

            begin = end;
            count--;
        }

        return DepthVerdict.Enclosed;
    }

    private static Side Ask<TA, TB>(
        ref TA a, ref TB b, in PairFrame frame, in WayOut plane, double across, double along, ref SolverState state,
        ref DepthBounds depth)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        Simplex.Begin(out Simplex simplex);
        Vector3D normal = plane.At(across, along);
        Vector3D w = MinkowskiDifference.Support(ref a, ref b, frame, -normal, ref simplex, 0, out int ids);
        state.Iterations++;
        if (state.Matters<TA, TB>(ids)) state.See(frame, simplex, 0);
        depth.See(normal, Vector3D.Dot(normal, w));
        return new Side(across, along, Vector3D.Dot(plane.Across, w), Vector3D.Dot(plane.Axis, w));
    }

    /// <summary>A direction and the furthest point in it, both in the plane.</summary>
    private readonly struct Side(double x, double y, double pointX, double pointY)
    {
        /// <summary>Of unit length.</summary>
        public readonly double X = x, Y = y;

        public readonly double PointX = pointX, PointY = pointY;

        /// <summary>What the way out in the direction costs.</summary>
        public double Height => X * PointX + Y * PointY;

        /// <summary>The direction across the chord to the next side's point, and the chord's height along it.</summary>
        /// <returns>False where that is not between the two: no direction there is better than both.</returns>
        public bool TryGetChord(in Side next, out double x, out double y, out double height)
        {
            x = next.PointY - PointY;
            y = PointX - next.PointX;
            double squared = x * x + y * y, scale = squared > 0 ? 1 / Math.Sqrt(squared) : 0;
            x *= scale;
            y *= scale;
            height = Math.Min(x * PointX + y * PointY, x * next.PointX + y * next.PointY);
            return X * y - Y * x > 0 && x * next.Y - y * next.X > 0;
        }
    }
}
