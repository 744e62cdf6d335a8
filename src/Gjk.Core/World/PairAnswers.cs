namespace Gjk.Core;

/// <summary>The answers of a frame, one for each pair, and those of the last frame. Pairs that have not moved keep
/// theirs.</summary>
/// <typeparam name="T">An answer.</typeparam>
internal sealed class PairAnswers<T> : PairHistory
    where T : struct
{
    private T[] _now = [], _last = [];

    /// <summary>All answers of each pair that is not convex. Lists are exchanged with the last frame, so that none is
    /// allocated.</summary>
    private List<T>?[] _nowLists = [], _lastLists = [];

    /// <summary>The answer for the i-th pair.</summary>
    public ref T this[int i] => ref _now[i];

    /// <summary>Gives the i-th pair the answer that it had in the last frame.</summary>
    /// <returns>False when it had none.</returns>
    public bool TryKeep(int i, ref int last)
    {
        if (!IsKnown(i, ref last)) return false;
        _now[i] = _last[last];
        if (HasLists) (_nowLists[i], _lastLists[last]) = (_lastLists[last], _nowLists[i]);
        return true;
    }

    /// <summary>The answer that the i-th pair had in the last frame; a default struct where it had none.</summary>
    public T LastAnswer(int i)
    {
        int last = Seek(i);
        return IsKnown(i, ref last) ? _last[last] : default;
    }

    /// <summary>Whether some pairs have a list of answers.</summary>
    public bool HasLists { get; set; }

    /// <summary>All answers for the i-th pair, which is not convex.</summary>
    public List<T> AllFor(int i) => _nowLists[i] ??= [];

    /// <inheritdoc/>
    protected override void SwapFrames(int count)
    {
        if (_last.Length < count) _last = new T[BoundsTable.Grown(_last.Length, count)];
        (_now, _last) = (_last, _now);
        (_nowLists, _lastLists) = (_lastLists, _nowLists);
        if (!HasLists) return;
        int room = Math.Max(_now.Length, _last.Length);
        if (_nowLists.Length < room) Array.Resize(ref _nowLists, room);
        if (_lastLists.Length < room) Array.Resize(ref _lastLists, room);
    }
}
