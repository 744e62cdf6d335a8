namespace Gjk.Core;

/// <summary>The leaves of a tree: for each object a box that holds its own and is a little larger, so that it lasts for
/// several frames. An object that has left its leaf gets a new one before the tree is asked.</summary>
internal sealed class FatLeaves(BoundsTable table)
{
    /// <summary>Ratio to the box's side along the same axis: how much larger a leaf is on each of its two ends. More
    /// makes leaves last longer and the pairs of leaves more. A matter of speed only.</summary>
    private const float Fatness = 0.14f;

    /// <summary>Count: a leaf reaches as far as the object's last step takes it in so many frames, but no further than
    /// <see cref="Fatness"/> of the longest side; so thin things get leaves that last, too. A matter of speed
    /// only.</summary>
    private const int FramesAhead = 8;

    /// <summary>Ratio of the sums of the three sides: a leaf that is larger beside its box is replaced. Twice what a
    /// new leaf has at most: each of its sides is below 1.3 of the longest one of the box. Pinned by
    /// ShrunkenBoxTests.</summary>
    private const float MostLength = 8;

    /// <summary>Ratio: when more of the objects need new leaves, building anew is faster. A matter of speed
    /// only.</summary>
    private const int MovedPartForBuild = 3;

    /// <summary>Count: from here on it pays to bring the objects that get new leaves into an order. A matter of speed
    /// only.</summary>
    private const int LeastToOrder = 64;

    /// <summary>The objects that need a new leaf. Some of them may have been removed meanwhile.</summary>
    public IdSet Unplaced { get; } = new();
    private readonly CurveOrder _order = new(table);
    private readonly LeafMoves _moves = new();

    /// <summary>By how much an object moved along each axis when it left its leaf.</summary>
    private Vector3[] _steps = [];
    private bool[] _inTree = [];

    public AabbTree Tree { get; } = new();

    /// <summary>How the leaves are enlarged; those that are there stay as they are.</summary>
    public FatLevel Level { get; set; } = FatLevel.Motion;

    public bool IsInTree(int id) => _inTree[id];

    /// <summary>Makes room for the numbers below a capacity; nothing changes if there is no memory for it.</summary>
    public void Reserve(int capacity)
    {
        Unplaced.Reserve(capacity);
        _order.Reserve(capacity);
        _moves.Reserve(capacity);
        if (_steps.Length < capacity) Array.Resize(ref _steps, capacity);
        if (_inTree.Length < capacity) Array.Resize(ref _inTree, capacity);
    }

    public void Add(int id)
    {
        _steps[id] = default;
        Unplaced.Add(id);
    }

    /// <summary>Whether a new box, which is not in the table yet, takes an object out of its leaf. Several threads may
    /// ask about objects of their own.</summary>
    public bool Leaves(int id, in Aabb to)
    {
        if (Unplaced.Contains[id] || IsFit(to, Tree.Node(id))) return false;
        ref readonly Aabb from = ref table.Boxes[id];
        _steps[id] = Vector3.Max(Vector3.Abs(to.Min - from.Min), Vector3.Abs(to.Max - from.Max));
        return true;
    }

    public void Remove(int id)
    {
        if (_inTree[id]) Tree.Remove(id);
        _inTree[id] = false;
    }

    public void Clear()
    {
        Tree.Reset(Tree.Capacity);
        Array.Clear(_inTree, 0, _inTree.Length);
        Unplaced.Clear();
        Level = FatLevel.Motion;
    }

    /// <summary>Gives new leaves to the objects that need one, and adds them to a set.</summary>
    public void Update(IdSet placed, Workers? workers)
    {
        if (Unplaced.Count == 0) return;
        if (Unplaced.Count > table.Count / MovedPartForBuild || !TryInsertAll(placed, workers)) Build(placed);
        Unplaced.Clear();
    }

    /// <summary>Builds the whole tree; all objects get new leaves.</summary>
    public void Build(IdSet placed)
    {
        if (Tree.Capacity < table.Boxes.Length) Tree.Reset(table.Boxes.Length);
        placed.Clear();
        for (int id = 0; id < table.End; id++)
            if (table.Present[id]) placed.Add(id);
        _order.Fill(placed.Ids, placed.Count);
        for (int i = 0; i < placed.Count; i++)
        {
            int id = _order[i];
            Fatten(id, out Vector3 min, out Vector3 max);
            Tree.SetLeaf(id, min, max);
            _inTree[id] = true;
        }

        Tree.Build(_order);
        Unplaced.Clear();
    }

    /// <summary>The leaf holds the box, and the box has not become much smaller since.</summary>
    private static bool IsFit(in Aabb box, in AabbNode leaf) =>
        box.Min.X >= leaf.Min.X && box.Min.Y >= leaf.Min.Y && box.Min.Z >= leaf.Min.Z &&
        box.Max.X <= leaf.Max.X && box.Max.Y <= leaf.Max.Y && box.Max.Z <= leaf.Max.Z &&
        AabbNode.Length(leaf.Min, leaf.Max) <= MostLength * AabbNode.Length(box.Min, box.Max);

    /// <summary>Moves leaves within their subtrees, and those that leave these one by one; false where the tree becomes
    /// too deep, and has to be built anew.</summary>
    private bool TryInsertAll(IdSet placed, Workers? workers)
    {
        if (Tree.Capacity < table.Boxes.Length) Tree.Grow(table.Boxes.Length);
        Unplaced.KeepPresent(table.Present);
        for (int i = 0; i < Unplaced.Count; i++) placed.Add(Unplaced.Ids[i]);
        int[] ids = _moves.Move(this, workers, out int count);
        bool isOrdered = count >= LeastToOrder;
        if (isOrdered) _order.Fill(ids, count);
        for (int i = 0; i < count; i++)
        {
            // In order, what one object needs of the tree is in the cache from the one before.
            int id = isOrdered ? _order[i] : ids[i];
            if (_inTree[id]) Tree.Remove(id);
            Fatten(id, out Vector3 min, out Vector3 max);
            _inTree[id] = Tree.TryInsert(id, min, max);
            if (!_inTree[id]) return false;
        }

        return !Tree.IsTooDeep;
    }

    /// <summary>Rounding is monotone, so the larger box holds the box. It ends where floats do: a sweep needs finite
    /// ends.</summary>
    public void Fatten(int id, out Vector3 min, out Vector3 max)
    {
        ref readonly Aabb box = ref table.Boxes[id];
        (min, max) = (box.Min, box.Max);
        if (Level == FatLevel.None) return;
        var largest = new Vector3(float.MaxValue);
        Vector3 side = Vector3.Min(max - min, largest), fat = side * Fatness;
        if (Level == FatLevel.Motion)
        {
            var most = new Vector3(Fatness * Math.Max(Math.Max(side.X, side.Y), side.Z));
            fat = Vector3.Max(fat, Vector3.Min(most, Vector3.Min(_steps[id], largest) * FramesAhead));
        }

        min = Vector3.Max(min - fat, -largest);
        max = Vector3.Min(max + fat, largest);
    }
}

/// <summary>What the leaves of a tree are enlarged by.</summary>
internal enum FatLevel
{
    /// <summary>By nothing: leaves are the objects' boxes.</summary>
    None = 0,

    /// <summary>Along each axis by a part of the side.</summary>
    Side,

    /// <summary>By that, or along the object's motion as far as it goes in a few frames.</summary>
    Motion,
}
