namespace Gjk.Core;

/// <summary>A scene's broad phase. Half-spaces, which have no end, are in a list and near every object. Another broad
/// phase holds the rest.</summary>
internal sealed class EndlessPhase(IBroadPhase bounded, SceneObjects objects)
{
    private readonly List<int> _endless = [];

    /// <summary>The broad phase of the objects that end.</summary>
    public IBroadPhase Bounded => bounded;

    public int Count => bounded.Count + _endless.Count;

    public void Add(int id, in Aabb bounds)
    {
        if (ShapeBounds.IsEndless(bounds)) _endless.Add(id);
        else bounded.Add(id, bounds);
    }

    public void Move(int id, in Aabb bounds)
    {
        if (!_endless.Contains(id)) bounded.Move(id, bounds);
    }

    /// <summary>Gives an object the box of another shape, which may have an end where the old one had none.</summary>
    public void ReplaceBounds(int id, in Aabb bounds)
    {
        if (_endless.Contains(id) == ShapeBounds.IsEndless(bounds))
        {
            Move(id, bounds);
            return;
        }

        Remove(id);
        Add(id, bounds);
    }

    /// <summary>Moves objects. Negative ids are skipped, and no id is there twice. Objects without an end keep their
    /// place, and their ids are set to <see cref="SceneMoves.None"/>.</summary>
    public void MoveAll(int[] ids, Aabb[] bounds, int count, Workers? workers)
    {
        for (int i = 0; _endless.Count > 0 && i < count; i++)
            if (_endless.Contains(ids[i])) ids[i] = SceneMoves.None;
        if (bounded is DynamicAabbTree tree)
        {
            tree.MoveAll(ids, bounds, count, workers);
            return;
        }

        for (int i = 0; i < count; i++)
            if (ids[i] >= 0) bounded.Move(ids[i], bounds[i]);
    }

    public void Remove(int id)
    {
        if (!_endless.Remove(id)) bounded.Remove(id);
    }

    public void Clear()
    {
        _endless.Clear();
        bounded.Clear();
    }

    /// <summary>Collects the pairs within a margin. Two half-spaces are no pair.</summary>
    public void CollectPairs(float margin, List<ObjectPair> pairs, Workers? workers)
    {
        if (bounded is DynamicAabbTree tree) tree.CollectPairs(margin, pairs, workers);
        else bounded.CollectPairs(margin, pairs);
        if (_endless.Count == 0) return;
        foreach (int one in _endless)
        {
            for (int slot = 0; slot < objects.End; slot++)
            {
                if (objects.Alive[slot] && !_endless.Contains(slot))
                    pairs.Add(new ObjectPair(Math.Min(one, slot), Math.Max(one, slot)));
            }
        }

        InPlaceSort.Sort(pairs);
    }

    public void CollectInBox(in Aabb box, List<int> ids)
    {
        bounded.CollectInBox(box, ids);
        if (_endless.Count == 0) return;
        ids.AddRange(_endless);
        InPlaceSort.Sort(ids);
    }

    public void Sweep<TVisitor>(in SweptBox path, ref TVisitor visitor)
        where TVisitor : struct, ISweepVisitor
    {
        foreach (int one in _endless) visitor.Visit(one);
        bounded.Sweep(path, ref visitor);
    }
}
