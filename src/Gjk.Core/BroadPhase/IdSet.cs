namespace Gjk.Core;

/// <summary>A set of object numbers, listed in the order in which they came. A number is listed once, however often it
/// is added, so the list is never longer than the table of objects.</summary>
internal sealed class IdSet
{
    /// <summary>The numbers; the first <see cref="Count"/> are valid.</summary>
    public int[] Ids = [];

    /// <summary>Whether a number is in the set, by number.</summary>
    public bool[] Contains = [];

    public int Count;

    /// <summary>Makes room for the numbers below a capacity.</summary>
    public void Reserve(int capacity)
    {
        if (Contains.Length >= capacity) return;
        Array.Resize(ref Ids, capacity);
        Array.Resize(ref Contains, capacity);
    }

    public void Add(int id)
    {
        if (Contains[id]) return;
        Contains[id] = true;
        Ids[Count++] = id;
    }

    /// <summary>Drops the numbers of objects that are not there.</summary>
    public void KeepPresent(bool[] present)
    {
        int kept = 0;
        for (int i = 0; i < Count; i++)
        {
            int id = Ids[i];
            Contains[id] = present[id];
            if (present[id]) Ids[kept++] = id;
        }

        Count = kept;
    }

    public void Clear()
    {
        for (int i = 0; i < Count; i++) Contains[Ids[i]] = false;
        Count = 0;
    }
}
