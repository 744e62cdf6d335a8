namespace Gjk.Core;

/// <summary>Warm starts by pair, for questions about single pairs: an open-addressing table (Knuth, volume 3, section
/// 6.4, algorithm L) that forgets what was not asked for in the last frame.</summary>
internal sealed class WarmStartTable
{
    private const int FirstCapacity = 64;

    /// <summary>Count: a table this long, 16 MB, is emptied rather than doubled; else asking for ever more pairs of a
    /// scene at rest would fill the memory.</summary>
    private const int MaxCapacity = 1 << 18;

    /// <summary>2^64 divided by the golden ratio, which spreads multiples evenly (Knuth, section 6.4).</summary>
    private const ulong Spreading = 0x9E3779B97F4A7C15UL;

    private Entry[] _entries = new Entry[FirstCapacity];
    private Entry[] _spare = new Entry[FirstCapacity];

    /// <summary>How many pairs it remembers, those included that it will forget at its next growth.</summary>
    public int Count { get; private set; }

    /// <summary>The pair's warm start, cold where there was none.</summary>
    /// <param name="key">The pair; not 0, which no pair of two objects is.</param>
    /// <param name="frame">The frame; what was last asked for before the one before it may be forgotten.</param>
    public ref WarmStart Find(ulong key, int frame)
    {
        if (2 * Count >= _entries.Length) Renew(frame);
        ref Entry entry = ref Slot(_entries, key);
        if (entry.Key == 0)
        {
            entry.Key = key;
            entry.Start = default;
            Count++;
        }

        entry.Frame = frame;
        return ref entry.Start;
    }

    private static ref Entry Slot(Entry[] entries, ulong key)
    {
        int mask = entries.Length - 1;
        int i = (int)((key * Spreading) >> 32) & mask;
        while (entries[i].Key != 0 && entries[i].Key != key) i = (i + 1) & mask;
        return ref entries[i];
    }

    /// <summary>Keeps what is recent, in a table that it fills to a quarter at most.</summary>
    private void Renew(int frame)
    {
        int recent = 0;
        foreach (Entry entry in _entries)
            if (IsRecent(entry, frame)) recent++;
        int capacity = _entries.Length;
        while (4 * recent > capacity && capacity < MaxCapacity) capacity *= 2;
        if (4 * recent > capacity) recent = 0;
        if (_spare.Length != capacity) _spare = new Entry[capacity];
        else Array.Clear(_spare, 0, capacity);
        if (recent > 0)
        {
            foreach (Entry entry in _entries)
                if (IsRecent(entry, frame)) Slot(_spare, entry.Key) = entry;
        }

        (_entries, _spare) = (_spare, _entries);
        Count = recent;
    }

    /// <summary>Frames are counted modulo 2^32.</summary>
    private static bool IsRecent(in Entry entry, int frame) => entry.Key != 0 && (uint)(frame - entry.Frame) <= 1;

    private struct Entry
    {
        public ulong Key;
        public int Frame;
        public WarmStart Start;
    }
}
