using System;
using System.Numerics;

namespace Gjk.Core.Tests.Support;

/// <summary>
/// FNV-1a, 64 bits, over results in order: a, b (int32), status (byte), the IEEE bits of distance, both points and the normal, -0 as +0, little-endian. Iterations are not in it.
/// </summary>
internal struct ResultHash
{
    private const ulong OffsetBasis = 0xCBF29CE484222325UL;
    private const ulong Prime = 0x100000001B3UL;

    private ulong _state;

    public ResultHash() => _state = OffsetBasis;

    public static string Of(int a, int b, in DistanceResult r)
    {
        var hash = new ResultHash();
        hash.Add(a, b, r);
        return hash.ToString();
    }

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

    public override readonly string ToString() => _state.ToString("x16");

    private void Vector(Vector3 v)
    {
        Float(v.X);
        Float(v.Y);
        Float(v.Z);
    }

    private void Float(float x) => Word(x == 0 ? 0 : BitConverter.SingleToUInt32Bits(x));

    private void Word(uint w)
    {
        for (int shift = 0; shift < 32; shift += 8) Byte((byte)(w >> shift));
    }

    private void Byte(byte b) => _state = (_state ^ b) * Prime;
}
