namespace Gjk.Core;

/// <summary>How deep two cores overlap: the shortest way for the origin out of the Minkowski difference A - B, by an
/// expanding polytope (van den Bergen 2001).</summary>
/// <remarks>
/// <para>The surface of a tetrahedron of A - B grows by support points, always over its lowest face, the one of least
/// signed offset from the origin. Two bounds end it. The surface is closed, so a ball as large as the lowest face's
/// height is inside A - B: no way out is shorter. And the support point over that face says what the way out along its
/// normal costs. Where the two meet, that is the depth.</para>
/// <para>Two things differ from the source. The tetrahedron need not hold the origin, so no other query comes first:
/// signed offsets lead the surface over the origin, or to a plane that separates the shapes. And a face's height is the
/// least of its three vertices' offsets (<see cref="Polytope"/>), so a normal that rounding has turned weakens the
/// bound and never the proof; such a normal is computed again in extended precision.</para>
/// <para>It terminates because each new vertex lies above the surface by more than the noise, and there is room for a
/// fixed number. Of several ways that are equally short the one whose face is finished first is taken; no hardware and
/// no thread changes which that is.</para>
/// <para>Verdicts. Enclosed: both bounds met. Apart: a plane separates the shapes by more than rounding could.
/// Undecided: there was no room, and the bounds are what was found. Flat: A - B has no inside, so the depth is 0 if
/// they touch. Contradiction: a support point was NaN, or lay behind one that the same support had given before.</para>
/// </remarks>
internal static unsafe class GjkDepth<TA, TB, TTrace>
    where TA : struct, ISupportMap
    where TB : struct, ISupportMap
    where TTrace : struct, IPolytopeTrace
{
    /// <summary>Finds the depth; the state gets a feature of negative height, as if the shapes were apart.</summary>
    /// <remarks>Its stack is given back when it returns.</remarks>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static Verdict Solve(ref TA a, ref TB b, in PairFrame frame, ref SolverState state, ref TTrace trace)
    {
        double* memory = stackalloc double[Polytope.FirstDoubles];
        var polytope = new Polytope(memory, isFirst: true);
        DepthBounds depth = DepthBounds.None;
        Verdict verdict = PolytopeStart<TA, TB>.Build(ref a, ref b, frame, ref state, ref polytope, ref depth);
        bool isFiner = false;
        if (verdict == Verdict.Undecided)
            return Expand(ref a, ref b, frame, ref state, ref polytope, ref depth, ref isFiner, ref trace);
        TraceStep(OutcomeOf(verdict), frame, polytope, -1, depth, ref trace);
        depth.Store(ref state, depth.Upper);
        return verdict;
    }

    /// <summary>The rest of a search that has outgrown its first room.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static Verdict ExpandFurther(
        ref TA a, ref TB b, in PairFrame frame, ref SolverState state, ref Polytope polytope, ref DepthBounds depth,
        ref bool isFiner, ref TTrace trace)
    {
        double* memory = stackalloc double[Polytope.Doubles];
        polytope.Grow(memory);
        return Expand(ref a, ref b, frame, ref state, ref polytope, ref depth, ref isFiner, ref trace);
    }

    /// <summary>Grows the surface until the bounds meet; of curved cores twice: to the promise of the depth, and where
    /// the way out does not end on a smooth point, to that of its direction.</summary>
    private static Verdict Expand(
        ref TA a, ref TB b, in PairFrame frame, ref SolverState state, ref Polytope polytope, ref DepthBounds depth,
        ref bool isFiner, ref TTrace trace)
    {
        int face = 0;
        bool isClosed = true;
        while (isClosed && polytope.HasRoom)
        {
            face = polytope.Lowest(out double key);
            ref readonly Double3 normal = ref polytope.Face(face).Normal;
            double scale = 1 / Math.Sqrt(polytope.Face(face).NormalSquared);

            // Supports in float make faces without area there; the state has the end where the bounds met before.
            if (isFiner && !(scale <= double.MaxValue)) return Verdict.Enclosed;
            double lowest = polytope.Face(face).Offset * scale;
            depth.Lower = Math.Max(depth.Lower, lowest);
            int vertex = PolytopeStart<TA, TB>.Support(ref a, ref b, frame, normal, ref state, ref polytope);
            double height = Double3.Dot(normal, polytope.Vertex(vertex).W) * scale, gap = height - lowest;
            if (height < depth.Upper) (depth.Normal, depth.Upper) = (normal * scale, height);
            if (depth.IsApart(state))
            {
                TraceStep(PolytopeOutcome.Apart, frame, polytope, face, depth, ref trace);
                depth.Store(ref state, depth.Upper);
                return Verdict.Apart;
            }

            if (!(gap >= -GjkTolerances.Contradiction * state.Size.Value))
            {
                if (isFiner) return Verdict.Enclosed;
                TraceStep(PolytopeOutcome.Contradiction, frame, polytope, face, depth, ref trace);
                return Verdict.Contradiction;
            }

            double finest = GjkTolerances.NormalNoise * state.Size.Value;
            bool hasMet = gap <= (isFiner ? finest : state.DepthNoise);
            if (hasMet || (depth.Upper - depth.Lower <= RepeatedGap(frame, state, depth) && polytope.Repeats(vertex)))
            {
                TraceStep(PolytopeOutcome.BoundsMet, frame, polytope, face, depth, ref trace);
                if (hasMet) (depth.Normal, depth.Upper) = (normal * scale, height);
                Settle(ref state, polytope, face, depth, depth.Upper);
                bool isFinest = !state.IsCurved || isFiner || gap <= finest;
                if (isFinest || SmoothNormal<TA, TB>.TryEnd(ref a, ref b, frame, depth, ref state))
                    return Verdict.Enclosed;
                isFiner = true;
            }

            TraceStep(PolytopeOutcome.Grows, frame, polytope, face, depth, ref trace);
            isClosed = polytope.TryExpand(face, vertex, lowest > 0 ? key : double.NegativeInfinity);
        }

        if (isClosed && polytope.CanGrow)
            return ExpandFurther(ref a, ref b, frame, ref state, ref polytope, ref depth, ref isFiner, ref trace);

        // Where the bounds have met before, the state has that end.
        if (isFiner) return Verdict.Enclosed;
        TraceStep(PolytopeOutcome.OutOfRoom, frame, polytope, -1, depth, ref trace);
        Settle(ref state, polytope, face, depth, Math.Max(depth.Lower, 0));
        return Verdict.Undecided;
    }

    /// <summary>Length: a point that the surface has already lies above a face by rounding alone, as between faces that
    /// are level or vertices that nearly coincide. It cannot grow the surface, and bounds that are no further apart
    /// than this are within the promise.</summary>
    private static double RepeatedGap(in PairFrame frame, in SolverState state, in DepthBounds depth) =>
        GjkTolerances.RepeatedGap * (depth.Upper + frame.Margins) + 4 * state.DepthNoise;

    /// <summary>Puts the face that holds the cheapest way out's end into the state.</summary>
    private static void Settle(
        ref SolverState state, in Polytope polytope, int face, in DepthBounds depth, double length)
    {
        face = PolytopeEnd.FaceUnder(polytope, face, depth.Normal, depth.Upper, state.DepthNoise);
        PolytopeEnd.Copy(polytope, face, ref state.Simplex);
        depth.Store(ref state, length);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void TraceStep(
        PolytopeOutcome outcome, in PairFrame frame, in Polytope polytope, int face, in DepthBounds depth,
        ref TTrace trace)
    {
        if (trace.IsOn) trace.OnStep(new PolytopeStep(frame, polytope, face, outcome, depth.Lower, depth.Upper));
    }

    /// <summary>How a search without a surface ended.</summary>
    private static PolytopeOutcome OutcomeOf(Verdict verdict) =>
        verdict == Verdict.Apart ? PolytopeOutcome.Apart
        : verdict == Verdict.Flat ? PolytopeOutcome.Flat : PolytopeOutcome.Contradiction;
}

/// <summary>What an expanded polytope says about the end of the way out.</summary>
internal static class PolytopeEnd
{
    /// <summary>The face that holds a point of the surface: where the way out ends, or the one that is nearest to it.
    /// Any may be: those of a facet are turned against each other where needles are among them, and where margins are
    /// deep and a core is thinner than they are rounded by, both of its sides cost the same.</summary>
    /// <param name="polytope">The surface.</param>
    /// <param name="best">A face in the plane of the facet, or near it.</param>
    /// <param name="normal">The direction of the way out, of unit length.</param>
    /// <param name="height">Its length.</param>
    /// <param name="noise">Length: what rounding leaves open.</param>
    public static int FaceUnder(in Polytope polytope, int best, in Double3 normal, double height, double noise)
    {
        Double3 point = normal * height;
        double least = DistanceSquared(polytope, best, point);
        for (int i = 0; i < polytope.FaceCount && least > noise * noise; i++)
        {
            if (!polytope.IsLive(i)) continue;
            double squared = DistanceSquared(polytope, i, point);
            if (!(squared < least)) continue;
            least = squared;
            best = i;
        }

        return best;
    }

    /// <summary>Makes a simplex of a face's vertices.</summary>
    public static unsafe void Copy(in Polytope polytope, int face, ref Simplex simplex)
    {
        for (int k = 0; k < 3; k++) simplex.At(k) = polytope.Vertex(polytope.Face(face).Vertices[k]);
        simplex.Select(3, 0, 1, 2, 0);
    }

    /// <summary>From the point to the face, squared.</summary>
    private static unsafe double DistanceSquared(in Polytope polytope, int face, in Double3 point)
    {
        ref PolytopeFace f = ref polytope.Face(face);
        Double3 p = polytope.Vertex(f.Vertices[0]).W - point, q = polytope.Vertex(f.Vertices[1]).W - point;
        Double3 r = polytope.Vertex(f.Vertices[2]).W - point;
        return ClosestPointWeights.Triangle(p, q, r).PointOf(p, q, r, default).LengthSquared;
    }
}
