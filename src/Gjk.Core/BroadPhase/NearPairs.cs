namespace Gjk.Core;

/// <summary>Selects pairs whose boxes are near.</summary>
/// <param name="boxes">By object.</param>
/// <param name="keys">The pairs.</param>
/// <param name="margin">How far apart boxes are near.</param>
/// <param name="isMarking">Whether the pairs get marks: whether they are near.</param>
/// <param name="moved">Which objects have other boxes than when the pairs were marked; the marks of the rest say
/// whether they are near. Null where there are no marks.</param>
internal readonly struct NearPairs(Aabb[] boxes, ulong[] keys, float margin, bool isMarking, bool[]? moved)
    : ISelector<ObjectPair>
{
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool TrySelect(int index, out ObjectPair item)
    {
        ulong key = keys[index];
        int a = PairKeys.First(key), b = PairKeys.Second(key);
        item = new ObjectPair(a, b);
        bool isNear = moved is not null && !moved[a] && !moved[b]
            ? PairKeys.IsMarked(key)
            : BoundsTable.Near(boxes[a], boxes[b], margin);
        if (isMarking) keys[index] = PairKeys.Marked(key, isNear);
        return isNear;
    }
}
