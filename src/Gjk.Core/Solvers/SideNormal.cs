namespace Gjk.Core;

/// <summary>The normal along which another body touches a round side: of two parallel cylinders it is the direction
/// from the one's axis to the other's, of an edge beside a cylinder that from the axis to the edge. The searches for
/// curved cores end within a small part of a length, which leaves the angle round such a side open by the root of that
/// part, up to 1e-3: each search would end at another angle, and the contacts of a body at rest would change with every
/// frame.</summary>
/// <remarks>The axes of the sides, the edges and the faces are known from what both shapes show (<see
/// cref="BestNormal"/>). Nothing of it is assumed: the direction is taken if a support proves that it separates the
/// bodies at least as far as the plane that is known, and if there are points along it, which supports a little to both
/// sides give, or the known ones.</remarks>
internal static class SideNormal<TA, TB, TTrace>
    where TA : struct, ISupportMap
    where TB : struct, ISupportMap
    where TTrace : struct, IGjkTrace
{
    /// <summary>Length: bodies that are further apart than this need no sharp normal. As far as a maximal gap usually
    /// reaches; more costs time. Pinned by RestingSideTests.</summary>
    private const double Near = 0.1;

    /// <summary>Ratio: how far the supports at both ends lean, small against the slope of any end and large against
    /// rounding. Four times more or less changes nothing.</summary>
    private const double Lean = 1e-3;

    /// <summary>Length: ends that are this level are of one line. Between the rounding of two poses, 1e-7, which the
    /// axes of bodies that were placed in parallel are off by, and what leaning costs on a rounded side. Pinned by
    /// ParallelContactTests.</summary>
    private const double Level = 4e-7;

    /// <summary>Length: the two points are this near to one line along the normal; a rounding to float, and less than
    /// the line of a short body's ends may be off. Pinned by PointPlacementTests.</summary>
    private const double Beside = 1.0 / (1 << 23);

    /// <summary>Length: how far a point may be moved round a side; its square, over the side's radius, is what it
    /// leaves the surface by. Four times more or less changes nothing but how many are moved.</summary>
    private const double Aside = 1e-5;

    /// <summary>Cosine: a search is never off by more.</summary>
    private const double LeastCosine = 0.99;

    /// <summary>Makes normal and points sharper where a round side is touched, of what a query found.</summary>
    /// <param name="a">The first core.</param>
    /// <param name="b">The second one.</param>
    /// <param name="frame">Where B is.</param>
    /// <param name="state">Of cores that are apart or overlap; a positive distance stays as it is.</param>
    /// <param name="trace">Is told of the supports.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Sharpen(ref TA a, ref TB b, in PairFrame frame, ref SolverState state, ref TTrace trace)
    {
        if (state.IsCurved && state.Verdict == Verdict.Apart) SharpenNear(ref a, ref b, frame, ref state, ref trace);
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private static unsafe void SharpenNear(
        ref TA a, ref TB b, in PairFrame frame, ref SolverState state, ref TTrace trace)
    {
        double scale = 1 / Math.Sqrt(state.Feature.NormalSquared);
        Double3 known = state.Feature.Normal * -scale;
        if (!(state.Feature.Height * scale - frame.Margins <= Near * state.Size.Value)) return;
        FaceCorner* memory = stackalloc FaceCorner[2 * FaceCorners.Capacity];
        var cornersA = new FaceCorners(memory);
        var cornersB = new FaceCorners(memory + FaceCorners.Capacity);
        a.GetFace(known, ref cornersA);
        b.GetFace(frame.Rotation.InverseRotate(-known), ref cornersB);
        bool isOfA = cornersA.SideRadius > 0;
        if (!isOfA && !(cornersB.SideRadius > 0)) return;
        for (int i = 0; i < cornersB.Count; i++)
            cornersB[i] = frame.Rotation.Rotate(cornersB[i]) + frame.Translation;
        BestNormal best = isOfA
            ? new BestNormal(cornersA, cornersB, frame.Translation, known, state.Size.Value)
            : new BestNormal(cornersB, cornersA, default, -known, state.Size.Value);
        Double3 normal = isOfA ? best.Normal : -best.Normal;
        AdoptIfProved(ref a, ref b, frame, normal, best.Axis, isOfA, known, ref state, ref trace);
    }

    /// <summary>Takes the normal, if it is as good as the one that is known.</summary>
    private static void AdoptIfProved(
        ref TA a, ref TB b, in PairFrame frame, in Double3 normal, in Double3 axis, bool isOfA, in Double3 known,
        ref SolverState state, ref TTrace trace)
    {
        Simplex.Make(out Simplex ends);
        Double3 p = Support(ref a, ref b, frame, axis * Lean - normal, ref state, ref trace, ref ends, 0);
        Double3 q = Support(ref a, ref b, frame, axis * -Lean - normal, ref state, ref trace, ref ends, 1);
        Double3 w = Support(ref a, ref b, frame, -normal, ref state, ref trace, ref ends, 2);
        double gap = -Double3.Dot(normal, w), level = Level * state.Size.Value;
        if (!(gap >= state.Plane.Distance && Double3.Dot(normal, known) >= LeastCosine)) return;
        bool isLevel = -Double3.Dot(normal, p) - gap <= level && -Double3.Dot(normal, q) - gap <= level;
        bool isOpposite = Double3.Dot(axis, p) <= 0 && Double3.Dot(axis, q) >= 0;
        ends.Select(2, 0, 1, 0, 0);
        Weights weights = ClosestPointWeights.Of(ends);
        if (isLevel && isOpposite && (ends.PointOf(weights) + normal * gap).Length <= Beside * state.Size.Value)
        {
            state.Simplex = ends;
            state.Weights = weights;
        }
        else if (!TryMove(ref a, ref b, frame, normal, axis, gap, isOfA, ref state))
        {
            return;
        }

        double distance = state.Feature.Height / Math.Sqrt(state.Feature.NormalSquared);
        state.Feature.Normal = -normal;
        state.Feature.NormalSquared = 1;
        state.Feature.Height = distance > 0 ? distance : Math.Min(gap, 0);
        state.Plane.Set(state.Feature, Math.Min(gap, state.Feature.Height));
    }

    /// <summary>Brings the points that are known onto one line along the normal: the one on the round side moves, by so
    /// little that it stays on its surface.</summary>
    /// <returns>False where they are too far from such a line, are not the furthest along it, or one would leave the
    /// side at its end.</returns>
    private static bool TryMove(
        ref TA a, ref TB b, in PairFrame frame, in Double3 normal, in Double3 axis, double gap, bool isOfA,
        ref SolverState state)
    {
        Double3 onA = state.Simplex.WitnessOnA(state.Weights);
        Double3 between = -state.Simplex.PointOf(state.Weights), onB = onA + between;
        double along = Double3.Dot(normal, between), size = state.Size.Value;
        Double3 aside = between - normal * along;
        if (!(along - gap <= Beside * size && aside.Length <= Aside * size)) return false;
        Double3 move = isOfA ? aside : -aside;
        double past = Double3.Dot(axis, move);
        if (Math.Abs(past) > Beside * size)
        {
            Double3 outward = axis * Math.Sign(past), end;
            if (isOfA) a.Support(outward, out end);
            else b.Support(frame.Rotation.InverseRotate(outward), out end);
            if (!isOfA) end = frame.Rotation.Rotate(end) + frame.Translation;
            if (Double3.Dot(outward, (isOfA ? onA : onB) + move - end) > Beside * size) return false;
        }

        if (isOfA) onA = onB - normal * gap;
        else onB = onA + normal * gap;
        state.Simplex.Clear();
        state.Simplex.Push(normal * -gap, onA, frame.Rotation.InverseRotate(onB - frame.Translation), -1, -1);
        state.Weights = ClosestPointWeights.Of(state.Simplex);
        return true;
    }

    private static Double3 Support(
        ref TA a, ref TB b, in PairFrame frame, in Double3 normal, ref SolverState state, ref TTrace trace,
        ref Simplex ends, int slot)
    {
        MinkowskiDifference.Support(ref a, ref b, frame, normal, ref ends.At(slot), out Double3 w);
        state.Iterations++;
        if (trace.IsOn) trace.OnSupport(new TracedSupport(frame, normal, ends.At(slot)));
        return w;
    }
}
