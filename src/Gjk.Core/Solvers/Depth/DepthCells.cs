namespace Gjk.Core;

/// <summary>Ends a search for a depth whose surface has outgrown its room: the directions are divided into cells, and
/// the depth is proved in each, one after the other.</summary>
/// <remarks>
/// <para>Where shapes are nearly round and lie about one centre, all ways out are nearly equally long, and each must be
/// proved to be no shorter than the shortest that was found. A closed surface of so many faces needs memory for all of
/// them; a cell (<see cref="Polytope.TryCut"/>) only for its own. A cell that outgrows the room is halved: one half
/// keeps its part of the surface, the other begins anew later. Nothing is kept of a cell that is proved but the
/// shortest way out.</para>
/// <para>The cells form a binary tree that is walked depth first. The cuts are the path, and one bit for each says
/// whether its second half is being walked. As deep as the tree has been before, a cell is halved while it is small,
/// since it can be expected to outgrow the room again, and what it knows of the other half is lost.</para>
/// <para>It terminates because supports are counted. Verdicts: Enclosed, Apart and Contradiction as those of
/// <c>GjkDepth</c>; Undecided when the supports are spent, or there was no room.</para>
/// </remarks>
internal static unsafe class DepthCells<TA, TB>
    where TA : struct, ISupportMap
    where TB : struct, ISupportMap
{
    /// <summary>Count: supports after which the bounds are given as they are; about two milliseconds. Pinned by
    /// HullDepthTests.</summary>
    private const int MostSupports = 3072;

    /// <summary>Count: vertices at which a cell is halved that will not fit: enough to see where its low faces are, and
    /// few to ask for twice. Only time depends on it.</summary>
    private const int EarlyVertices = 32;

    /// <summary>Finds the depth from what the general search has left in the state.</summary>
    public static Verdict Solve(ref TA a, ref TB b, in PairFrame frame, ref SolverState state)
    {
        var depth = DepthBounds.FromState(state);
        Verdict verdict = Search(ref a, ref b, frame, ref state, ref depth);
        return depth.StoreWithPoints(ref a, ref b, frame, verdict, ref state);
    }

    /// <summary>Its stack is given back when it returns.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static Verdict Search(ref TA a, ref TB b, in PairFrame frame, ref SolverState state, ref DepthBounds depth)
    {
        double* memory = stackalloc double[Polytope.Doubles];
        var polytope = new Polytope(memory);
        Verdict verdict = PolytopeStart<TA, TB>.Build(ref a, ref b, frame, ref state, ref polytope, ref depth);
        return verdict == Verdict.Undecided
            ? Walk(ref a, ref b, frame, ref state, ref polytope, ref depth)
            : verdict;
    }

    private static Verdict Walk(
        ref TA a, ref TB b, in PairFrame frame, ref SolverState state, ref Polytope polytope, ref DepthBounds depth)
    {
        ulong crossed = 0;
        int deepest = 0, limit = state.Iterations + MostSupports;
        while (true)
        {
            double noise = CellNoise(state), proved = depth.Upper - noise;
            int face = polytope.Lowest(out _);
            double lowest = polytope.Face(face).Height;
            if (lowest >= proved)
            {
                int cut = polytope.CutCount - 1;
                while (cut >= 0 && (crossed >> cut & 1) != 0) cut--;
                if (cut < 0) return Verdict.Enclosed;
                crossed = (crossed | 1UL << cut) & ~(~0UL << cut << 1);
                if (!polytope.TryCross(cut)) return Verdict.Undecided;
                continue;
            }

            if (!polytope.HasRoom || (polytope.CutCount < deepest && polytope.VertexCount >= EarlyVertices))
            {
                if (polytope.CutCount == Polytope.MostCuts) return Verdict.Undecided;
                if (!polytope.TryCut(polytope.BisectingCut(proved))) return Verdict.Undecided;
                deepest = Math.Max(deepest, polytope.CutCount);
                continue;
            }

            if (state.Iterations >= limit) return Verdict.Undecided;
            Double3 normal = polytope.Face(face).UnitNormal;
            int vertex = PolytopeStart<TA, TB>.Support(ref a, ref b, frame, normal, ref state, ref polytope);
            double height = Double3.Dot(normal, polytope.Vertex(vertex).W), gap = height - lowest;
            depth.TightenUpper(normal, height);
            if (depth.IsApart(state)) return Verdict.Apart;
            if (!(gap >= -GjkTolerances.Contradiction * state.Size.Value)) return Verdict.Contradiction;
            if (gap <= noise) polytope.DropLast();
            else if (!polytope.TryExpand(face, vertex, double.NegativeInfinity)) return Verdict.Undecided;
        }
    }

    private static double CellNoise(in SolverState state) =>
        (state.IsCurved ? GjkTolerances.DepthCellNoiseCurved : GjkTolerances.DepthNoise) * state.Size.Value;
}
