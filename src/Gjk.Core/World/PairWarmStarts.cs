using System;
using System.Collections.Generic;

namespace Gjk.Core;

/// <summary>
/// What a frame leaves to the next one about each of its pairs: the warm start, and whether the pair was reported. The
/// pairs are sorted: the next frame's pairs find theirs by walking both lists at once, and those of pairs that are gone
/// are left behind.
/// </summary>
/// <remarks>
/// Which pairs a frame looks at depends on their bounds, which pairs it reports does not. So only the warm start of a
/// pair that was reported may be seen in a result; see <see cref="SceneDistanceJob"/>.
/// </remarks>
internal sealed class PairWarmStarts
{
    private Frame _now = new();
    private Frame _last = new();

    /// <summary>How many pairs the last frame had.</summary>
    public int Count => _now.Count;

    /// <summary>The answers of the frame, one for each pair.</summary>
    public DistanceResult[] Results => _now.Results;

    /// <summary>The warm starts of the frame, one for each pair.</summary>
    public WarmStart[] Starts => _now.Starts;

    /// <summary>A new frame with these pairs of slots; their ids ascend as they do.</summary>
    public void Begin(List<ObjectPair> pairs, int[] ids)
    {
        _last.Reserve(pairs.Count);
        (_now, _last) = (_last, _now);
        _now.Count = pairs.Count;
        _now.IsComplete = false;

        // What an interrupted frame left is not all its own.
        if (!_last.IsComplete) _last.Count = 0;
        for (int i = 0; i < _now.Count; i++) _now.Keys[i] = PairKeys.Key(ids[pairs[i].A], ids[pairs[i].B]);
    }

    /// <summary>All pairs of the frame have their answers.</summary>
    public void Complete() => _now.IsComplete = true;

    /// <summary>Where among the last frame's pairs to look for the i-th and those after it.</summary>
    public int Seek(int i)
    {
        int found = Array.BinarySearch(_last.Keys, 0, _last.Count, _now.Keys[i]);
        return found >= 0 ? found : ~found;
    }

    /// <summary>Whether each pair keeps the answer that it had in the last frame.</summary>
    public bool[] Kept => _now.Kept;

    /// <summary>What is known of each pair: first from the last frame, in the end from this one.</summary>
    public PairState[] States => _now.States;

    /// <summary>Gives the i-th pair the warm start and the state that the last frame left.</summary>
    /// <param name="i">The pair.</param>
    /// <param name="last">From <see cref="Seek"/>, or as the call for the pair before left it.</param>
    /// <returns>The state.</returns>
    public PairState Resume(int i, ref int last)
    {
        ulong key = _now.Keys[i];
        while (last < _last.Count && _last.Keys[last] < key) last++;
        bool isKnown = last < _last.Count && _last.Keys[last] == key;
        _now.Starts[i] = isKnown ? _last.Starts[last] : default;
        return _now.States[i] = isKnown ? _last.States[last] : PairState.Unknown;
    }

    /// <summary>The answer that the pair had in the last frame; for the value of last that found it.</summary>
    public ref readonly DistanceResult LastResult(int last) => ref _last.Results[last];

    private sealed class Frame
    {
        public ulong[] Keys = [];
        public WarmStart[] Starts = [];
        public PairState[] States = [];
        public bool[] Kept = [];
        public DistanceResult[] Results = [];
        public int Count;
        public bool IsComplete;

        /// <summary>Nothing changes if there is no memory for it.</summary>
        public void Reserve(int count)
        {
            if (Keys.Length >= count) return;
            int capacity = BoundsTable.Grown(Keys.Length, count);
            var starts = new WarmStart[capacity];
            var states = new PairState[capacity];
            bool[] kept = new bool[capacity];
            ulong[] keys = new ulong[capacity];
            var results = new DistanceResult[capacity];
            (Keys, Starts, States, Kept, Results) = (keys, starts, states, kept, results);
        }
    }
}

/// <summary>What is known of a pair from the frame before.</summary>
internal enum PairState : byte
{
    /// <summary>Nothing: its bounds were too far apart, or one of the two was not there.</summary>
    Unknown = 0,

    /// <summary>It was looked at, and was further apart than asked.</summary>
    Beyond,

    /// <summary>It was reported.</summary>
    Reported,
}
