namespace Gjk.Core;

/// <summary>Ends a search for the pairs of enlarged boxes that finds far more of them than there are pairs of the boxes
/// themselves. So no arrangement makes a broad phase keep more than a few pairs for each object and for each pair that
/// it has to report.</summary>
internal sealed class PairBudget(BoundsTable table)
{
    /// <summary>Count: pairs kept for each object and for each true pair. A lattice of equal boxes, none touching, has
    /// 13 pairs of neighbours per object; it is to stay below. Pinned by WorstCaseTests.</summary>
    public const int PairsPerPair = 16;

    private float _margin;
    private bool _isUnlimited;
    private int _counted;
    private long _near;

    /// <summary>At so many pairs <see cref="Allows"/> must be asked.</summary>
    public int Limit { get; private set; }

    /// <summary>How many kept pairs are worth their while beside so many true ones.</summary>
    public static long Of(int objects, long truePairs) => PairsPerPair * (objects + truePairs);

    /// <summary>A new search.</summary>
    /// <param name="margin">The boxes' pairs are counted with this margin.</param>
    /// <param name="isUnlimited">Whether the search must not be ended.</param>
    public void Begin(float margin, bool isUnlimited)
    {
        _margin = margin;
        _isUnlimited = isUnlimited;
        _counted = 0;
        _near = 0;
        Limit = isUnlimited ? int.MaxValue : (int)Math.Min(Of(table.Count, 0), int.MaxValue);
    }

    /// <summary>Looks how many of the pairs found are true ones; if they are enough, the limit rises.</summary>
    public bool Allows(PairKeys found)
    {
        if (_isUnlimited) return true;
        for (; _counted < found.Count; _counted++)
        {
            ulong key = found.Keys[_counted];
            if (BoundsTable.Near(table.Boxes[PairKeys.First(key)], table.Boxes[PairKeys.Second(key)], _margin)) _near++;
        }

        long allowed = Of(table.Count, _near);
        Limit = (int)Math.Min(allowed, int.MaxValue);
        return found.Count < allowed;
    }
}
