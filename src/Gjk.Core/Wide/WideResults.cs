#if NET
using Lanes = System.Runtime.Intrinsics.Vector256<double>;

namespace Gjk.Core;

/// <summary>The results of four pairs, number by number, and the weights that they are made with.</summary>
internal unsafe struct WideResults
{
    public Lanes WeightA, WeightB, WeightC, WeightD;

    /// <summary>One bit for each lane that overlaps, or is further apart than asked; the others are apart.</summary>
    public uint IsOverlapping, IsBeyond;

    /// <summary>Counts of supports.</summary>
    public Vector128<int> Iterations;

    /// <summary>Rows of four floats: distance, bound, and the five vectors of a result.</summary>
    private fixed float _rows[4 * 17];

    /// <summary>Rounds the numbers; the bounds are floats already.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Set(
        Lanes distance, Lanes bound, in WideVector pointA, in WideVector pointB, in WideVector normal,
        in WideVector localA, in WideVector localB)
    {
        Row(0, distance);
        Row(1, bound);
        Rows(2, pointA);
        Rows(5, pointB);
        Rows(8, normal);
        Rows(11, localA);
        Rows(14, localB);
    }

    /// <summary>Writes the results of lanes to their places.</summary>
    public void Write(uint done, int* index, ref DistanceResult results)
    {
        for (int lane = 0; done != 0; lane++, done >>= 1)
            if ((done & 1) != 0) Write(lane, out Unsafe.Add(ref results, index[lane]));
    }

    private void Write(int lane, out DistanceResult result)
    {
        if ((IsBeyond >> lane & 1) != 0)
        {
            result = DistanceResult.Beyond(_rows[4 + lane], Vector(8, lane), Iterations.GetElement(lane));
            return;
        }

        bool overlaps = (IsOverlapping >> lane & 1) != 0;
        result = new DistanceResult(
            overlaps ? GjkStatus.Overlapping : GjkStatus.Separated, _rows[lane], _rows[4 + lane], Vector(2, lane),
            Vector(5, lane), Vector(8, lane), Vector(11, lane), Vector(14, lane), Iterations.GetElement(lane));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private Vector3 Vector(int row, int lane) =>
        new(_rows[4 * row + lane], _rows[4 * row + 4 + lane], _rows[4 * row + 8 + lane]);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void Rows(int row, in WideVector v)
    {
        Row(row, v.X);
        Row(row + 1, v.Y);
        Row(row + 2, v.Z);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void Row(int row, Lanes value) => Avx.ConvertToVector128Single(value).StoreUnsafe(ref _rows[4 * row]);
}
#endif
