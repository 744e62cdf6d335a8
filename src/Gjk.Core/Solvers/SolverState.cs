namespace Gjk.Core;

/// <summary>What a solver starts from and what it found, in A's frame from A's centre, before margins and rounding to
/// float: the common currency of the fast and the extended-precision solver.</summary>
internal struct SolverState
{
    public Verdict Verdict;

    /// <summary>Whether a support point had no id: a curved core, whose supports never repeat.</summary>
    public bool IsCurved;

    /// <summary>The nearest feature of the cores' Minkowski difference, or the tetrahedron that holds the
    /// origin.</summary>
    public Simplex Simplex;

    /// <summary>The feature's normal: from the origin to the feature, so from B to A, of any length; zero height when
    /// overlapping.</summary>
    public ClosestFeature Feature;

    /// <summary>The weights of the simplex in the nearest point, or in the common one.</summary>
    public Weights Weights;

    /// <summary>The best separating plane.</summary>
    public SupportPlane Plane;

    /// <summary>What the tolerances are fractions of.</summary>
    public PairSize Size;

    /// <summary>Support calls made on each shape.</summary>
    public int Iterations;

#if !NET
    /// <summary>Those of the search, which Mono would clear once more as a local of its own.</summary>
    public FeatureVertices Vertices;
#endif

    /// <summary>How near the origin counts as touching it, squared.</summary>
    public readonly double TouchSquared
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get
        {
            double touch = GjkTolerances.TouchOf(IsCurved) * Size.Value;
            return touch * touch;
        }
    }

    /// <summary>What rounding, or the end of a walk along a curved core, leaves open: a gap between two bounds below it
    /// counts as closed.</summary>
    public readonly double Noise
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => (IsCurved ? GjkTolerances.NoiseCurved : GjkTolerances.Noise) * Size.Value;
    }

    /// <summary>The same for two bounds of a depth.</summary>
    public readonly double DepthNoise =>
        (IsCurved ? GjkTolerances.DepthNoiseCurved : GjkTolerances.DepthNoise) * Size.Value;

    /// <summary>Makes a state without vertices and planes; the contents of empty slots are not cleared.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Make<TA, TB>(in PairFrame frame, out SolverState state)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        UnsafeRef.SkipInit(out state);
        state.Simplex.Clear();
        state.Iterations = 0;
        state.Plane.NormalSquared = 0;
        state.Verdict = Verdict.Undecided;
        state.IsCurved = false;
        PairSize.Make<TA, TB>(frame, out state.Size);
    }

    /// <summary>Whether a support says anything that the tolerances depend on, so that See must be told of
    /// it.</summary>
    /// <param name="ids">Both ids; negative where one is.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly bool ChangesTolerances<TA, TB>(int ids)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap =>
        (ids < 0 && !IsCurved) || !(ShapeTraits<TA>.AreTight && ShapeTraits<TB>.AreTight);

    /// <summary>Takes note of what a support says about the shapes; the tolerances may have changed then.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public void Observe(in PairFrame frame, in DifferenceVertex vertex)
    {
        IsCurved |= (vertex.IdA | vertex.IdB) < 0;
        Size.Observe(frame, vertex.OnA, vertex.OnB);
    }
}

/// <summary>What a solver can say about two cores; <see cref="GjkStatus"/> is what a query says about two
/// shapes.</summary>
internal enum Verdict : byte
{
    /// <summary>Rounding leaves it open, or the iterations ran out.</summary>
    Undecided,

    /// <summary>The cores are apart; the nearest feature and a plane that meets it are known.</summary>
    Apart,

    /// <summary>The cores share a point; of a search for the depth, its bounds have met.</summary>
    Enclosed,

    /// <summary>A plane proves that the cores are further apart than asked.</summary>
    Beyond,

    /// <summary>A support function contradicted itself or gave NaN.</summary>
    Contradiction,

    /// <summary>The Minkowski difference has no inside: it is flat, a segment or a point. For searches of the depth
    /// alone.</summary>
    Flat,
}
