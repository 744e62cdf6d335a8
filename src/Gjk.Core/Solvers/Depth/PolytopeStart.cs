namespace Gjk.Core;

/// <summary>The tetrahedron that an expanding polytope grows from: support points of A - B in four directions, the
/// first along the line through the centres; or the triangle that a warm start remembers, and one point more.</summary>
/// <remarks>Each point is looked for on both sides of what there is, the side of the origin first. Where A - B has less
/// extent than rounding leaves certain, it is flat, and the cheapest direction seen on the way is across it.</remarks>
internal static unsafe class PolytopeStart<TA, TB>
    where TA : struct, ISupportMap
    where TB : struct, ISupportMap
{
    /// <summary>Makes the surface a tetrahedron, and notes what the directions cost.</summary>
    /// <returns>Undecided, Flat, Apart or Contradiction.</returns>
    public static Verdict Build(
        ref TA a, ref TB b, in PairFrame frame, ref SolverState state, ref Polytope polytope, ref DepthBounds depth)
    {
        if (!TryRemember(state, ref polytope))
        {
            Double3 toB = -state.Feature.Normal;
            if (!TryPair(ref a, ref b, frame, toB, ref state, ref polytope, ref depth)
                && !TryPair(ref a, ref b, frame, new Double3(1, 0, 0), ref state, ref polytope, ref depth)
                && !TryPair(ref a, ref b, frame, new Double3(0, 1, 0), ref state, ref polytope, ref depth)
                && !TryPair(ref a, ref b, frame, new Double3(0, 0, 1), ref state, ref polytope, ref depth))
                return depth.VerdictOr(state, Verdict.Flat);

            if (depth.IsApart(state)) return Verdict.Apart;
            Double3 p = polytope.Vertex(0).W, along = polytope.Vertex(1).W - p;
            Double3 toOrigin = along * (Double3.Dot(p, along) / along.LengthSquared) - p;
            Double3 across = Across(along, toOrigin);
            if (!TryAdd(ref a, ref b, frame, across, ref state, ref polytope, ref depth)
                && !TryAdd(ref a, ref b, frame, Double3.Cross(along, across), ref state, ref polytope, ref depth))
                return depth.VerdictOr(state, Verdict.Flat);

            if (depth.IsApart(state)) return Verdict.Apart;
        }

        Double3 corner = polytope.Vertex(0).W;
        Double3 normal = Normal(corner, polytope.Vertex(1).W, polytope.Vertex(2).W, state);
        if (Double3.Dot(normal, corner) > 0) normal = -normal;
        if (!TryAdd(ref a, ref b, frame, normal, ref state, ref polytope, ref depth))
            return depth.VerdictOr(state, Verdict.Flat);
        if (depth.IsApart(state)) return Verdict.Apart;
        double size = state.Size.Value;
        return polytope.TrySetTetrahedron(GjkTolerances.Noise * size, GjkTolerances.DepthLevel * size)
            ? Verdict.Undecided
            : depth.VerdictOr(state, Verdict.Flat);
    }

    /// <summary>Adds the point of A - B that is furthest in a direction; returns its index.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int Support(
        ref TA a, ref TB b, in PairFrame frame, in Double3 direction, ref SolverState state, ref Polytope polytope)
    {
        state.Iterations++;
        DifferenceVertex* vertex = polytope.Add(out int added);
        int ids = MinkowskiDifference.Support(ref a, ref b, frame, -direction, ref *vertex, out _);
        if (state.ChangesTolerances<TA, TB>(ids)) state.Observe(frame, *vertex);
        return added;
    }

    /// <summary>The triangle of the simplex, unless it is a needle.</summary>
    private static bool TryRemember(in SolverState state, ref Polytope polytope)
    {
        if (state.Simplex.Count < 3) return false;
        Double3 p = state.Simplex.WA, e = state.Simplex.WB - p, f = state.Simplex.WC - p;
        double area = Double3.Cross(e, f).LengthSquared;
        if (!(area > ClosestPointWeights.Needle * e.LengthSquared * f.LengthSquared)) return false;
        double flat = Flat(state);
        if (!(area > flat * flat * Math.Max(e.LengthSquared, f.LengthSquared))) return false;
        polytope.Add(state.Simplex, state.Simplex.A);
        polytope.Add(state.Simplex, state.Simplex.B);
        polytope.Add(state.Simplex, state.Simplex.C);
        return true;
    }

    /// <summary>The two points that are furthest apart along a direction.</summary>
    private static bool TryPair(
        ref TA a, ref TB b, in PairFrame frame, in Double3 direction, ref SolverState state, ref Polytope polytope,
        ref DepthBounds depth)
    {
        Double3 unit = direction * (1 / direction.Length);
        int first = See(ref a, ref b, frame, unit, ref state, ref polytope, ref depth);
        int second = See(ref a, ref b, frame, -unit, ref state, ref polytope, ref depth);
        double flat = Flat(state);
        if ((polytope.Vertex(first).W - polytope.Vertex(second).W).LengthSquared > flat * flat) return true;
        polytope.DropLast();
        polytope.DropLast();
        return false;
    }

    /// <summary>The furthest point in a direction, or against it, that is not level with the first point.</summary>
    private static bool TryAdd(
        ref TA a, ref TB b, in PairFrame frame, in Double3 direction, ref SolverState state, ref Polytope polytope,
        ref DepthBounds depth)
    {
        Double3 unit = direction * (1 / direction.Length);
        for (int side = 0; side < 2; side++, unit = -unit)
        {
            int added = See(ref a, ref b, frame, unit, ref state, ref polytope, ref depth);
            double level = Double3.Dot(unit, polytope.Vertex(0).W);
            if (Double3.Dot(unit, polytope.Vertex(added).W) - level > Flat(state)) return true;
            polytope.DropLast();
        }

        return false;
    }

    private static int See(
        ref TA a, ref TB b, in PairFrame frame, in Double3 unit, ref SolverState state, ref Polytope polytope,
        ref DepthBounds depth)
    {
        int added = Support(ref a, ref b, frame, unit, ref state, ref polytope);
        depth.TightenUpper(unit, Double3.Dot(unit, polytope.Vertex(added).W));
        return added;
    }

    /// <summary>A direction across a line: towards the origin, or any where the line passes through it.</summary>
    private static Double3 Across(in Double3 along, in Double3 toOrigin)
    {
        if (toOrigin.LengthSquared > ClosestPointWeights.Needle * along.LengthSquared) return toOrigin;
        double x = Math.Abs(along.X), y = Math.Abs(along.Y), z = Math.Abs(along.Z);
        Double3 axis = x <= y && x <= z ? new Double3(1, 0, 0)
            : y <= z ? new Double3(0, 1, 0) : new Double3(0, 0, 1);
        return Double3.Cross(along, axis);
    }

    /// <summary>The normal of a triangle; of a needle, which double would lean along its length, in 106 bits. Leaning,
    /// it would find the needle's own far corner above the triangle, and call its height the depth of what is
    /// flat.</summary>
    private static Double3 Normal(in Double3 p, in Double3 q, in Double3 r, in SolverState state)
    {
        Double3 e = q - p, f = r - p, normal = Double3.Cross(e, f);
        double level = GjkTolerances.DepthLevel * state.Size.Value * normal.Length;
        bool isLevel = Math.Abs(Double3.Dot(normal, e)) <= level && Math.Abs(Double3.Dot(normal, f)) <= level;
        return isLevel ? normal : VectorDD.Normal(p, q, r);
    }

    /// <summary>Length: what is thinner is flat.</summary>
    private static double Flat(in SolverState state) => GjkTolerances.Flat * state.Size.Value;
}
