namespace Gjk.Core;

/// <summary>
/// The answers of a frame, one for each pair, and those of the frame before, which pairs keep that have not moved.
/// </summary>
/// <typeparam name="T">An answer.</typeparam>
internal sealed class PairAnswers<T> : PairFrames
    where T : struct
{
    private T[] _now = [], _last = [];

    /// <summary>The answer for the i-th pair.</summary>
    public ref T this[int i] => ref _now[i];

    /// <summary>Gives the i-th pair the answer that it had in the last frame.</summary>
    /// <returns>False when it had none.</returns>
    public bool TryKeep(int i, ref int last)
    {
        bool isKnown = IsKnown(i, ref last);
        if (isKnown) _now[i] = _last[last];
        return isKnown;
    }

    /// <inheritdoc/>
    protected override void Turn(int count)
    {
        if (_last.Length < count) _last = new T[BoundsTable.Grown(_last.Length, count)];
        (_now, _last) = (_last, _now);
    }
}
