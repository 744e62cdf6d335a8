namespace Gjk.Core;

/// <summary>A growable array of pairs, each packed as A in the upper half and B in the lower one, above a bit for a
/// mark, so that the order of the numbers is the order of the pairs.</summary>
internal sealed class PairKeys
{
    /// <summary>Count: buckets up to this length are sorted by insertion.</summary>
    private const int ShortBucket = 24;

    /// <summary>The bucket sort passes over all objects; it pays from one pair per this many objects on.</summary>
    private const int ObjectsPerPair = 8;

    /// <summary>Count: how many pairs fit; 8 GB, twice that while they are sorted.</summary>
    public const int MostPairs = 1 << 30;

    public ulong[] Keys = new ulong[16];
    public int Count;

    /// <summary>How many pairs may be added: less in tests.</summary>
    public int Limit = MostPairs;

    private ulong[] _sorted = [];
    private int[] _starts = [];

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static ulong Key(int a, int b) =>
        a < b ? (ulong)(uint)a << 32 | (uint)b << 1 : (ulong)(uint)b << 32 | (uint)a << 1;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int First(ulong key) => (int)(key >> 32);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int Second(ulong key) => (int)((uint)key >> 1);

    /// <summary>The key with its mark set, or without.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static ulong Marked(ulong key, bool mark) => mark ? key | 1 : key & ~1ul;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool IsMarked(ulong key) => (key & 1) != 0;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Add(ulong key)
    {
        if (Count == Keys.Length || Count >= Limit) MakeRoom(Count + 1L);
        Keys[Count++] = key;
    }

    /// <summary>For more pairs than fit.</summary>
    private static InvalidOperationException TooMany(int limit) =>
        new(FormattableString.Invariant($"There are more than {limit} pairs, more than a broad phase can hold."));

    /// <summary>Sorts; the objects' numbers are below the given end.</summary>
    public void Sort(int end)
    {
        if (Count < end / ObjectsPerPair || Count <= ShortBucket) InPlaceSort.Sort(Keys, 0, Count);
        else SortByBuckets(end);
    }

    public void Append(PairKeys other)
    {
        MakeRoom((long)Count + other.Count);
        Array.Copy(other.Keys, 0, Keys, Count, other.Count);
        Count += other.Count;
    }

    /// <summary>Merges sorted keys into these sorted ones; none of them may be in both.</summary>
    public void Merge(PairKeys other)
    {
        MakeRoom((long)Count + other.Count);
        int total = Count + other.Count;
        for (int i = Count - 1, j = other.Count - 1, to = total - 1; j >= 0; to--)
            Keys[to] = i >= 0 && Keys[i] > other.Keys[j] ? Keys[i--] : other.Keys[j--];
        Count = total;
    }

    public void CopyTo(List<ObjectPair> pairs)
    {
        for (int i = 0; i < Count; i++) pairs.Add(new ObjectPair(First(Keys[i]), Second(Keys[i])));
    }

    private void MakeRoom(long count)
    {
        if (count > Limit) throw TooMany(Limit);
        if (count > Keys.Length) Array.Resize(ref Keys, (int)Math.Min(Math.Max(2L * Keys.Length, count), MostPairs));
    }

    /// <summary>A counting sort by A; then each A's pairs, usually a handful, by B.</summary>
    private void SortByBuckets(int end)
    {
        if (_starts.Length <= end) _starts = new int[BoundsTable.Grown(_starts.Length, end)];
        if (_sorted.Length < Keys.Length) _sorted = new ulong[Keys.Length];
        Array.Clear(_starts, 0, end + 1);
        for (int i = 0; i < Count; i++) _starts[First(Keys[i])]++;
        for (int a = 0, sum = 0; a <= end; a++) (_starts[a], sum) = (sum, sum + _starts[a]);
        for (int i = 0; i < Count; i++) _sorted[_starts[First(Keys[i])]++] = Keys[i];
        (Keys, _sorted) = (_sorted, Keys);
        for (int a = 0, start = 0; a < end; start = _starts[a++]) SortBucket(start, _starts[a]);
    }

    private void SortBucket(int start, int end)
    {
        if (end - start > ShortBucket)
        {
            InPlaceSort.Sort(Keys, start, end - start);
            return;
        }

        for (int i = start + 1; i < end; i++)
        {
            ulong key = Keys[i];
            int to = i;
            for (; to > start && Keys[to - 1] > key; to--) Keys[to] = Keys[to - 1];
            Keys[to] = key;
        }
    }
}
