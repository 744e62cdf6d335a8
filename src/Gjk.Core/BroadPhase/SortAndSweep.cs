namespace Gjk.Core;

/// <summary>The broad phase that sorts the boxes along one axis each time it is asked, the one along which they are
/// spread most for their size, and compares each with those that begin before it ends (Baraff 1992; Ericson 2004,
/// section 7.5.2). It keeps nothing between frames, so motion of any size costs the same.</summary>
/// <remarks>Mutable and not thread-safe. Every two boxes that overlap along that axis are compared. So the time grows
/// with n log n in a long row, with n^(5/3) in a cube of constant density, and with n² where no axis tells boxes apart:
/// rods in all three directions, or a few hundred boxes in one place along the axis and apart along the
/// others.</remarks>
public sealed class SortAndSweep : IBroadPhase
{
    /// <summary>Boxes compared at once, and the padding of the sorted arrays.</summary>
    private const int Width = 8;

    /// <summary>Ratio to n^(5/3), what a cube of boxes that touch a few others needs: what needs more on one axis may
    /// need less on another. A matter of speed only.</summary>
    private const double UsualComparisons = 4;

    private readonly BoundsTable _table = new();
    private readonly PairKeys _found = new();
    private readonly int[] _histograms = new int[SortKeys.HistogramLength];
    private ulong[] _order = [];
    private ulong[] _scratch = [];
    private int[] _ids = [];

    // In sorted order, u along the sweep's axis; the upper ends have the margin added.
    private float[] _minU = [];
    private float[] _maxU = [];
    private float[] _minV = [];
    private float[] _maxV = [];
    private float[] _minW = [];
    private float[] _maxW = [];

    /// <inheritdoc/>
    public int Count => _table.Count;

    /// <summary>How many pairs of boxes were compared, for the tests of cost.</summary>
    internal long Comparisons { get; private set; }

    /// <summary>How many pairs may be found: less in tests.</summary>
    internal int PairLimit
    {
        set => _found.Limit = value;
    }

    /// <inheritdoc/>
    public void Add(int id, in Aabb bounds) => _table.Add(id, bounds);

    /// <inheritdoc/>
    public void Move(int id, in Aabb bounds) => _table.Move(id, bounds);

    /// <inheritdoc/>
    public void Remove(int id) => _table.Remove(id);

    /// <inheritdoc/>
    public void Clear() => _table.Clear();

    /// <inheritdoc/>
    public void CollectPairs(float margin, List<ObjectPair> pairs)
    {
        BoundsTable.CheckQuery(margin, pairs);
        _found.Count = 0;
        Collect(margin);
        _found.Sort(_table.End);
        _found.CopyTo(pairs);
    }

    /// <inheritdoc/>
    public void CollectInBox(in Aabb box, List<int> ids) => _table.CollectInBox(box, ids);

    /// <inheritdoc/>
    public void Sweep<TVisitor>(in SweptBox path, ref TVisitor visitor)
        where TVisitor : struct, ISweepVisitor => _table.Sweep(path, ref visitor);

    /// <summary>Finds every pair of boxes that overlap with the margin, in no useful order.</summary>
    private void Collect(float margin)
    {
        Reserve();
        int axis = LargestSpread(_table, margin);
        long most = (long)(UsualComparisons * Math.Pow(_table.Count, 5 / 3.0));

        // Few outliers can make an axis look good along which most boxes overlap. Then the others are tried.
        for (int i = 0; i < 3; i++)
        {
            if (TrySweep((axis + i) % 3, margin, most)) return;
        }

        TrySweep(axis, margin, long.MaxValue);
    }

    private bool TrySweep(int axis, float margin, long most)
    {
        int n = 0;
        _found.Count = 0;
        for (int id = 0; id < _table.End; id++)
        {
            if (!_table.Present[id]) continue;
            _order[n++] = (ulong)SortKeys.Ordered(Component(_table.Boxes[id].Min, axis)) << 32 | (uint)id;
        }

        SortKeys.Sort(ref _order, ref _scratch, _histograms, n);
        Gather(axis, margin, n);
        long left = most;
        for (int i = 0; i < n && left >= 0; i++) left -= SweepOne(i, n);
        Comparisons += most - left;
        return left >= 0;
    }

    private static float Component(in System.Numerics.Vector3 v, int axis) => axis == 0 ? v.X : axis == 1 ? v.Y : v.Z;

    private static double Component(in Double3 v, int axis) => axis == 0 ? v.X : axis == 1 ? v.Y : v.Z;

    /// <summary>The axis along which the fewest boxes overlap by chance: the one with the most standard deviation of
    /// the centres for each unit of the mean side.</summary>
    private static int LargestSpread(BoundsTable table, float margin)
    {
        Double3 sum = default, squares = default, sides = default;
        for (int id = 0; id < table.End; id++)
        {
            if (!table.Present[id]) continue;
            ref readonly Aabb box = ref table.Boxes[id];
            Double3 centre = (Double3)box.Min + box.Max;
            sum += centre;
            squares += Double3.Multiply(centre, centre);
            sides += (Double3)box.Max - box.Min;
        }

        double n = table.Count;
        Double3 spread = squares * n - Double3.Multiply(sum, sum);
        var reach = new Double3(sides.X + n * margin, sides.Y + n * margin, sides.Z + n * margin);
        int best = IsBetter(spread.Y, reach.Y, spread.X, reach.X) ? 1 : 0;
        return IsBetter(spread.Z, reach.Z, Component(spread, best), Component(reach, best)) ? 2 : best;
    }

    /// <summary>Compares variances for each squared side; by the variances alone where the sides are 0 or
    /// infinite.</summary>
    private static bool IsBetter(double spread, double reach, double otherSpread, double otherReach)
    {
        double ratio = spread * otherReach * otherReach, other = otherSpread * reach * reach;
        return ratio > other || (!(ratio < other) && spread > otherSpread);
    }

    private void Reserve()
    {
        if (_ids.Length >= _table.Count + Width) return;
        int length = _table.Boxes.Length + Width;
        _order = new ulong[length];
        _scratch = new ulong[length];
        (_minU, _maxU, _minV) = (new float[length], new float[length], new float[length]);
        (_maxV, _minW, _maxW) = (new float[length], new float[length], new float[length]);

        // Last: its length says that there is room in all of them.
        _ids = new int[length];
    }

    private void Gather(int axis, float margin, int n)
    {
        int v = axis == 0 ? 1 : 0, w = axis == 2 ? 1 : 2;
        for (int i = 0; i < n; i++)
        {
            int id = (int)_order[i];
            ref readonly Aabb box = ref _table.Boxes[id];
            _ids[i] = id;
            _minU[i] = Component(box.Min, axis);
            _maxU[i] = Component(box.Max, axis) + margin;
            _minV[i] = Component(box.Min, v);
            _maxV[i] = Component(box.Max, v) + margin;
            _minW[i] = Component(box.Min, w);
            _maxW[i] = Component(box.Max, w) + margin;
        }

        // A NaN is not below any end: the padding matches nothing, not even an infinite margin.
        for (int i = n; i < n + Width; i++) _minU[i] = float.NaN;
    }

#if NET
    /// <summary>Compares a box with those that begin before it ends, eight at a time: the arrays are as long as the
    /// last group needs.</summary>
    /// <returns>How many were compared.</returns>
    private int SweepOne(int i, int n)
    {
        Vector256<float> end = Vector256.Create(_maxU[i]);
        Vector256<float> minV = Vector256.Create(_minV[i]), maxV = Vector256.Create(_maxV[i]);
        Vector256<float> minW = Vector256.Create(_minW[i]), maxW = Vector256.Create(_maxW[i]);
        int j = i + 1;
        for (; j < n; j += Width)
        {
            Vector256<float> begins = Vector256.LessThanOrEqual(Load(_minU, j), end);
            Vector256<float> meets = begins
                & Vector256.LessThanOrEqual(Load(_minV, j), maxV) & Vector256.LessThanOrEqual(minV, Load(_maxV, j))
                & Vector256.LessThanOrEqual(Load(_minW, j), maxW) & Vector256.LessThanOrEqual(minW, Load(_maxW, j));
            for (uint bits = meets.ExtractMostSignificantBits(); bits != 0; bits &= bits - 1)
                _found.Add(PairKeys.Key(_ids[i], _ids[j + System.Numerics.BitOperations.TrailingZeroCount(bits)]));
            if (begins.ExtractMostSignificantBits() != byte.MaxValue) break;
        }

        return j - i;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector256<float> Load(float[] values, int index)
    {
        Debug.Assert(index >= 0 && index + Vector256<float>.Count <= values.Length);
        return Vector256.LoadUnsafe(ref MemoryMarshal.GetArrayDataReference(values), (uint)index);
    }
#else
    /// <summary>Compares a box with those that begin before it ends.</summary>
    /// <returns>How many were compared.</returns>
    private int SweepOne(int i, int n)
    {
        float end = _maxU[i], minV = _minV[i], maxV = _maxV[i], minW = _minW[i], maxW = _maxW[i];
        int j = i + 1;
        for (; j < n && _minU[j] <= end; j++)
        {
            if (_minV[j] <= maxV && minV <= _maxV[j] && _minW[j] <= maxW && minW <= _maxW[j])
                _found.Add(PairKeys.Key(_ids[i], _ids[j]));
        }

        return j - i;
    }
#endif
}
