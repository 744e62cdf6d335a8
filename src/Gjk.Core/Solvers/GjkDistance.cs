namespace Gjk.Core;

/// <summary>GJK's distance algorithm (Gilbert, Johnson and Keerthi 1988, in the geometric form of Muratori 2006). It
/// walks over features of the Minkowski difference A - B, each nearer the origin than the last, until a support plane
/// proves that none is nearer.</summary>
/// <remarks>
/// <para>Each round asks for the vertex w that is furthest against the current feature's normal n. The whole difference
/// lies beyond the plane n·x = n·w, so n·w / |n| is a lower bound of the distance, and the feature itself is an upper
/// bound. When the two meet, the answer is proved. Otherwise w joins the simplex, which is reduced to its feature
/// nearest the origin.</para>
/// <para>Two things differ from the textbook. Nothing is divided: heights are compared with normals of any length. And
/// where rounding could turn the answer, this solver leaves the verdict open and <see cref="GjkExtendedPrecision"/>
/// decides: when the distance stops falling before the bounds meet, when the origin is enclosed but the determinants
/// are not certain, and when it is enclosed after a plane had separated. So what is decided here is proved in
/// double.</para>
/// <para>It terminates because the distance falls strictly from round to round, or the loop hands over, and there are
/// finitely many features. MaxIterations is a backstop.</para>
/// <para>Verdicts. Apart: both bounds met, or they passed each other by what a support may disagree with itself
/// (<see cref="GjkTolerances.Contradiction"/>). Enclosed: the origin is inside the tetrahedron, or nearer the feature
/// than rounding can tell. Beyond: a plane is further than asked. Undecided: the caller is to hand over. Contradiction:
/// a support point was NaN, or lay further behind one that the same support had given before.</para>
/// </remarks>
internal static class GjkDistance
{
    /// <summary>What the newest plane says about the nearest feature.</summary>
    private enum Ending
    {
        /// <summary>The walk goes on.</summary>
        None,

        /// <summary>The plane is further than asked.</summary>
        Beyond,

        /// <summary>The two meet.</summary>
        Closed,

        /// <summary>They seem to, but the feature's corners are not level.</summary>
        Tilted,

        /// <summary>The plane lies behind the feature, which no convex shape's can.</summary>
        Behind,
    }

    /// <summary>How far apart the cores may be before the query may end early; the bands keep its answer that of the
    /// full query.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double CoreReach(float maxDistance, in PairFrame frame) =>
        ShapeReach(maxDistance) / frame.Unit + frame.Margins + GjkTolerances.SeparatedBandCurved * frame.Radius;

    /// <summary>How far apart the shapes may be, in world units.</summary>
    public static double ShapeReach(float maxDistance) =>
        Math.Max(maxDistance, 0.0) * (1 + GjkTolerances.FloatBand) + float.Epsilon;

    /// <summary>Runs the loop from <c>state.Feature.Normal</c> (cold), or from <c>state.Simplex</c> when that has
    /// vertices (warm).</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static void Solve<TA, TB, TTrace>(
        ref TA a, ref TB b, in PairFrame frame, double maxDistance, ref SolverState state, ref TTrace trace)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
        where TTrace : struct, IGjkTrace
    {
#if NET
        Load(state, out FeatureVertices vertices, out ClosestFeature feature);
#else
        ref FeatureVertices vertices = ref state.Vertices;
        Load(state, out vertices, out ClosestFeature feature);
#endif
        double distanceSquared = double.PositiveInfinity, touchSquared = state.TouchSquared, noise = state.Noise;
        double reachSquared = maxDistance * maxDistance;
        bool separated = false;
        if (vertices.Count != 0)
        {
            if (vertices.Count == 4 || !NextSimplex.TryKeepAll(ref vertices, ref feature))
            {
                if (!TryReselect(ref state)) return;
                Load(state, out vertices, out feature);
            }
            else if (vertices.Winding < 0)
            {
                vertices.Flip();
            }

            distanceSquared = feature.DistanceSquared;
            if (!(distanceSquared > touchSquared))
            {
                Stop(ref state, vertices, feature, distanceSquared, touchSquared);
                return;
            }
        }

        for (int rounds = 1; ; rounds++)
        {
            int slot = vertices.FreeSlot;
            int ids = MinkowskiDifference.Support(
                ref a, ref b, frame, feature.Normal, ref state.Simplex.At(slot), out Double3 w);
            if (state.ChangesTolerances<TA, TB>(ids))
            {
                state.Observe(frame, state.Simplex.At(slot));
                (touchSquared, noise) = (state.TouchSquared, state.Noise);
            }

            if (trace.IsOn) trace.OnSupport(new TracedSupport(frame, feature.Normal, state.Simplex.At(slot)));
            double plane = Double3.Dot(feature.Normal, w);
            separated |= plane > 0 & plane * plane > touchSquared * feature.NormalSquared;
            Ending ending = Judge(state, vertices, feature, plane, reachSquared, noise, frame.Margins);
            if (ending != Ending.None)
            {
                state.Iterations += rounds;
                Settle(ref state, vertices, feature, plane, ending);
                return;
            }

            var newest = new MinkowskiVertex(w, slot);
            if (!NextSimplex.TryAdvance(ref vertices, newest, ref feature, nearest: true))
            {
                state.Iterations += rounds;
                Surround(ref state, vertices, slot, separated, touchSquared);
                if (trace.IsOn) trace.OnReduced(new TracedSimplex(state.Simplex, frame, isExtended: false));
                return;
            }

            if (trace.IsOn) TraceReduction(state, vertices, frame, ref trace);
            double before = distanceSquared;
            distanceSquared = feature.DistanceSquared;
            if (distanceSquared > touchSquared & distanceSquared < before & rounds < GjkTolerances.MaxIterations)
                continue;
            state.Iterations += rounds;
            Stop(ref state, vertices, feature, distanceSquared, touchSquared);
            return;
        }
    }

    /// <summary>Two cores that are points, as those of spheres are (their margins are all of their radii): what the
    /// loop would find in its one round, in closed form. Of points that coincide any direction leads out of their
    /// margins: signed, it is the world's x, as for balls.</summary>
    public static void SolvePoints(in PairFrame frame, ref SolverState state, bool isSigned = false)
    {
        state.Simplex.Push(-frame.Translation, default, default, 0, 0);
        state.Iterations = 1;
        state.Feature.Normal = -frame.Translation;
        state.Feature.Height = state.Feature.NormalSquared = frame.Translation.LengthSquared;
        if (isSigned && !(state.Feature.Height > 0))
        {
            state.Feature.Normal = frame.RotationA.InverseRotate(new Double3(-1, 0, 0));
            state.Feature.NormalSquared = 1;
        }

        state.Verdict = isSigned || state.Feature.Height > 0 ? Verdict.Apart : Verdict.Enclosed;
        state.Plane.Set(state.Feature, state.Feature.Height);
        state.Weights = new Weights(1, 0, 0, 0);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Ending Judge(
        in SolverState state, in FeatureVertices vertices, in ClosestFeature feature, double plane,
        double reachSquared, double noise, double margins)
    {
        if (plane > 0 & plane * plane > reachSquared * feature.NormalSquared) return Ending.Beyond;
        if (vertices.Count == 0) return Ending.None;
        double gap = feature.Height - plane;
        if (!Proofs.IsClosed(gap, feature, state.IsCurved, noise, margins))
            return gap > 0 ? Ending.None : Ending.Behind;

        // The normal of a needle of a triangle can be tilted so far by rounding that its corners no longer are level:
        // then the height of one proves nothing.
        return vertices.Count != 3 || state.IsCurved
            || Proofs.IsLevel(vertices, feature, plane, GjkTolerances.Level * state.Size.Value)
            ? Ending.Closed
            : Ending.Tilted;
    }

    /// <summary>Brings the vertices and the feature of a state into locals.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Load(in SolverState state, out FeatureVertices vertices, out ClosestFeature feature)
    {
        vertices.Count = state.Simplex.Count;
        state.Simplex.Get(state.Simplex.A, out vertices.A);
        state.Simplex.Get(state.Simplex.B, out vertices.B);
        state.Simplex.Get(state.Simplex.C, out vertices.C);
        vertices.Winding = 1;
        feature.Normal = new Double3(state.Feature.Normal.X, state.Feature.Normal.Y, state.Feature.Normal.Z);
        feature.Height = state.Feature.Height;
        feature.NormalSquared = feature.Normal.LengthSquared;
    }

    /// <summary>The other way; a triangle is wound as <see cref="Simplex"/> asks.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Store(ref SolverState state, in FeatureVertices vertices, in ClosestFeature feature)
    {
        int b = (int)vertices.B.Slot, c = (int)vertices.C.Slot;
        bool turned = vertices.Count == 3 & vertices.Winding < 0;
        state.Simplex.Select(vertices.Count, (int)vertices.A.Slot, turned ? c : b, turned ? b : c, 0);
        state.Feature = feature;
    }

    /// <summary>The plane has ended the walk.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Settle(
        ref SolverState state, in FeatureVertices vertices, in ClosestFeature feature, double plane, Ending ending)
    {
        Store(ref state, vertices, feature);
        state.Plane.Set(feature, plane);
        if (ending == Ending.Closed)
        {
            state.Weights = ClosestPointWeights.OfFeature(state.Simplex, state.Feature);
            state.Verdict = Proofs.HoldsItsPoint(state) ? Verdict.Apart : Verdict.Undecided;
        }
        else if (ending == Ending.Behind)
        {
            Proofs.SettleStall(ref state, plane, plane - feature.Height);
        }
        else
        {
            state.Verdict = ending == Ending.Beyond ? Verdict.Beyond : Verdict.Undecided;
        }
    }

    /// <summary>The origin seems to be inside the tetrahedron of the feature and the newest vertex.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Surround(
        ref SolverState state, in FeatureVertices vertices, int newest, bool separated, double touchSquared)
    {
        int b = (int)vertices.B.Slot, c = (int)vertices.C.Slot;
        bool turned = vertices.Winding < 0;
        state.Simplex.Select(4, newest, (int)vertices.A.Slot, turned ? c : b, turned ? b : c);
        if (separated) state.Verdict = Verdict.Undecided;
        else Proofs.Enclose(ref state, touchSquared);
    }

    /// <summary>The feature touches the origin, or is no nearer than the last, or there were too many rounds.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void Stop(
        ref SolverState state, FeatureVertices vertices, ClosestFeature feature, double distanceSquared,
        double touchSquared)
    {
        Store(ref state, vertices, feature);
        if (distanceSquared > touchSquared) state.Verdict = Verdict.Undecided;
        else Proofs.Touch(ref state, distanceSquared, touchSquared);
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void TraceReduction<TTrace>(
        in SolverState state, FeatureVertices vertices, in PairFrame frame, ref TTrace trace)
        where TTrace : struct, IGjkTrace
    {
        SolverState copy = state;
        Store(ref copy, vertices, default);
        trace.OnReduced(new TracedSimplex(copy.Simplex, frame, isExtended: false));
    }

    /// <summary>Finds the nearest feature of a warm start's simplex, of which not all vertices are part; false when
    /// that settles the query already.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static bool TryReselect(ref SolverState state)
    {
        if (state.Simplex.Count == 4 && Proofs.TryEncloseClearly(ref state)) return false;
        if (!ClosestPointWeights.TrySelect(ref state.Simplex))
        {
            Proofs.Enclose(ref state, state.TouchSquared);
            return false;
        }

        Load(state, out FeatureVertices vertices, out ClosestFeature feature);
        NextSimplex.Reduce(ref vertices, ref feature);
        Store(ref state, vertices, feature);
        return true;
    }
}
