using System;
using System.Numerics;

namespace Gjk.Core;

/// <summary>
/// The ends of all boxes along one axis, sorted. An end is one number: its place, as an integer that orders as the
/// float does, then whether it is the upper one, then the object. A lower end comes before an upper one at the same
/// place, so touching boxes overlap; the margin is added to the upper ends.
/// </summary>
internal sealed class EndpointAxis(int axis)
{
    private const uint UpperBit = 0x80000000u;

    public int Count;

    private ulong[] _ends = [];

    /// <summary>
    /// Puts all objects in, sorted from scratch: the lower ends first, each half by number, as the stable sort needs
    /// it.
    /// </summary>
    public void Fill(BoundsTable table, float margin, ref ulong[] scratch, int[] histograms)
    {
        if (_ends.Length < scratch.Length) _ends = new ulong[scratch.Length];
        Count = 0;
        for (int id = 0; id < table.End; id++)
            if (table.Present[id]) _ends[Count++] = Lower(table.Boxes[id].Min, id);
        for (int id = 0; id < table.End; id++)
            if (table.Present[id]) _ends[Count++] = Upper(table.Boxes[id].Max, margin, id);
        SortKeys.Sort(ref _ends, ref scratch, histograms, Count);
    }

    /// <summary>The ends where they are now, in the old order.</summary>
    public void Refresh(BoundsTable table, float margin)
    {
        for (int i = 0; i < Count; i++)
        {
            int id = Id(_ends[i]);
            _ends[i] = IsUpper(_ends[i]) ? Upper(table.Boxes[id].Max, margin, id) : Lower(table.Boxes[id].Min, id);
        }
    }

    /// <summary>Adds an object as if it had been beyond all others.</summary>
    public void Append(BoundsTable table, float margin, int id)
    {
        if (_ends.Length < Count + 2) Array.Resize(ref _ends, BoundsTable.Grown(_ends.Length, Count + 1));
        _ends[Count++] = Lower(table.Boxes[id].Min, id);
        _ends[Count++] = Upper(table.Boxes[id].Max, margin, id);
    }

    public void DropUnlisted(bool[] listed)
    {
        int kept = 0;
        for (int i = 0; i < Count; i++)
            if (listed[Id(_ends[i])]) _ends[kept++] = _ends[i];
        Count = kept;
    }

    /// <summary>
    /// Sorts what is nearly sorted. Every two ends that change places do so once, with both already at their new place;
    /// of these, a lower end that passes an upper one may begin a pair, if the boxes overlap on all axes.
    /// </summary>
    /// <param name="table">The boxes as they are now.</param>
    /// <param name="margin">As in the ends.</param>
    /// <param name="begun">Gets the pairs; those that begin on several axes at once come several times.</param>
    /// <param name="swaps">How many exchanges are left; is reduced.</param>
    /// <returns>False when they were used up; the order is then of no use.</returns>
    public bool InsertionSort(BoundsTable table, float margin, PairKeys begun, ref long swaps)
    {
        ulong[] ends = _ends;
        Aabb[] boxes = table.Boxes;
        for (int i = 1; i < Count; i++)
        {
            ulong end = ends[i];
            int to = i;
            bool lower = !IsUpper(end);
            for (; to > 0 && ends[to - 1] > end; to--)
            {
                ulong passed = ends[to - 1];
                ends[to] = passed;
                if (lower && IsUpper(passed) && BoundsTable.Near(boxes[Id(end)], boxes[Id(passed)], margin))
                    begun.Add(PairKeys.Key(Id(end), Id(passed)));
            }

            ends[to] = end;
            swaps -= i - to;
            if (swaps < 0) return false;
        }

        return true;
    }

    private static int Id(ulong end) => (int)((uint)end & ~UpperBit);

    private static bool IsUpper(ulong end) => ((uint)end & UpperBit) != 0;

    private ulong Lower(Vector3 min, int id) =>
        (ulong)SortKeys.Ordered(AxisSweep.Component(min, axis)) << 32 | (uint)id;

    private ulong Upper(Vector3 max, float margin, int id) =>
        (ulong)SortKeys.Ordered(AxisSweep.Component(max, axis) + margin) << 32 | (uint)id | UpperBit;
}
