namespace Gjk.Core;

/// <summary>A priority queue of pairs of boxes, the least bound first: a binary heap (Williams 1964).</summary>
/// <remarks>Equal bounds leave in an order that depends on the order of the calls alone.</remarks>
internal sealed class PartHeap
{
    private Entry[] _entries = new Entry[256];

    /// <summary>How many pairs wait.</summary>
    public int Count { get; private set; }

    /// <summary>A pair of boxes, each as eight times its node plus its lane, and a lower bound for it.</summary>
    public struct Entry
    {
        public int A, B;
        public float Bound;
    }

    public void Clear() => Count = 0;

    public void Push(int a, int b, float bound)
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

    /// <summary>Pushes the pairs of one box with each of the eight below the other.</summary>
    /// <param name="pair">The two boxes.</param>
    /// <param name="isA">Whether the box of A is the opened one.</param>
    /// <param name="children">The children of the opened box's tree.</param>
    /// <param name="bounds">The bounds of the eight pairs.</param>
    /// <param name="reached">Pairs with larger bounds are left out.</param>
    public unsafe void PushChildren(in Entry pair, bool isA, int[] children, float* bounds, float reached)
    {
        int first = PartTree.Lanes * children[isA ? pair.A : pair.B];
        for (int i = 0; i < PartTree.Lanes; i++)
        {
            if (!(bounds[i] <= reached) || children[first + i] == PartTree.Empty) continue;
            Push(isA ? first + i : pair.A, isA ? pair.B : first + i, bounds[i]);
        }
    }

    public bool TryPop(out Entry top)
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
