using System.Globalization;

namespace Gjk.Exact.Answers;

/// <summary>The hash FNV-1a of 64 bits, over bytes; numbers are little-endian.</summary>
internal struct Fnv1a
{
    private const ulong OffsetBasis = 0xCBF29CE484222325;
    private const ulong Prime = 0x100000001B3;

    private ulong _state = OffsetBasis;

    public Fnv1a()
    {
    }

    public void Add(byte value) => _state = unchecked((_state ^ value) * Prime);

    public void Add(uint bits)
    {
        for (int shift = 0; shift < 32; shift += 8) Add((byte)(bits >> shift));
    }

    /// <summary>16 lowercase hexadecimal digits.</summary>
    public override readonly string ToString() => _state.ToString("x16", CultureInfo.InvariantCulture);
}
