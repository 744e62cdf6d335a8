using System.Globalization;
using System.Numerics;
using Gjk.Core;

namespace Gjk.Exact.Answers;

/// <summary>
/// A hash of results: FNV-1a, 64 bits. For each pair in order it takes a, b (int32), the status (byte, see
/// <see cref="StatusCode"/>), and the IEEE bits of the distance, both points and the normal. All are little-endian, and
/// -0 counts as +0. Iterations are not in it. Equal hashes mean equal answers to the last bit.
/// </summary>
public struct ResultHash
{
    private const ulong OffsetBasis = 0xCBF29CE484222325;
    private const ulong Prime = 0x100000001B3;

    private ulong _state = OffsetBasis;

    public ResultHash()
    {
    }

    /// <summary>The hash of one pair.</summary>
    public static string Of(int a, int b, in DistanceResult result)
    {
        var hash = new ResultHash();
        hash.Add(a, b, result);
        return hash.ToString();
    }

    public void Add(int a, int b, in DistanceResult result)
    {
        Add((uint)a);
        Add((uint)b);
        AddByte(StatusCode.Of(result.Status));
        Add(result.Distance);
        Add(result.PointA);
        Add(result.PointB);
        Add(result.Normal);
    }

    /// <summary>The points where a pair touches: how many, their number, gap and both places.</summary>
    public void Add(in ContactManifold manifold)
    {
        Add((uint)manifold.Count);
        for (int i = 0; i < manifold.Count; i++)
        {
            ContactPoint point = manifold[i];
            Add((uint)(point.FeatureId >> 32));
            Add((uint)point.FeatureId);
            Add(point.Gap);
            Add(point.PointA);
            Add(point.PointB);
        }
    }

#if NET
    /// <summary>The pairs that a frame found intersecting: how many, then a and b of each.</summary>
    public void Add(System.ReadOnlySpan<ObjectPair> pairs)
    {
        Add((uint)pairs.Length);
        foreach (ObjectPair pair in pairs)
        {
            Add((uint)pair.A);
            Add((uint)pair.B);
        }
    }
#endif

    /// <summary>16 lowercase hexadecimal digits.</summary>
    public override readonly string ToString() => _state.ToString("x16", CultureInfo.InvariantCulture);

    private void Add(Vector3 v)
    {
        Add(v.X);
        Add(v.Y);
        Add(v.Z);
    }

    private unsafe void Add(float x) => Add(x == 0 ? 0 : *(uint*)&x);

    private void Add(uint bits)
    {
        for (int shift = 0; shift < 32; shift += 8) AddByte((byte)(bits >> shift));
    }

    private void AddByte(byte value) => _state = unchecked((_state ^ value) * Prime);
}
