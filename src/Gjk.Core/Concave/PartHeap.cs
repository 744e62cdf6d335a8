namespace Gjk.Core;

/// <summary>Pairs of boxes that wait, the least bound first: a binary heap (Williams 1964).</summary>
/// <remarks>Equal bounds leave in an order that depends on the order of the calls alone.</remarks>
internal sealed class PartHeap
{
    private Entry[] _entries = new Entry[256];

    /// <summary>How many wait.</summary>
    public int Count { get; private set; }

    /// <summary>Two boxes, each as eight times its node and the lane, and a bound of theirs.</summary>
    public struct Entry
    {
        public int A, B;
        public float Bound;
    }

    public void Clear() => Count = 0;

    public void Add(int a, int b, float bound)
    {
        if (Count + 1 >= _entries.Length) Array.Resize(ref _entries, 2 * _entries.Length);
        Entry[] entries = _entries;
        int at = ++Count;
        while (at > 1 && entries[at >> 1].Bound > bound)
        {
            entries[at] = entries[at >> 1];
            at >>= 1;
        }

        entries[at].A = a;
        entries[at].B = b;
        entries[at].Bound = bound;
    }

    /// <summary>Adds the pairs of one box with each of the eight below the other.</summary>
    /// <param name="pair">The two boxes.</param>
    /// <param name="isA">Whether A's is opened.</param>
    /// <param name="children">Of the tree whose box is opened.</param>
    /// <param name="bounds">Of the eight pairs.</param>
    /// <param name="reached">Those with larger bounds cannot matter.</param>
    public unsafe void AddBelow(in Entry pair, bool isA, int[] children, float* bounds, float reached)
    {
        int first = PartTree.Lanes * children[isA ? pair.A : pair.B];
        for (int i = 0; i < PartTree.Lanes; i++)
        {
            if (!(bounds[i] <= reached) || children[first + i] == PartTree.Empty) continue;
            Add(isA ? first + i : pair.A, isA ? pair.B : first + i, bounds[i]);
        }
    }

    public bool TryTake(out Entry top)
    {
        Entry[] entries = _entries;
        top = entries[1];
        if (Count == 0) return false;
        Entry last = entries[Count--];
        int at = 1;
        while (2 * at <= Count)
        {
            int child = 2 * at;
            if (child < Count && entries[child + 1].Bound < entries[child].Bound) child++;
            if (entries[child].Bound >= last.Bound) break;
            entries[at] = entries[child];
            at = child;
        }

        entries[at] = last;
        return true;
    }
}
