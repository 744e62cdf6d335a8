using System.Numerics;
using Gjk.Core;

namespace Gjk.Mono;

/// <summary>
/// FNV-1a, 64 bits, the same as in the tests and the demo. For each pair it takes a, b (int32), the status (byte), and
/// the IEEE bits of the distance, both points and the normal. All are little-endian, and -0 counts as +0.
/// </summary>
internal sealed class ResultHash
{
    private const ulong OffsetBasis = 0xCBF29CE484222325;
    private const ulong Prime = 0x100000001B3;

    private ulong _state = OffsetBasis;

    public void Add(int a, int b, in DistanceResult r)
    {
        Word((uint)a);
        Word((uint)b);
        Byte((byte)(r.Status - 1));
        Float(r.Distance);
        Vector(r.PointA);
        Vector(r.PointB);
        Vector(r.Normal);
    }

    public override string ToString() => _state.ToString("x16");

    private void Vector(Vector3 v)
    {
        Float(v.X);
        Float(v.Y);
        Float(v.Z);
    }

    private unsafe void Float(float x) => Word(x == 0 ? 0 : *(uint*)&x);

    private void Word(uint word)
    {
        for (int shift = 0; shift < 32; shift += 8) Byte((byte)(word >> shift));
    }

    private void Byte(byte b) => _state = unchecked((_state ^ b) * Prime);
}
