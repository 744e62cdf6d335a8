namespace Gjk.Core;

/// <summary>The answers of a frame, one for each pair, and those of the frame before, which pairs keep that have not
/// moved.</summary>
/// <typeparam name="T">An answer.</typeparam>
internal sealed class PairAnswers<T> : PairHistory
    where T : struct
{
    private T[] _now = [], _last = [];

    /// <summary>Of pairs that are not convex all answers, which change places with those of the frame before.</summary>
    private List<T>?[] _nowParts = [], _lastParts = [];

    /// <summary>The answer for the i-th pair.</summary>
    public ref T this[int i] => ref _now[i];

    /// <summary>Gives the i-th pair the answer that it had in the last frame.</summary>
    /// <returns>False when it had none.</returns>
    public bool TryKeep(int i, ref int last)
    {
        bool isKnown = IsKnown(i, ref last);
        if (!isKnown) return false;
        _now[i] = _last[last];
        if (HasParts) (_nowParts[i], _lastParts[last]) = (_lastParts[last], _nowParts[i]);
        return true;
    }

    /// <summary>The answer that the i-th pair had in the last frame; a default struct where it had none.</summary>
    public T LastOf(int i)
    {
        int last = Seek(i);
        return IsKnown(i, ref last) ? _last[last] : default;
    }

    /// <summary>Whether some pairs have more answers than one.</summary>
    public bool HasParts { get; set; }

    /// <summary>All answers for the i-th pair, which is not convex.</summary>
    public List<T> Parts(int i) => _nowParts[i] ??= [];

    /// <inheritdoc/>
    protected override void Turn(int count)
    {
        if (_last.Length < count) _last = new T[BoundsTable.Grown(_last.Length, count)];
        (_now, _last) = (_last, _now);
        (_nowParts, _lastParts) = (_lastParts, _nowParts);
        if (!HasParts) return;
        int room = Math.Max(_now.Length, _last.Length);
        if (_nowParts.Length < room) Array.Resize(ref _nowParts, room);
        if (_lastParts.Length < room) Array.Resize(ref _lastParts, room);
    }
}
