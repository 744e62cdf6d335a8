using System.Buffers.Binary;

namespace Gjk.Import;

/// <summary>Numbers from bytes, least byte first, on every target.</summary>
internal static class LittleEndian
{
    public static float Single(ReadOnlySpan<byte> at) =>
        BitConverter.Int32BitsToSingle(BinaryPrimitives.ReadInt32LittleEndian(at));

    public static double Double(ReadOnlySpan<byte> at) =>
        BitConverter.Int64BitsToDouble(BinaryPrimitives.ReadInt64LittleEndian(at));

    /// <summary>A number of 16 bits (IEEE 754, binary16).</summary>
    public static float Half(ReadOnlySpan<byte> at)
    {
        int bits = BinaryPrimitives.ReadUInt16LittleEndian(at), exponent = (bits >> 10) & 31, fraction = bits & 1023;
        float size = exponent switch
        {
            0 => fraction * PowerOfTwo(-24),
            31 => fraction == 0 ? float.PositiveInfinity : float.NaN,
            _ => (1024 + fraction) * PowerOfTwo(exponent - 25),
        };
        return bits >> 15 == 0 ? size : -size;
    }

    /// <summary>The bytes of hexadecimal digits, or null if they are none.</summary>
    public static byte[]? FromHex(string digits)
    {
        var bytes = new byte[digits.Length / 2];
        if (digits.Length % 2 != 0) return null;
        for (int i = 0; i < bytes.Length; i++)
        {
            int high = Digit(digits[2 * i]), low = Digit(digits[2 * i + 1]);
            if ((high | low) < 0) return null;
            bytes[i] = (byte)(high << 4 | low);
        }

        return bytes;
    }

    private static int Digit(char c) => c switch
    {
        >= '0' and <= '9' => c - '0',
        >= 'a' and <= 'f' => c - 'a' + 10,
        >= 'A' and <= 'F' => c - 'A' + 10,
        _ => -1,
    };

    private static float PowerOfTwo(int exponent) => BitConverter.Int32BitsToSingle((exponent + 127) << 23);
}
