namespace Gjk.Core;

/// <summary>How deep a body lies that is well inside a cylinder: the shortest way out is along the cylinder's axis or
/// across it. So two supports and a circle of directions tell it, where the general search (<c>GjkDepth</c>)
/// would have to prove all directions.</summary>
/// <remarks>
/// <para>About the body lies a ball of radius r. From its centre it is p to an end of the cylinder and q to the side.
/// A way out that leans by t from the axis costs p cos t + q sin t, and what the body adds. That changes by no more
/// than r times the chord between two directions. So the way along the axis is no longer while q cos(t/2) - p sin(t/2)
/// is at least r, and the one across it while p cos(s/2) - q sin(s/2) is, with s = 90° - t. Both angles together are a
/// right one where p and q are at least r, and the root of p² + q² at least r / sin(22.5°).</para>
/// <para>Across the axis the body is a flat figure, and the way out is the cylinder's radius less the figure's distance
/// from the axis: two points of it and a support give both bounds of that. Where the axis meets the figure, two half
/// circles are searched like that of a pin in its hole (<c>AxialDepth</c>). Verdicts as there; Undecided also
/// where the body is not well inside.</para>
/// </remarks>
internal static class CylinderDepth<TA, TB>
    where TA : struct, ISupportMap
    where TB : struct, ISupportMap
{
    /// <summary>Ratio: one over the square of the sine of 22.5 degrees, rounded up. Pinned by
    /// CylinderDepthTests.</summary>
    private const double WellInside = 6.8285;

    /// <summary>Finds the depth; the state gets a feature of negative height, as if the shapes were apart.</summary>
    public static Verdict Solve(ref TA a, ref TB b, in PairFrame frame, in PairForm form, ref SolverState state)
    {
        double radiusA = frame.RadiusA - frame.MarginA, radiusB = frame.RadiusB - frame.MarginB;
        bool isA = radiusA > radiusB;
        ref readonly BodyForm body = ref (isA ? ref form.A : ref form.B);
        if (!body.IsCylinder) return Verdict.Undecided;
        Double3 axis = body.Axis * (1 / body.Axis.Length), aside = new PlaneBasis(axis).U;
        double end = isA ? Reach(ref a, axis) : Reach(ref b, axis), ball = isA ? radiusB : radiusA;
        double side = isA ? Reach(ref a, aside) : Reach(ref b, aside);
        if (!isA) axis = frame.Rotation.Rotate(axis);
        end -= Math.Abs(Double3.Dot(axis, frame.Translation));
        double room = side - Double3.Cross(axis, frame.Translation).Length;
        if (!(end >= ball && room >= ball && end * end + room * room >= WellInside * ball * ball))
            return Verdict.Undecided;
        DepthBounds depth = DepthBounds.None;
        int before = state.Iterations;
        AxialDepth<TA, TB>.SearchAround(ref a, ref b, frame, WayOut.In(axis), ref state, ref depth);
        Verdict verdict = AxialDepth<TA, TB>.SearchAround(ref a, ref b, frame, WayOut.In(-axis), ref state, ref depth);
        WayOut around = WayOut.Along(axis, frame.Translation, 0, default, default);
        if (depth.Upper > room && !TryAcross(ref a, ref b, frame, around, side, ref state, ref depth))
        {
            for (int half = -1; half <= 1 && verdict == Verdict.Enclosed; half += 2)
            {
                Double3 across = around.Across * half;
                var way = WayOut.Along(Double3.Cross(axis, across), across, 0, default, default);
                verdict = AxialDepth<TA, TB>.SearchAround(ref a, ref b, frame, way, ref state, ref depth);
            }
        }

        return AxialDepth<TA, TB>.End(ref a, ref b, frame, depth, verdict, before, ref state);
    }

    /// <summary>Looks for the way out across the axis where the body is beside that: the distance of a flat figure from
    /// a point (Gilbert, Johnson and Keerthi) by the nearer of two edges at each new corner. It ends, since each
    /// is nearer than the last; none is where the axis is inside, or where rounding ends it.</summary>
    private static bool TryAcross(
        ref TA a, ref TB b, in PairFrame frame, in WayOut around, double side, ref SolverState state,
        ref DepthBounds depth)
    {
        Double3 axis = around.Axis, nearest = around.Across * Double3.Dot(around.Across, frame.Translation);
        Double3 first = nearest, second = nearest;
        double size = state.Size.Value, known = double.PositiveInfinity, length = nearest.Length;
        for (int corners = 0; corners < GjkTolerances.MaxIterations; corners++)
        {
            if (!(length < known && length > GjkTolerances.DepthNoiseCurved * size)) return false;
            Double3 normal = nearest * (1 / length);
            Double3 w = AxialDepth<TA, TB>.Support(ref a, ref b, frame, normal, ref state, out _);
            depth.TightenUpper(normal, Double3.Dot(normal, w));

            // What rounding leaves along the axis would grow from corner to corner.
            Double3 corner = normal * side - w;
            corner -= axis * Double3.Dot(axis, corner);
            if (length - Double3.Dot(normal, corner) <= GjkTolerances.NormalNoise * size) return true;
            Double3 onFirst = Nearest(corner, first), onSecond = Nearest(corner, second);
            bool isFirst = onFirst.LengthSquared <= onSecond.LengthSquared;
            nearest = isFirst ? onFirst : onSecond;
            if (!isFirst) first = second;
            second = corner;
            known = length;
            length = nearest.Length;
        }

        return false;
    }

    /// <summary>The point of a segment that is nearest to the origin.</summary>
    private static Double3 Nearest(in Double3 from, in Double3 to)
    {
        Double3 along = to - from;
        double squared = along.LengthSquared, part = squared > 0 ? -Double3.Dot(from, along) / squared : 0;
        return from + along * Math.Max(0, Math.Min(1, part));
    }

    private static double Reach<T>(ref T shape, in Double3 direction)
        where T : struct, ISupportMap
    {
        shape.Support(direction, out Double3 point);
        return Double3.Dot(direction, point);
    }
}
