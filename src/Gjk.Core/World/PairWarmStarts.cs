namespace Gjk.Core;

/// <summary>What a frame hands to the next one for each pair: the warm start, and whether the pair was
/// reported.</summary>
/// <remarks>A frame queries more pairs than it reports; which ones depends on the bounds. So a result may only depend
/// on the warm start of a pair that was reported; see <see cref="SceneDistanceJob"/>.</remarks>
internal sealed class PairWarmStarts : PairHistory
{
    /// <summary>The frame's answers.</summary>
    public Frame Now { get; private set; } = new();

    /// <summary>Those of the frame before.</summary>
    public Frame Last { get; private set; } = new();

    /// <summary>Gives the i-th pair the warm start and the state that the last frame left.</summary>
    /// <param name="i">The pair.</param>
    /// <param name="haveKeptShapes">Whether both objects have the same shapes as in the last frame. If not, the pair
    /// starts cold.</param>
    /// <param name="last">From <see cref="PairHistory.Seek"/>, or as the call for the pair before left it.</param>
    /// <returns>The state.</returns>
    public PairState Resume(int i, bool haveKeptShapes, ref int last)
    {
        bool isKnown = IsKnown(i, ref last) && haveKeptShapes;
        Now.Starts[i] = isKnown ? Last.Starts[last] : default;
        return Now.States[i] = isKnown ? Last.States[last] : PairState.Unknown;
    }

    /// <inheritdoc/>
    protected override void SwapFrames(int count)
    {
        Last.Reserve(count);
        (Now, Last) = (Last, Now);
    }

    /// <summary>Tables with one entry for each pair.</summary>
    internal sealed class Frame
    {
        public WarmStart[] Starts = [];

        /// <summary>The state of each pair: at first that of the last frame, in the end that of this one.</summary>
        public PairState[] States = [];

        /// <summary>Whether each pair keeps the answer that it had in the last frame.</summary>
        public bool[] Kept = [];

        public DistanceResult[] Results = [];

        /// <summary>The parts that the answers are of; valid for pairs that are not convex.</summary>
        public ObjectPair[] Parts = [];

        /// <summary>Makes room for so many pairs. Changes nothing if there is no memory for it.</summary>
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
