namespace Gjk.Core;

/// <summary>The sorted pairs of this frame and of the last one. One walk along both lists finds each pair's place in
/// the last frame. Derived classes hold what is known of each pair.</summary>
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

    /// <summary>The scene's count of calls at the last frame. An object that has moved since has this count or
    /// more.</summary>
    public long LastCall { get; private set; }

    /// <summary>Begins a frame with these pairs of slots. Changes nothing if there is no memory for it.</summary>
    /// <param name="pairs">Sorted; their ids ascend as they do.</param>
    /// <param name="ids">The id of each slot.</param>
    /// <param name="calls">The scene's count of calls; this call is counted.</param>
    /// <param name="isKept">Whether the pairs are looked up in the last frame, and by the next one in this.</param>
    public void BeginFrame(List<ObjectPair> pairs, int[] ids, ref long calls, bool isKept = true)
    {
        if (_last.Length < pairs.Count) _last = new ulong[BoundsTable.Grown(_last.Length, pairs.Count)];
        SwapFrames(pairs.Count);
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

    /// <summary>Says that all pairs of the frame have their answers, which the next frame may keep.</summary>
    public void CompleteFrame() => _isComplete = _isKept;

    /// <summary>Keeps the next frame from using the answers of this one.</summary>
    public void Forget() => _isComplete = false;

    /// <summary>The place among the last frame's pairs at which to look for the i-th pair and those after it.</summary>
    public int Seek(int i)
    {
        int found = Array.BinarySearch(_last, 0, _lastCount, _now[i]);
        return found >= 0 ? found : ~found;
    }

    /// <summary>Whether the last frame had the i-th pair.</summary>
    /// <param name="i">The pair.</param>
    /// <param name="last">From <see cref="Seek"/>, or as the call for an earlier pair left it. Becomes the pair's
    /// place.</param>
    protected bool IsKnown(int i, ref int last)
    {
        ulong key = _now[i];
        while (last < _lastCount && _last[last] < key) last++;
        return last < _lastCount && _last[last] == key;
    }

    /// <summary>Makes this frame's tables the last frame's, and takes the older ones for this frame, with room for so
    /// many pairs.</summary>
    protected abstract void SwapFrames(int count);
}
