namespace Gjk.Core;

/// <summary>How deep two bodies of revolution with parallel axes overlap. Turned about its axis a body is the same, so
/// a way out is shortest when it lies in the plane of both axes, and there the search is one of directions on half a
/// circle.</summary>
/// <remarks>
/// <para>Between two directions A - B lies beyond the chord from the one's support point to the other's. So no
/// direction between them has a shorter way out than the chord's height, or than the two have, and that ends it where
/// this is no less than the shortest way that was found. Otherwise the support point over the chord divides the two
/// into halves. The halves are walked from one end of the half circle to the other, those still to come on a
/// stack.</para>
/// <para>Where the axes lean against each other, all planes through one of them are searched, each for those beside it,
/// too: turned about its own axis, a body is the same, so a point of A - B is followed from plane to plane, and what is
/// left of its movement is small. The chords of the points that follow give the bound; a leaning body's way out is
/// never taken to be in a known plane.</para>
/// <para>The general search (<c>GjkDepth</c>) proves the same with a surface of triangles. About a common axis
/// it needs thousands of them, since all directions around it are equally good.</para>
/// <para>It terminates because a support point lies above its chord by more than the noise, so that a curve of A - B is
/// cut into finitely many pieces, and because supports are counted. Verdicts: Enclosed when the bounds met and Apart as
/// those of the general search; Contradiction when a support was NaN or lay below its chord; Undecided hands over to
/// it, where the shapes touch by rounding or the supports are spent.</para>
/// </remarks>
internal static unsafe class AxialDepth<TA, TB>
    where TA : struct, ISupportMap
    where TB : struct, ISupportMap
{
    /// <summary>Length: what may be left between the bounds. Balls about one centre need a support for every root of
    /// it. Pinned by CoaxialDepthTests.</summary>
    private const double Noise = 1e-7;

    /// <summary>Count: supports at most; balls about one centre need half of it. Pinned by CoaxialDepthTests.</summary>
    public const int MostSupports = 8192;

    /// <summary>Count: supports of a second walk, which sharpens the direction; where all are as good it ends
    /// nothing.</summary>
    private const int MostFiner = 128;

    /// <summary>Pure numbers: how far a shorter way out is looked for at first and at last. Only how many supports it
    /// takes depends on them.</summary>
    private const double FirstStep = 0.25, LastStep = 1e-4;

    /// <summary>Count: pieces still to be walked; each is far shorter than the one under it.</summary>
    private const int MostWaiting = 64;

    /// <summary>Finds the depth; the state gets a feature of negative height, as if the shapes were apart.</summary>
    public static Verdict Solve(ref TA a, ref TB b, in PairFrame frame, in WayOut plane, ref SolverState state)
    {
        int before = state.Iterations;
        DepthBounds depth = DepthBounds.None;
        Verdict verdict = SearchAround(ref a, ref b, frame, plane, ref state, ref depth);
        return End(ref a, ref b, frame, depth, verdict, before, ref state);
    }

    /// <summary>Writes what was found into the state; Undecided hands over.</summary>
    public static Verdict End(
        ref TA a, ref TB b, in PairFrame frame, in DepthBounds depth, Verdict verdict, int before,
        ref SolverState state)
    {
        double band = GjkTolerances.SeparatedBandOf(state.IsCurved) * state.Size.Value + 2 * state.DepthNoise;
        if (verdict == Verdict.Enclosed && !(depth.Upper > band)) verdict = Verdict.Undecided;
        if (verdict == Verdict.Undecided) state.Iterations = before;
        else verdict = depth.StoreWithPoints(ref a, ref b, frame, verdict, ref state);
        return verdict;
    }

    /// <summary>Probes a known direction, or half a circle of them.</summary>
    public static Verdict Probe(
        ref TA a, ref TB b, in PairFrame frame, in WayOut way, int limit, ref SolverState state,
        ref DepthBounds depth) =>
        way.IsDirection ? Probe(ref a, ref b, frame, way, ref state, ref depth)
            : Walk(ref a, ref b, frame, way, 0, Noise, limit, ref state, ref depth);

    /// <summary>Probes one direction, which is known to be the best.</summary>
    private static Verdict Probe(
        ref TA a, ref TB b, in PairFrame frame, in WayOut way, ref SolverState state, ref DepthBounds depth)
    {
        Probe(ref a, ref b, frame, way, 1, 0, ref state, ref depth);
        return depth.VerdictOr(state, Verdict.Enclosed);
    }

    /// <summary>Probes a known direction, or searches the plane. Where the bodies are only nearly coaxial it searches
    /// one plane after the other, all around the axis: each proves those beside it, as far as the slope and the rate at
    /// which its ways out change allow.</summary>
    public static Verdict SearchAround(
        ref TA a, ref TB b, in PairFrame frame, in WayOut way, ref SolverState state, ref DepthBounds depth)
    {
        if (way.IsDirection) return Probe(ref a, ref b, frame, way, ref state, ref depth);
        int limit = state.Iterations + MostSupports;
        Verdict verdict = Walk(ref a, ref b, frame, way, 0, Noise, limit, ref state, ref depth);
        int finest = Math.Min(limit, state.Iterations + MostFiner);
        if (!(way.Slope > 0) && verdict == Verdict.Enclosed)
            Walk(ref a, ref b, frame, way, 0, GjkTolerances.NormalNoise, finest, ref state, ref depth);
        double angle = 0, half = Math.PI / 4, known = double.PositiveInfinity, noise = Noise * state.Size.Value;
        while (way.Slope > 0 && angle < 2 * Math.PI && verdict == Verdict.Enclosed)
        {
            if (depth.Upper < known - noise) Descend(ref a, ref b, frame, way, ref state, ref depth);
            known = depth.Upper;
            WayOut plane = way.Turned(angle + half);
            verdict = Walk(ref a, ref b, frame, plane, half, Noise, limit, ref state, ref depth);
            bool isTooWide = verdict == Verdict.Flat;
            if (isTooWide) verdict = Verdict.Enclosed;
            else angle += 2 * half;
            half = isTooWide ? half / 2 : Math.Min(2 * half, Math.PI / 4);
        }

        return verdict;
    }

    /// <summary>Searches for a shorter way out beside the shortest, around the axis and along it, in ever smaller
    /// steps: the shorter it is, the wider the angle that one plane proves.</summary>
    private static void Descend(
        ref TA a, ref TB b, in PairFrame frame, in WayOut way, ref SolverState state, ref DepthBounds depth)
    {
        for (double step = FirstStep; step > LastStep; step *= 0.5)
        {
            Double3 best = depth.Normal, around = Double3.Cross(way.Axis, best);
            Double3 along = Double3.Cross(best, around);
            for (int i = 0; i < 4; i++)
            {
                Double3 normal = best + (i < 2 ? around : along) * ((i & 1) == 0 ? step : -step);
                normal *= 1 / normal.Length;
                Double3 w = Support(ref a, ref b, frame, normal, ref state, out _);
                depth.TightenUpper(normal, Double3.Dot(normal, w));
            }
        }
    }

    /// <summary>Proves that every way out in a plane is longer than the shortest that was found, by as much as those in
    /// the planes beside it may be shorter.</summary>
    /// <returns>Flat where one is not.</returns>
    private static Verdict Walk(
        ref TA a, ref TB b, in PairFrame frame, in WayOut plane, double half, double noise, int limit,
        ref SolverState state, ref DepthBounds depth)
    {
        AxialSide* waiting = stackalloc AxialSide[MostWaiting];
        AxialSide begin = Probe(ref a, ref b, frame, plane, 0, -1, ref state, ref depth), south = begin;
        waiting[1] = Probe(ref a, ref b, frame, plane, 1, 0, ref state, ref depth);
        waiting[0] = Probe(ref a, ref b, frame, plane, 0, 1, ref state, ref depth);
        if (!(depth.Upper <= double.MaxValue)) return Verdict.Contradiction;
        int count = 2;
        noise *= state.Size.Value;
        double contradiction = GjkTolerances.Contradiction * state.Size.Value;
        while (count > 0)
        {
            if (depth.IsApart(state)) return Verdict.Apart;
            AxialSide end = waiting[count - 1];
            bool isChord = begin.TryGetChord(end, out double x, out double y, out double height);
            bool isProved = half > 0
                ? begin.IsProved(end, half, plane.Slope, depth.Upper - noise)
                : !isChord || height >= depth.Upper - noise;
            if (!isProved)
            {
                if (count == MostWaiting || state.Iterations >= limit) return Verdict.Undecided;
                if (isChord)
                {
                    AxialSide between = Probe(ref a, ref b, frame, plane, x, y, ref state, ref depth);
                    if (!(between.Height - height >= -contradiction)) return Verdict.Contradiction;
                    if (between.Height - height > noise)
                    {
                        waiting[count++] = between;
                        continue;
                    }
                }

                if (half > 0 && !begin.IsProved(end, half, plane.Slope, depth.Upper - 2 * noise))
                    return Verdict.Flat;
            }

            begin = end;
            count--;
        }

        bool isAlong = south.IsHigh(half, plane.Slope, depth.Upper - noise)
            && begin.IsHigh(half, plane.Slope, depth.Upper - noise);
        return isAlong ? Verdict.Enclosed : Verdict.Flat;
    }

    private static AxialSide Probe(
        ref TA a, ref TB b, in PairFrame frame, in WayOut plane, double across, double along, ref SolverState state,
        ref DepthBounds depth)
    {
        Double3 normal = plane.At(across, along);
        Double3 w = Support(ref a, ref b, frame, normal, ref state, out DifferenceVertex vertex);
        depth.TightenUpper(normal, Double3.Dot(normal, w));
        Double3 moved = default, bent = default;
        if (plane.Slope > 0)
        {
            plane.Follow(vertex.OnA, frame.Rotation.Rotate(vertex.OnB), frame.Translation, out moved, out bent);
        }

        return new AxialSide(plane, across, along, w, moved, bent);
    }

    /// <summary>The furthest point of A - B in a direction, which is counted.</summary>
    public static Double3 Support(
        ref TA a, ref TB b, in PairFrame frame, in Double3 normal, ref SolverState state,
        out DifferenceVertex vertex)
    {
        UnsafeRef.SkipInit(out vertex);
        int ids = MinkowskiDifference.Support(ref a, ref b, frame, -normal, ref vertex, out Double3 w);
        state.Iterations++;
        if (state.ChangesTolerances<TA, TB>(ids)) state.Observe(frame, vertex);
        return w;
    }
}

/// <summary>A direction in a plane of <c>AxialDepth</c> and the furthest point in it, and how that moves as the
/// plane turns.</summary>
internal readonly struct AxialSide(
    in WayOut plane, double x, double y, in Double3 point, in Double3 moved, in Double3 bent)
{
    /// <summary>The direction, of unit length.</summary>
    public readonly double X = x, Y = y;

    /// <summary>The point.</summary>
    public readonly double PointX = Double3.Dot(plane.Across, point), PointY = Double3.Dot(plane.Axis, point);

    /// <summary>How the point moves as the plane turns: the first derivative and the second.</summary>
    private readonly double _movedX = Double3.Dot(plane.Across, moved), _movedY = Double3.Dot(plane.Axis, moved),
        _bentX = Double3.Dot(plane.Across, bent), _bentY = Double3.Dot(plane.Axis, bent);

    /// <summary>What the way out in the direction costs.</summary>
    public double Height => X * PointX + Y * PointY;

    /// <summary>Whether no way out across the line through two points is shorter than that, in this plane and in those
    /// that are turned against it by up to an angle.</summary>
    /// <remarks>The furthest of points that follow each other around the axis is least across one of the lines between
    /// them. As planes turn, the points p + δ v and q + δ u (<see cref="WayOut.Follow"/>) span a line that is p × q /
    /// |q - p| from the origin, of which the product is a polynomial and the length no more than one.</remarks>
    /// <param name="next">The side at the other end.</param>
    /// <param name="half">The angle.</param>
    /// <param name="slope">How fast a way out changes at most.</param>
    /// <param name="least">How long.</param>
    public bool IsProved(in AxialSide next, double half, double slope, double least)
    {
        double dx = next.PointX - PointX, dy = next.PointY - PointY, length = Math.Sqrt(dx * dx + dy * dy);
        if (length == 0) return true;
        double ux = next._movedX - _movedX, uy = next._movedY - _movedY, moved = Math.Sqrt(ux * ux + uy * uy);
        least += Rest(next, half, slope, moved / length);
        double over = PointX * next.PointY - PointY * next.PointX - least * length;
        double first = PointX * next._movedY - PointY * next._movedX + _movedX * next.PointY
            - _movedY * next.PointX - least * (dx * ux + dy * uy) / length;
        double second = _movedX * next._movedY - _movedY * next._movedX - least * 0.5 * moved * moved / length;
        return over >= half * (Math.Abs(first) + half * Math.Abs(second));
    }

    /// <summary>Whether the way out in the direction is no shorter than that, in all these planes.</summary>
    public bool IsHigh(double half, double slope, double least) =>
        Height - half * Math.Abs(X * _movedX + Y * _movedY) >= least + Rest(this, half, slope, 0);

    /// <summary>What the second and the third term of the points' movement can take from a way out between two
    /// directions, and as far beside them as these turn. A unit vector between them is a sum of both with weights of up
    /// to one over the cosine of half their angle.</summary>
    private double Rest(in AxialSide next, double half, double slope, double turn)
    {
        double scale = 0.5 / Math.Sqrt(Math.Max(0.5 + 0.5 * (X * next.X + Y * next.Y), 0));
        double bent = Math.Max(Bent(next), next.Bent(this)) * scale;
        return half * half * Math.Min(slope, bent + slope * half * (2.0 / 3 + turn));
    }

    /// <summary>The second derivative of the way out to this point, in this direction or the other one.</summary>
    private double Bent(in AxialSide other) =>
        Math.Max(Math.Abs(X * _bentX + Y * _bentY), Math.Abs(other.X * _bentX + other.Y * _bentY));

    /// <summary>The direction across the chord to the next side's point, and the chord's height along it.</summary>
    /// <returns>False where that is not between the two: no direction there is better than both.</returns>
    public bool TryGetChord(in AxialSide next, out double x, out double y, out double height)
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
