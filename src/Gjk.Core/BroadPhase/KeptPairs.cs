namespace Gjk.Core;

/// <summary>The pairs of a tree's leaves within a margin, kept from one question to the next. While all objects stay in
/// their leaves nothing changes; the pairs of an object with a new leaf are found anew. Among the kept pairs are all
/// those of the boxes themselves, for any margin up to the kept one.</summary>
/// <remarks>What is kept is never more than <see cref="PairBudget"/> allows. Where the leaves are to blame, they are
/// made tighter for a while; where an unusual margin is, the pairs found for it are used once and not kept.</remarks>
internal sealed class KeptPairs(BoundsTable table, FatLeaves leaves)
{
    /// <summary>Count: questions in a row with less than half the kept margin, until pairs are found anew with the
    /// lesser one; and questions that an answer's size is remembered for. A matter of speed only.</summary>
    private const int PatienceQuestions = 16;

    /// <summary>Count: questions until tighter leaves are given up again. A matter of speed only.</summary>
    private const int TightQuestions = 64;

    /// <summary>Ratio: when more of the objects have new leaves, all pairs are found anew. A matter of speed
    /// only.</summary>
    private const int UnpairedPartForAll = 3;

    private readonly PairBudget _budget = new(table);
    private readonly PairKeys _begun = new();
    private readonly PairSearch _search = new(leaves);
    private readonly Selection<ulong> _lasting = new();

    /// <summary>The objects with new leaves, whose kept pairs are not those of the leaves. Some may have been
    /// removed.</summary>
    public IdSet Unpaired { get; } = new();

    /// <summary>The objects whose boxes are other ones than when pairs were marked.</summary>
    public IdSet Moved { get; } = new();

    /// <summary>The kept pairs whose boxes are this near are marked, but for those of what has moved; NaN where none
    /// is.</summary>
    private float _markedMargin = float.NaN;

    private PairKeys _pairs = new();
    private PairKeys _found = new();

    /// <summary>Whether there are kept pairs.</summary>
    private bool _isValid;

    /// <summary>Whether kept pairs may name objects that are not there.</summary>
    private bool _anyRemoved;

    /// <summary>The kept pairs are all that this margin asks for.</summary>
    private float _margin;
    private int _questionsBelowMargin;
    private int _questionsTight;
    private int _lastAnswer;

    /// <summary>The least answer of late; negative where there was none.</summary>
    private int _leastAnswer = -1;
    private int _leastAnswerAge;

    /// <summary>How many pairs are kept.</summary>
    public int Count => _isValid ? _pairs.Count : 0;

    /// <summary>How many pairs may be held: less in tests.</summary>
    public int PairLimit
    {
        set => _pairs.Limit = _found.Limit = _begun.Limit = value;
    }

    public void Reserve(int capacity)
    {
        Unpaired.Reserve(capacity);
        Moved.Reserve(capacity);
    }

    public void Remove() => _anyRemoved = true;

    public void Clear()
    {
        Unpaired.Clear();
        Moved.Clear();
        _isValid = _anyRemoved = false;
        _margin = 0;
        _questionsBelowMargin = _questionsTight = 0;
        _lastAnswer = _leastAnswerAge = 0;
        _leastAnswer = -1;
    }

    /// <summary>Gives all objects leaves, so that the tree can be asked; the pairs wait until they are asked
    /// for.</summary>
    public void UpdateLeaves(Workers? workers = null) => leaves.Update(Unpaired, workers);

    /// <summary>Pairs, in order, among which are all pairs of boxes within a margin.</summary>
    public PairKeys Find(float margin, Workers? workers)
    {
        UpdateLeaves(workers);
        _questionsBelowMargin = margin < 0.5f * _margin ? _questionsBelowMargin + 1 : 0;
        if (!_isValid || margin > _margin || _questionsBelowMargin >= PatienceQuestions) return FindAll(margin);
        return TryUpdate(workers) ? _pairs : FindAll(_margin);
    }

    /// <summary>Whether the pairs found have their marks from the last question; else they lose them.</summary>
    public bool KeepMarks(PairKeys found, float margin)
    {
        bool areKept = found == _pairs && margin == _markedMargin;
        if (!areKept) _markedMargin = float.NaN;
        return areKept;
    }

    /// <summary>Is told for which margin the pairs found are marked now, NaN for none, and how many are near.</summary>
    public void RememberAnswer(PairKeys found, float margin, int answer)
    {
        Moved.Clear();
        _markedMargin = found == _pairs ? margin : float.NaN;
        if (_leastAnswer < 0 || answer <= _leastAnswer || ++_leastAnswerAge > PatienceQuestions)
            (_leastAnswer, _leastAnswerAge) = (answer, 0);
        _lastAnswer = answer;
        if (found == _pairs && found.Count > PairBudget.LimitFor(table.Count, answer)) _isValid = false;
        if (leaves.Level == FatLevel.Motion || ++_questionsTight < TightQuestions) return;
        leaves.Level++;
        _questionsTight = 0;
    }

    /// <summary>All pairs of leaves, with tighter leaves where there are far more of them than of boxes.</summary>
    private PairKeys FindAll(float margin)
    {
        _found.Count = 0;
        _budget.Begin(margin, isUnlimited: false);
        while (!leaves.Tree.TryFindPairs(margin, _found, _budget))
        {
            _isValid = false;
            _questionsTight = 0;
            if (leaves.Level > FatLevel.None) leaves.Level--;
            leaves.Build(Unpaired);
            _found.Count = 0;

            // New leaves that are not enlarged have no other pairs than the boxes.
            _budget.Begin(margin, isUnlimited: leaves.Level == FatLevel.None);
        }

        _found.Sort(table.End);

        // A first question may be an unusual one.
        if (_found.Count > PairBudget.LimitFor(table.Count, Math.Max(_leastAnswer, 0))) return _found;
        (_pairs, _found) = (_found, _pairs);
        _markedMargin = float.NaN;
        _isValid = true;
        _anyRemoved = false;
        Unpaired.Clear();
        _margin = margin;
        _questionsBelowMargin = 0;
        return _pairs;
    }

    /// <summary>Drops the kept pairs of what has a new leaf or is gone, and finds the new ones; false, with no pairs
    /// kept, where finding all anew is better.</summary>
    private bool TryUpdate(Workers? workers)
    {
        if (Unpaired.Count == 0 && !_anyRemoved) return true;
        _isValid = false;
        if (Unpaired.Count > table.Count / UnpairedPartForAll) return false;
        var lasting = new LastingPairs(leaves, Unpaired.Contains, _pairs.Keys);
        int kept = _pairs.Count = _lasting.CopyTo(lasting, _pairs.Count, _pairs.Keys, workers);
        long most = PairBudget.LimitFor(table.Count, _lastAnswer) - kept;
        if (!_search.TryFind(Unpaired, _margin, most, _begun, workers)) return false;
        Unpaired.Clear();
        _begun.Sort(table.End);
        _pairs.Merge(_begun);
        _anyRemoved = false;
        _isValid = true;
        return true;
    }

    /// <summary>Selects the pairs of two objects that still have their leaves.</summary>
    private readonly struct LastingPairs(FatLeaves leaves, bool[] unpaired, ulong[] keys) : ISelector<ulong>
    {
        public bool TrySelect(int index, out ulong item)
        {
            item = keys[index];
            int a = PairKeys.First(item), b = PairKeys.Second(item);
            return leaves.IsInTree(a) && leaves.IsInTree(b) && !unpaired[a] && !unpaired[b];
        }
    }
}

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
    public static long LimitFor(int objects, long truePairs) => PairsPerPair * (objects + truePairs);

    /// <summary>A new search.</summary>
    /// <param name="margin">The boxes' pairs are counted with this margin.</param>
    /// <param name="isUnlimited">Whether the search must not be ended.</param>
    public void Begin(float margin, bool isUnlimited)
    {
        _margin = margin;
        _isUnlimited = isUnlimited;
        _counted = 0;
        _near = 0;
        Limit = isUnlimited ? int.MaxValue : (int)Math.Min(LimitFor(table.Count, 0), int.MaxValue);
    }

    /// <summary>Counts how many of the pairs found are near indeed; where there are enough, the limit rises.</summary>
    public bool Allows(PairKeys found)
    {
        if (_isUnlimited) return true;
        for (; _counted < found.Count; _counted++)
        {
            ulong key = found.Keys[_counted];
            if (BoundsTable.Near(table.Boxes[PairKeys.First(key)], table.Boxes[PairKeys.Second(key)], _margin)) _near++;
        }

        long allowed = LimitFor(table.Count, _near);
        Limit = (int)Math.Min(allowed, int.MaxValue);
        return found.Count < allowed;
    }
}
