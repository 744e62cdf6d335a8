namespace Gjk.Core;

/// <summary>What a frame leaves to the next one about each of its pairs: the warm start, and whether the pair was
/// reported.</summary>
/// <remarks>Which pairs a frame looks at depends on their bounds, which pairs it reports does not. So only the warm
/// start of a pair that was reported may be seen in a result; see <see cref="SceneDistanceJob"/>.</remarks>
internal sealed class PairWarmStarts : PairHistory
{
    private Frame _now = new();
    private Frame _last = new();

    /// <summary>The answers of the frame, one for each pair.</summary>
    public DistanceResult[] Results => _now.Results;

    /// <summary>The parts that the answers are of, one for each pair; valid for pairs that are not convex.</summary>
    public ObjectPair[] Parts => _now.Parts;

    /// <summary>The parts that the pair's answer was of in the last frame.</summary>
    public ObjectPair LastParts(int last) => _last.Parts[last];

    /// <summary>The warm starts of the frame, one for each pair.</summary>
    public WarmStart[] Starts => _now.Starts;

    /// <summary>Whether each pair keeps the answer that it had in the last frame.</summary>
    public bool[] Kept => _now.Kept;

    /// <summary>What is known of each pair: first from the last frame, in the end from this one.</summary>
    public PairState[] States => _now.States;

    /// <summary>Gives the i-th pair the warm start and the state that the last frame left.</summary>
    /// <param name="i">The pair.</param>
    /// <param name="keepsShapes">Whether both objects have the shapes that they had in the last frame; what is known of
    /// others is forgotten.</param>
    /// <param name="last">From <see cref="PairHistory.Seek"/>, or as the call for the pair before left it.</param>
    /// <returns>The state.</returns>
    public PairState Resume(int i, bool keepsShapes, ref int last)
    {
        bool isKnown = IsKnown(i, ref last) && keepsShapes;
        _now.Starts[i] = isKnown ? _last.Starts[last] : default;
        return _now.States[i] = isKnown ? _last.States[last] : PairState.Unknown;
    }

    /// <summary>The answer that the pair had in the last frame; for the value of last that found it.</summary>
    public ref readonly DistanceResult LastResult(int last) => ref _last.Results[last];

    /// <inheritdoc/>
    protected override void Turn(int count)
    {
        _last.Reserve(count);
        (_now, _last) = (_last, _now);
    }

    private sealed class Frame
    {
        public WarmStart[] Starts = [];
        public PairState[] States = [];
        public bool[] Kept = [];
        public DistanceResult[] Results = [];
        public ObjectPair[] Parts = [];

        /// <summary>Nothing changes if there is no memory for it.</summary>
        public void Reserve(int count)
        {
            if (Starts.Length >= count) return;
            int capacity = BoundsTable.Grown(Starts.Length, count);
            var starts = new WarmStart[capacity];
            var states = new PairState[capacity];
            bool[] kept = new bool[capacity];
            var results = new DistanceResult[capacity];
            var parts = new ObjectPair[capacity];
            (Starts, States, Kept, Results, Parts) = (starts, states, kept, results, parts);
        }
    }
}

/// <summary>What is known of a pair from the frame before.</summary>
internal enum PairState : byte
{
    /// <summary>Nothing: its bounds were too far apart, or one of the two was not there or had another shape.</summary>
    Unknown = 0,

    /// <summary>It was looked at, and was further apart than asked.</summary>
    Beyond,

    /// <summary>It was reported.</summary>
    Reported,
}
