namespace Gjk.Core;

/// <summary>Sorts a part of an array of keys in place, without allocating. On Mono <see cref="Array"/>'s own sort makes
/// a delegate in each call, so the netstandard builds have a heap sort (Williams 1964): n log n whatever the order, and
/// equal keys cannot be told apart, so that both give the same result.</summary>
internal static class InPlaceSort
{
    public static void Sort(ulong[] keys, int start, int count)
    {
#if NET
        Array.Sort(keys, start, count);
#else
        for (int root = count / 2 - 1; root >= 0; root--) SiftDown(keys, start, root, count);
        for (int last = count - 1; last > 0; last--)
        {
            (keys[start], keys[start + last]) = (keys[start + last], keys[start]);
            SiftDown(keys, start, 0, last);
        }
#endif
    }

    /// <summary>Sorts a list whose order leaves no two elements equal.</summary>
    public static void Sort<T>(List<T> items)
        where T : IComparable<T>
    {
#if NET
        items.Sort();
#else
        for (int root = items.Count / 2 - 1; root >= 0; root--) SiftDown(items, root, items.Count);
        for (int last = items.Count - 1; last > 0; last--)
        {
            (items[0], items[last]) = (items[last], items[0]);
            SiftDown(items, 0, last);
        }
#endif
    }

#if !NET
    private static void SiftDown<T>(List<T> items, int root, int count)
        where T : IComparable<T>
    {
        T item = items[root];
        while (true)
        {
            int child = 2 * root + 1;
            if (child >= count) break;
            if (child + 1 < count && items[child + 1].CompareTo(items[child]) > 0) child++;
            if (items[child].CompareTo(item) <= 0) break;
            items[root] = items[child];
            root = child;
        }

        items[root] = item;
    }

    /// <summary>Lets a key sink until no child is larger.</summary>
    private static void SiftDown(ulong[] keys, int start, int root, int count)
    {
        ulong key = keys[start + root];
        while (true)
        {
            int child = 2 * root + 1;
            if (child >= count) break;
            if (child + 1 < count && keys[start + child + 1] > keys[start + child]) child++;
            if (keys[start + child] <= key) break;
            keys[start + root] = keys[start + child];
            root = child;
        }

        keys[start + root] = key;
    }
#endif
}
