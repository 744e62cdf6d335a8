namespace Gjk.Core;

/// <summary>The pairs that a frame asks about and those of the frame before, both sorted: a pair finds its place in the
/// last frame by a walk along both lists at once, and pairs that are gone are left behind. What is known of a pair is
/// in the tables of those that inherit this.</summary>
internal abstract class PairHistory
{
    private ulong[] _now = [], _last = [];
    private int _lastCount;
    private bool _isComplete, _isKept;

    /// <summary>The scene's count of calls at this frame.</summary>
    public long Call { get; private set; }

    /// <summary>Whether the last frame's pairs are known.</summary>
    public bool KnowsAny => _lastCount > 0;

    /// <summary>How many pairs the frame has.</summary>
    public int Count { get; private set; }

    /// <summary>The scene's count of calls at the last frame: objects that moved since have it or more.</summary>
    public long LastCall { get; private set; }

    /// <summary>Begins a frame with these pairs of slots; nothing changes if there is no memory for it.</summary>
    /// <param name="pairs">Sorted; their ids ascend as they do.</param>
    /// <param name="ids">Of the slots.</param>
    /// <param name="calls">The scene's count of calls, which this is one of.</param>
    /// <param name="isKept">Whether pairs are found in the last frame, and in this one by the next.</param>
    public void Begin(List<ObjectPair> pairs, int[] ids, ref long calls, bool isKept = true)
    {
        if (_last.Length < pairs.Count) _last = new ulong[BoundsTable.Grown(_last.Length, pairs.Count)];
        Turn(pairs.Count);
        (_now, _last) = (_last, _now);

        // Discard the mixed data of an interrupted call.
        _lastCount = _isComplete && isKept ? Count : 0;
        _isComplete = false;
        _isKept = isKept;
        Count = pairs.Count;
        LastCall = Call;
        Call = ++calls;
        if (!isKept) return;
        for (int i = 0; i < Count; i++) _now[i] = PairKeys.Key(ids[pairs[i].A], ids[pairs[i].B]);
    }

    /// <summary>All pairs of the frame have their answers.</summary>
    public void Complete() => _isComplete = _isKept;

    /// <summary>The next frame shall not find this one's pairs.</summary>
    public void Forget() => _isComplete = false;

    /// <summary>Where among the last frame's pairs to look for the i-th and those after it.</summary>
    public int Seek(int i)
    {
        int found = Array.BinarySearch(_last, 0, _lastCount, _now[i]);
        return found >= 0 ? found : ~found;
    }

    /// <summary>Whether the last frame had the i-th pair.</summary>
    /// <param name="i">The pair.</param>
    /// <param name="last">From <see cref="Seek"/>, or as the call for a pair before left it; the pair's place.</param>
    protected bool IsKnown(int i, ref int last)
    {
        ulong key = _now[i];
        while (last < _lastCount && _last[last] < key) last++;
        return last < _lastCount && _last[last] == key;
    }

    /// <summary>The frame's tables become the last ones, and those before the frame's, with that much room.</summary>
    protected abstract void Turn(int count);
}
