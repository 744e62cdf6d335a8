namespace Gjk.Core;

/// <summary>Objects by size, and those of similar size in their order along a Morton curve through the centres of their
/// boxes: what is near in this order is near in space, and no large box is among small ones, where it would enlarge all
/// nodes above it. A tree is built by splitting the order. Parts of it are ordered anew on the way down: objects that
/// share a cell, along a curve through that cell alone, so that one distant object does not make all the others equal;
/// objects that are much larger or smaller than most, among themselves.</summary>
internal sealed class CurveOrder(BoundsTable table)
{
    /// <summary>Count: up to so many objects of one cell are split as they come. A matter of speed only.</summary>
    private const int FewInCell = 4;

    /// <summary>Powers of two: sides that differ by no more from the geometric mean of the longest sides are similar.
    /// Wide enough for the objects of most scenes, and so a matter of speed only.</summary>
    private const int SimilarSize = 3;

    /// <summary>Bits of a float below its exponent.</summary>
    private const int FractionBits = 23;

    private const int SizeShift = 32 + 3 * MortonCurve.BitsPerAxis;
    private const ulong Smaller = 0;
    private const ulong Similar = 1;
    private const ulong Larger = 2;

    private readonly int[] _histograms = new int[SortKeys.HistogramLength];

    /// <summary>The size and the cell in the upper half, the object in the lower.</summary>
    private ulong[] _keys = [];
    private ulong[] _scratch = [];

    /// <summary>How many objects there are in the order.</summary>
    public int Count { get; private set; }

    /// <summary>The object at a place.</summary>
    public int this[int place] => (int)(uint)_keys[place];

    public void Reserve(int capacity)
    {
        if (_keys.Length >= capacity) return;
        ulong[] keys = new ulong[capacity], scratch = new ulong[capacity];
        (_keys, _scratch) = (keys, scratch);
    }

    /// <summary>Orders some of the objects.</summary>
    public void Fill(int[] ids, int count)
    {
        for (int i = 0; i < count; i++) _keys[i] = (uint)ids[i];
        Count = count;
        if (count == 0) return;
        SetCells(0, count);
        SortKeys.Sort(ref _keys, ref _scratch, _histograms, count);
    }

    /// <summary>Where to split a part of the order: between sizes, or where the highest bit changes in which the cells
    /// of its ends differ, and in the middle where all centres are the same.</summary>
    public int Split(int begin, int end)
    {
        if (end - begin > FewInCell && (IsOneCell(begin, end) || IsUnusualSize(begin, end)))
        {
            SetCells(begin, end);
            InPlaceSort.Sort(_keys, begin, end - begin);
        }

        return MortonCurve.Split(_keys, begin, end);
    }

    private bool IsOneCell(int begin, int end) => _keys[begin] >> 32 == _keys[end - 1] >> 32;

    /// <summary>All of them are smaller, or all are larger, than most of those that were ordered with them.</summary>
    private bool IsUnusualSize(int begin, int end)
    {
        ulong size = _keys[begin] >> SizeShift;
        return size != Similar && size == _keys[end - 1] >> SizeShift;
    }

    /// <summary>The sizes and cells of a part of the objects, on a curve that their centres fill.</summary>
    private void SetCells(int begin, int end)
    {
        // Sums of two floats: twice the centres, exact in double but for the last bits.
        var low = new Double3(double.MaxValue, double.MaxValue, double.MaxValue);
        Double3 high = -low;
        long exponents = 0;
        for (int i = begin; i < end; i++)
        {
            Double3 centre = Centre(i);
            low = new Double3(Math.Min(low.X, centre.X), Math.Min(low.Y, centre.Y), Math.Min(low.Z, centre.Z));
            high = new Double3(Math.Max(high.X, centre.X), Math.Max(high.Y, centre.Y), Math.Max(high.Z, centre.Z));
            exponents += Exponent(i);
        }

        Double3 sides = high - low;
        double perX = MortonCurve.PerUnit(sides.X), perY = MortonCurve.PerUnit(sides.Y);
        double perZ = MortonCurve.PerUnit(sides.Z);
        var perUnit = new Double3(perX, perY, perZ);
        int mean = (int)(exponents / (end - begin));
        for (int i = begin; i < end; i++)
        {
            int difference = Exponent(i) - mean;
            ulong size = difference > SimilarSize ? Larger : difference < -SimilarSize ? Smaller : Similar;
            ulong cell = MortonCurve.Cell(Centre(i), low, perUnit);
            _keys[i] = size << SizeShift | cell << 32 | (uint)_keys[i];
        }
    }

    /// <summary>The power of two of the longest side, as the bits of a float have it.</summary>
    private int Exponent(int place)
    {
        ref readonly Aabb box = ref table.Boxes[this[place]];
        System.Numerics.Vector3 side = box.Max - box.Min;
        return (int)(SortKeys.Ordered(Math.Max(Math.Max(side.X, side.Y), side.Z)) >> FractionBits);
    }

    private Double3 Centre(int place)
    {
        ref readonly Aabb box = ref table.Boxes[this[place]];
        return (Double3)box.Min + box.Max;
    }
}
