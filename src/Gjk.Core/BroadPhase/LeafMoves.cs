namespace Gjk.Core;

/// <summary>Gives many objects new leaves: those that stay within their subtrees in parallel, each subtree by one
/// thread.</summary>
internal sealed class LeafMoves
{
    /// <summary>Count: fewer leaves are moved one by one. A matter of speed only.</summary>
    private const int LeastToShare = 64;

    /// <summary>Count of leaves whose subtrees are looked up by one thread in turn. A matter of speed only.</summary>
    private const int ShareLength = 256;

    private readonly int[] _starts = new int[AabbTree.MostSubtrees + 2];

    /// <summary>By place among the objects, their subtrees.</summary>
    private byte[] _subtrees = [];

    /// <summary>The objects in the order of their subtrees, those of none first.</summary>
    private int[] _ordered = [];

    /// <summary>Makes room for the numbers below a capacity.</summary>
    public void Reserve(int capacity)
    {
        if (_ordered.Length >= capacity) return;
        _subtrees = new byte[capacity];
        _ordered = new int[capacity];
    }

    /// <summary>Moves all that stay within their subtrees.</summary>
    /// <param name="leaves">The leaves; those that wait for new ones are there.</param>
    /// <param name="workers">The threads to use; null for the caller's own.</param>
    /// <param name="count">How many objects are left.</param>
    /// <returns>The objects that are left.</returns>
    public int[] Move(FatLeaves leaves, Workers? workers, out int count)
    {
        IdSet moved = leaves.Unplaced;
        count = moved.Count;
        if (count < LeastToShare || !leaves.Tree.TryCut()) return moved.Ids;
        Workers.Run(workers, new SearchJob(leaves, _subtrees), count, ShareLength);
        leaves.Tree.BeginMoves();
        Order(moved);
        var job = new MoveJob(leaves, _ordered, _starts);
        Workers.Run(workers, job, AabbTree.MostSubtrees, 1);
        leaves.Tree.EndMoves();
        count = _starts[1];
        return _ordered;
    }

    /// <summary>A counting sort.</summary>
    private void Order(IdSet moved)
    {
        Array.Clear(_starts, 0, _starts.Length);
        for (int i = 0; i < moved.Count; i++) _starts[_subtrees[i]]++;
        for (int i = 1; i < _starts.Length; i++) _starts[i] += _starts[i - 1];
        for (int i = moved.Count - 1; i >= 0; i--) _ordered[--_starts[_subtrees[i]]] = moved.Ids[i];
    }

    /// <summary>Which subtrees objects are in and stay in.</summary>
    private readonly struct SearchJob(FatLeaves leaves, byte[] subtrees) : IShareJob
    {
        public void Run(int begin, int end)
        {
            for (int i = begin; i < end; i++)
            {
                int id = leaves.Unplaced.Ids[i];
                leaves.Fatten(id, out Vector3 min, out Vector3 max);
                subtrees[i] = leaves.IsInTree(id) ? leaves.Tree.SubtreeOf(id, min, max) : (byte)0;
            }
        }
    }

    /// <summary>Moves the objects of subtrees, which are numbered from 1.</summary>
    private readonly struct MoveJob(FatLeaves leaves, int[] ordered, int[] starts) : IShareJob
    {
        public void Run(int begin, int end)
        {
            for (int subtree = begin + 1; subtree <= end; subtree++)
            {
                for (int i = starts[subtree]; i < starts[subtree + 1]; i++)
                {
                    leaves.Fatten(ordered[i], out Vector3 min, out Vector3 max);
                    leaves.Tree.Move(subtree, ordered[i], min, max);
                }
            }
        }
    }
}
