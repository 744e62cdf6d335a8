namespace Gjk.Core;

/// <summary>Many leaves are moved at once: the tree is cut into subtrees, and a leaf that stays in its subtree changes
/// nothing but that. So several threads may work, each in subtrees of its own, and the tree is the same for any number
/// of them.</summary>
internal sealed partial class AabbTree
{
    /// <summary>Count: subtrees that the tree is cut into at most; enough to share among many threads, and few enough
    /// that most leaves that move stay in theirs. A matter of speed only.</summary>
    public const int MostSubtrees = 64;

    /// <summary>Levels: lower subtrees are not cut any more. A matter of speed only.</summary>
    private const int LeastHeight = 4;

    /// <summary>The roots of the subtrees, which are numbered from 1.</summary>
    private readonly int[] _subtrees = new int[MostSubtrees + 1];
    private int _subtreeCount;

    /// <summary>By node: the subtree whose root it is, or 0.</summary>
    private byte[] _subtreeAt = [];

    /// <summary>Cuts the tree, always through the highest subtree.</summary>
    /// <returns>False where it is too low.</returns>
    public bool TryCut()
    {
        _subtreeCount = 0;
        if (_root < _leafEnd || _heights[_root] < LeastHeight) return false;
        _subtrees[++_subtreeCount] = _root;
        while (_subtreeCount < MostSubtrees)
        {
            int highest = 1;
            for (int i = 2; i <= _subtreeCount; i++)
                if (_heights[_subtrees[i]] > _heights[_subtrees[highest]]) highest = i;
            int node = _subtrees[highest];
            if (_heights[node] < LeastHeight) break;
            _subtrees[highest] = _nodes[node].Left;
            _subtrees[++_subtreeCount] = _nodes[node].Right;
        }

        if (_subtreeAt.Length < _nodes.Length) _subtreeAt = new byte[_nodes.Length];
        for (int i = 1; i <= _subtreeCount; i++) _subtreeAt[_subtrees[i]] = (byte)i;
        return true;
    }

    /// <summary>The subtree that a leaf of the tree is in and stays in with a new box; 0 for none. Several threads may
    /// ask at once.</summary>
    public byte SubtreeOf(int leaf, Vector3 min, Vector3 max)
    {
        int node = leaf;
        while (node != None && _subtreeAt[node] == 0) node = _parents[node];
        if (node == None || node == leaf) return 0;
        ref readonly AabbNode box = ref _nodes[node];
        bool isInside = Vector3.Min(box.Min, min) == box.Min && Vector3.Max(box.Max, max) == box.Max;
        return isInside ? _subtreeAt[node] : (byte)0;
    }

    /// <summary>From now on leaves are moved, and not asked about.</summary>
    public void BeginMoves()
    {
        for (int i = 1; i <= _subtreeCount; i++) _subtreeAt[_subtrees[i]] = 0;
    }

    /// <summary>Moves a leaf within its subtree. Several threads may do this in subtrees of their own.</summary>
    public void Move(int subtree, int leaf, Vector3 min, Vector3 max)
    {
        ref int root = ref _subtrees[subtree];
        int top = _parents[root];
        int spare = Detach(leaf, ref root, top);
        Attach(leaf, min, max, spare, ref root, top);
    }

    /// <summary>Makes the subtrees one tree again: the boxes above them.</summary>
    public void EndMoves()
    {
        for (int i = 1; i <= _subtreeCount; i++)
            for (int node = _parents[_subtrees[i]]; node != None; node = _parents[node]) Enclose(node);
    }
}
