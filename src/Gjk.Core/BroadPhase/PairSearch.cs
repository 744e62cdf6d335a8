namespace Gjk.Core;

/// <summary>Finds the pairs of some of a tree's leaves with all others, on several threads: each has a list of its own,
/// and since pairs are sorted afterwards, it does not matter which pair is in which.</summary>
internal sealed class PairSearch(FatLeaves leaves)
{
    /// <summary>Count of objects whose pairs are looked up by one thread in turn. A matter of speed only.</summary>
    private const int ShareLength = 256;

    private readonly Stack<PairKeys> _idle = new();
    private long _visits;

    /// <summary>Finds the pairs.</summary>
    /// <param name="objects">Each pair with one of these is found once; those that are not in the tree have
    /// none.</param>
    /// <param name="margin">How far apart the leaves of a pair may be.</param>
    /// <param name="most">A search that has found more pairs than this may end.</param>
    /// <param name="found">Emptied first.</param>
    /// <param name="workers">The threads to use; null for the caller's own.</param>
    /// <returns>False where there are more than the most.</returns>
    public bool TryFind(IdSet objects, float margin, long most, PairKeys found, Workers? workers)
    {
        foreach (PairKeys list in _idle) list.Count = 0;
        found.Count = 0;
        _visits = 0;
        Workers.Run(workers, new Job(this, leaves, objects, margin, most), objects.Count, ShareLength);
        leaves.Tree.Count(_visits);
        foreach (PairKeys list in _idle) found.Append(list);
        return found.Count <= most;
    }

    private PairKeys Rent()
    {
        lock (_idle) return _idle.Count > 0 ? _idle.Pop() : new PairKeys();
    }

    private void Return(PairKeys list, long visits)
    {
        lock (_idle)
        {
            _idle.Push(list);
            _visits += visits;
        }
    }

    private readonly struct Job(PairSearch search, FatLeaves leaves, IdSet objects, float margin, long most)
        : IShareJob
    {
        public void Run(int begin, int end)
        {
            PairKeys list = search.Rent();
            long visits = 0;
            for (int i = begin; i < end && list.Count <= most; i++)
            {
                int id = objects.Ids[i];
                if (leaves.IsInTree(id)) visits += leaves.Tree.QueryPairs(id, margin, objects.Contains, list);
            }

            search.Return(list, visits);
        }
    }
}
