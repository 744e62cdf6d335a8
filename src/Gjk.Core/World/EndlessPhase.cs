namespace Gjk.Core;

/// <summary>A scene's broad phase: what has no end, as a half-space, is in a list, and everything is near it; a broad
/// phase holds the rest.</summary>
internal sealed class EndlessPhase(IBroadPhase bounded, SceneObjects objects)
{
    private readonly List<int> _endless = [];

    /// <summary>What holds the objects that end.</summary>
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
    public void Exchange(int id, in Aabb bounds)
    {
        if (_endless.Contains(id) == ShapeBounds.IsEndless(bounds))
        {
            Move(id, bounds);
            return;
        }

        Remove(id);
        Add(id, bounds);
    }

    /// <summary>Moves what has a number; negative ones are left out, and none is there twice. What has no end stays
    /// where it is, and loses its number.</summary>
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

    /// <summary>Two half-spaces are no pair.</summary>
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
