#if NET
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;
#endif

namespace Gjk.Core;

/// <summary>
/// Sort and sweep (Baraff 1992; Ericson 2004, section 7.5.2): boxes sorted by their lower ends along the axis on which they spread most; each is then compared
/// with those that begin before it ends.
/// </summary>
internal sealed class AxisSweep
{
    /// <summary>Boxes compared at once, and the padding of the sorted arrays.</summary>
    private const int Width = 8;

    private readonly int[] _histograms = new int[SortKeys.HistogramLength];
    private ulong[] _order = [];
    private ulong[] _scratch = [];
    private int[] _ids = [];

    // In sorted order, u along the sweep's axis; the upper ends have the margin added.
    private float[] _minU = [], _maxU = [], _minV = [], _maxV = [], _minW = [], _maxW = [];

    /// <summary>Adds every pair of boxes that overlap with the margin to the keys, in no useful order.</summary>
    public void Collect(BoundsTable table, float margin, PairKeys keys)
    {
        Reserve(table);
        int axis = LargestSpread(table);
        int n = 0;
        for (int id = 0; id < table.End; id++)
            if (table.Present[id]) _order[n++] = (ulong)SortKeys.Ordered(Component(table.Boxes[id].Min, axis)) << 32 | (uint)id;
        SortKeys.Sort(ref _order, ref _scratch, _histograms, n);
        Gather(table, axis, margin, n);
        Sweep(n, keys);
    }

    public static float Component(in System.Numerics.Vector3 v, int axis) => axis == 0 ? v.X : axis == 1 ? v.Y : v.Z;

    /// <summary>The axis along which the centres vary most: there the fewest boxes overlap by chance.</summary>
    private static int LargestSpread(BoundsTable table)
    {
        Vector3D sum = default, squares = default;
        for (int id = 0; id < table.End; id++)
        {
            if (!table.Present[id]) continue;
            Vector3D centre = (Vector3D)table.Boxes[id].Min + table.Boxes[id].Max;
            sum += centre;
            squares += Vector3D.Multiply(centre, centre);
        }

        Vector3D spread = squares * table.Count - Vector3D.Multiply(sum, sum);
        return spread.X >= spread.Y ? (spread.X >= spread.Z ? 0 : 2) : (spread.Y >= spread.Z ? 1 : 2);
    }

    private void Reserve(BoundsTable table)
    {
        if (_ids.Length >= table.Count + Width) return;
        int length = table.Boxes.Length + Width;
        _order = new ulong[length];
        _scratch = new ulong[length];
        _ids = new int[length];
        (_minU, _maxU, _minV) = (new float[length], new float[length], new float[length]);
        (_maxV, _minW, _maxW) = (new float[length], new float[length], new float[length]);
    }

    private void Gather(BoundsTable table, int axis, float margin, int n)
    {
        int v = axis == 0 ? 1 : 0, w = axis == 2 ? 1 : 2;
        for (int i = 0; i < n; i++)
        {
            int id = (int)_order[i];
            ref readonly Aabb box = ref table.Boxes[id];
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

    private void Sweep(int n, PairKeys keys)
    {
        for (int i = 0; i < n; i++)
        {
#if NET
            SweepWide(i, n, keys);
#else
            float end = _maxU[i], minV = _minV[i], maxV = _maxV[i], minW = _minW[i], maxW = _maxW[i];
            for (int j = i + 1; j < n && _minU[j] <= end; j++)
            {
                if (_minV[j] <= maxV && minV <= _maxV[j] && _minW[j] <= maxW && minW <= _maxW[j])
                    keys.Add(PairKeys.Key(_ids[i], _ids[j]));
            }
#endif
        }
    }

#if NET
    /// <summary>The same comparisons, eight at a time: the arrays are as long as the last group asks.</summary>
    private void SweepWide(int i, int n, PairKeys keys)
    {
        Vector256<float> end = Vector256.Create(_maxU[i]);
        Vector256<float> minV = Vector256.Create(_minV[i]), maxV = Vector256.Create(_maxV[i]);
        Vector256<float> minW = Vector256.Create(_minW[i]), maxW = Vector256.Create(_maxW[i]);
        for (int j = i + 1; j < n; j += Width)
        {
            Vector256<float> begins = Vector256.LessThanOrEqual(Load(_minU, j), end);
            Vector256<float> meets = begins
                & Vector256.LessThanOrEqual(Load(_minV, j), maxV) & Vector256.LessThanOrEqual(minV, Load(_maxV, j))
                & Vector256.LessThanOrEqual(Load(_minW, j), maxW) & Vector256.LessThanOrEqual(minW, Load(_maxW, j));
            for (uint bits = meets.ExtractMostSignificantBits(); bits != 0; bits &= bits - 1)
                keys.Add(PairKeys.Key(_ids[i], _ids[j + System.Numerics.BitOperations.TrailingZeroCount(bits)]));
            if (begins.ExtractMostSignificantBits() != byte.MaxValue) return;
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector256<float> Load(float[] values, int index) =>
        Vector256.LoadUnsafe(ref MemoryMarshal.GetArrayDataReference(values), (uint)index);
#endif
}
