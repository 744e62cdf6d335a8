using System;
using System.Collections.Generic;

namespace Gjk.Core;

/// <summary>
/// Warm starts of all the pairs of a frame, sorted as the pairs are: the next frame's pairs find theirs by walking both lists at once, and those of pairs
/// that are gone are left behind.
/// </summary>
internal sealed class PairWarmStarts
{
    private ulong[] _keys = [], _lastKeys = [];
    private WarmStart[] _starts = [], _lastStarts = [];
    private int _count, _lastCount;

    /// <summary>How many pairs the last frame had.</summary>
    public int Count => _count;

    /// <summary>A new frame with these pairs of slots; their ids ascend as they do.</summary>
    public void Begin(List<ObjectPair> pairs, int[] ids)
    {
        (_keys, _lastKeys) = (_lastKeys, _keys);
        (_starts, _lastStarts) = (_lastStarts, _starts);
        _lastCount = _count;
        _count = pairs.Count;
        if (_keys.Length < _count)
        {
            int capacity = BoundsTable.Grown(_keys.Length, _count);
            _keys = new ulong[capacity];
            _starts = new WarmStart[capacity];
        }

        for (int i = 0; i < _count; i++) _keys[i] = PairKeys.Key(ids[pairs[i].A], ids[pairs[i].B]);
    }

    /// <summary>Where among the last frame's pairs to look for the i-th and those after it.</summary>
    public int Seek(int i)
    {
        int found = Array.BinarySearch(_lastKeys, 0, _lastCount, _keys[i]);
        return found >= 0 ? found : ~found;
    }

    /// <summary>The i-th pair's warm start, with what the last frame left.</summary>
    /// <param name="i">The pair.</param>
    /// <param name="last">From <see cref="Seek"/>, or as the call for the pair before left it.</param>
    public ref WarmStart Resume(int i, ref int last)
    {
        ulong key = _keys[i];
        while (last < _lastCount && _lastKeys[last] < key) last++;
        ref WarmStart start = ref _starts[i];
        start = last < _lastCount && _lastKeys[last] == key ? _lastStarts[last] : default;
        return ref start;
    }
}
