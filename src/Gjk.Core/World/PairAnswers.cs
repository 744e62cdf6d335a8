using System.Collections.Generic;

namespace Gjk.Core;

/// <summary>
/// The answers of a frame, one for each pair, and those of the frame before, which pairs keep that have not moved.
/// </summary>
/// <typeparam name="T">An answer.</typeparam>
internal sealed class PairAnswers<T>
    where T : struct
{
    private readonly PairFrames _frames = new();
    private T[] _now = [], _last = [];

    /// <inheritdoc cref="PairFrames.Count"/>
    public int Count => _frames.Count;

    /// <inheritdoc cref="PairFrames.LastCall"/>
    public long LastCall => _frames.LastCall;

    /// <summary>The answer for the i-th pair.</summary>
    public ref T this[int i] => ref _now[i];

    /// <inheritdoc cref="PairFrames.Begin"/>
    public void Begin(List<ObjectPair> pairs, int[] ids, ref long calls)
    {
        if (_last.Length < pairs.Count) _last = new T[BoundsTable.Grown(_last.Length, pairs.Count)];
        _frames.Begin(pairs, ids, ref calls);
        (_now, _last) = (_last, _now);
    }

    /// <inheritdoc cref="PairFrames.Complete"/>
    public void Complete() => _frames.Complete();

    /// <inheritdoc cref="PairFrames.Forget"/>
    public void Forget() => _frames.Forget();

    /// <inheritdoc cref="PairFrames.Seek"/>
    public int Seek(int i) => _frames.Seek(i);

    /// <summary>Gives the i-th pair the answer that it had in the last frame.</summary>
    /// <returns>False when it had none.</returns>
    public bool TryKeep(int i, ref int last)
    {
        bool isKnown = _frames.IsKnown(i, ref last);
        if (isKnown) _now[i] = _last[last];
        return isKnown;
    }
}
