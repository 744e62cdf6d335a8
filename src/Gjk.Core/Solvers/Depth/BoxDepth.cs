namespace Gjk.Core;

/// <summary>How deep two boxes overlap, by separating axes (Gottschalk, Lin and Manocha 1996): the shortest way out is
/// across a face of A, across a face of B, or across an edge of each.</summary>
/// <remarks>
/// <para>The Minkowski difference of two boxes has no other facets, so the least of 15 costs is the depth; nothing is
/// walked. A cost is what is left of both extents along an axis when the centres' distance along it is taken away. It
/// is computed from the axis as it is, with no use of what its products should be: so an axis that rounding has turned
/// still is a way out that costs what is computed, and nearly parallel edges need no tolerance. Only edges that are
/// parallel to the last bit have no axis.</para>
/// <para>Two things differ from the source. Edges are compared without a root: the square of the cost, with its sign,
/// and the squared length of the axis. And faces come first: an edge pair is taken only where it is cheaper by more
/// than rounding, so that a resting box keeps its face. Of equal faces the first is taken, A's before B's, x before y
/// before z; where the centres are level along an axis, its positive direction.</para>
/// <para>Verdicts: Enclosed, or Apart when an axis separates the boxes by more than rounding could.</para>
/// </remarks>
internal static unsafe class BoxDepth
{
    /// <summary>Finds the depth; the state gets the deepest points as a simplex of one vertex without ids.</summary>
    /// <param name="halfA">Half of A's sides.</param>
    /// <param name="halfB">Half of B's sides.</param>
    /// <param name="frame">Of the pair.</param>
    /// <param name="state">With the size.</param>
    public static Verdict Solve(in Double3 halfA, in Double3 halfB, in PairFrame frame, ref SolverState state)
    {
        double* costs = stackalloc double[BoxAxes.Lanes], squares = stackalloc double[BoxAxes.Lanes];
        BoxAxes.Find(halfA, halfB, frame, costs, squares);
        double noise = GjkTolerances.Noise * state.Size.Value, scale = 1;
        int best = BoxAxes.LeastFace(costs, noise);
        double above = costs[best];
        int below = BoxAxes.EdgesBelow(costs, squares, above - noise);
        for (int i = BoxAxes.Edges; below >> i != 0; i++)
        {
            double limit = above - noise;
            if ((below >> i & 1) == 0 || !BoxAxes.IsBelow(costs[i], squares[i], limit * Math.Abs(limit))) continue;
            scale = 1 / Math.Sqrt(squares[i]);
            above = costs[i] * scale;
            best = i;
        }

        var pair = new BoxPair(halfA, halfB, frame, BoxAxes.AxisOf(best));
        var depth = new DepthBounds(pair.Outward * scale, above, 0);
        depth.Store(ref state, above);
        if (depth.IsApart(state)) return Verdict.Apart;
        BoxDepthPoints.Find(pair, depth, state.Size.Value, out Double3 onA, out Double3 inB);
        state.Simplex.Fill(0, depth.Normal * above, onA, inB, -1, -1);
        state.Simplex.Select(1, 0, 0, 0, 0);
        return Verdict.Enclosed;
    }
}

/// <summary>Two boxes in A's frame, from A's centre, and the axis across which they are nearest to apart.</summary>
internal readonly struct BoxPair(in Double3 halfA, in Double3 halfB, in PairFrame frame, int axis)
{
    /// <summary>Count of the axes across faces, A's and then B's.</summary>
    public const int Faces = 6;

    /// <summary>Half the side lengths.</summary>
    public readonly Double3 HalfA = halfA, HalfB = halfB;

    /// <summary>B's axes.</summary>
    public readonly Double3 X = new(frame.Rotation.M00, frame.Rotation.M10, frame.Rotation.M20),
        Y = new(frame.Rotation.M01, frame.Rotation.M11, frame.Rotation.M21),
        Z = new(frame.Rotation.M02, frame.Rotation.M12, frame.Rotation.M22);

    /// <summary>B's centre.</summary>
    public readonly Double3 Between = frame.Translation;

    /// <summary>The axis's number: across A's faces, across B's, and then across A's first edge and each of
    /// B's.</summary>
    public readonly int Axis = axis;

    /// <summary>One of B's axes.</summary>
    public Double3 AxisOfB(int index) => index == 0 ? X : index == 1 ? Y : Z;

    /// <summary>A direction in B's axes.</summary>
    public Double3 ToB(in Double3 v) => new(Double3.Dot(X, v), Double3.Dot(Y, v), Double3.Dot(Z, v));

    /// <summary>Along which of A's axes the edge of the axis lies.</summary>
    public int EdgeOfA => (Axis - Faces) / 3;

    /// <summary>Along which of B's axes the edge of the axis lies.</summary>
    public int EdgeOfB => (Axis - Faces) % 3;

    /// <summary>The axis, turned to the side of B; of unit length across a face, and of any across edges.</summary>
    public Double3 Outward
    {
        get
        {
            Double3 axis = Axis < 3 ? Unit(Axis) : Axis < Faces ? AxisOfB(Axis - 3) : AcrossEdges;
            return Double3.Dot(axis, Between) < 0 ? -axis : axis;
        }
    }

    /// <summary>Perpendicular to A's edge without rounding.</summary>
    private Double3 AcrossEdges
    {
        get
        {
            Double3 b = AxisOfB(EdgeOfB);
            return EdgeOfA switch
            {
                0 => new Double3(0, -b.Z, b.Y),
                1 => new Double3(b.Z, 0, -b.X),
                _ => new Double3(-b.Y, b.X, 0),
            };
        }
    }

    /// <summary>One of A's axes.</summary>
    public static Double3 Unit(int index) =>
        index == 0 ? new Double3(1, 0, 0) : index == 1 ? new Double3(0, 1, 0) : new Double3(0, 0, 1);
}
