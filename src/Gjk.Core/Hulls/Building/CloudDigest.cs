namespace Gjk.Core;

/// <summary>SHA-256 (FIPS 180-4) of a cloud: of all coordinates as floats, lowest byte first on every
/// machine.</summary>
/// <remarks>The runtime's own is no choice: on Linux it is OpenSSL's, and a program ends at once where that is not
/// installed.</remarks>
internal sealed class CloudDigest
{
    private const int BlockWords = 16, Rounds = 64;

    /// <summary>The fractions of the cube roots of the first 64 primes.</summary>
    private static readonly uint[] RoundConstants =
    [
        0x428A2F98, 0x71374491, 0xB5C0FBCF, 0xE9B5DBA5, 0x3956C25B, 0x59F111F1, 0x923F82A4, 0xAB1C5ED5,
        0xD807AA98, 0x12835B01, 0x243185BE, 0x550C7DC3, 0x72BE5D74, 0x80DEB1FE, 0x9BDC06A7, 0xC19BF174,
        0xE49B69C1, 0xEFBE4786, 0x0FC19DC6, 0x240CA1CC, 0x2DE92C6F, 0x4A7484AA, 0x5CB0A9DC, 0x76F988DA,
        0x983E5152, 0xA831C66D, 0xB00327C8, 0xBF597FC7, 0xC6E00BF3, 0xD5A79147, 0x06CA6351, 0x14292967,
        0x27B70A85, 0x2E1B2138, 0x4D2C6DFC, 0x53380D13, 0x650A7354, 0x766A0ABB, 0x81C2C92E, 0x92722C85,
        0xA2BFE8A1, 0xA81A664B, 0xC24B8B70, 0xC76C51A3, 0xD192E819, 0xD6990624, 0xF40E3585, 0x106AA070,
        0x19A4C116, 0x1E376C08, 0x2748774C, 0x34B0BCB5, 0x391C0CB3, 0x4ED8AA4A, 0x5B9CCA4F, 0x682E6FF3,
        0x748F82EE, 0x78A5636F, 0x84C87814, 0x8CC70208, 0x90BEFFFA, 0xA4506CEB, 0xBEF9A3F7, 0xC67178F2,
    ];

    /// <summary>First the fractions of the square roots of the first 8 primes.</summary>
    private readonly uint[] _state =
    [
        0x6A09E667, 0xBB67AE85, 0x3C6EF372, 0xA54FF53A,
        0x510E527F, 0x9B05688C, 0x1F83D9AB, 0x5BE0CD19,
    ];

    private readonly uint[] _words = new uint[Rounds];
    private int _count;

    private CloudDigest()
    {
    }

    /// <summary>The digest's first eight bytes, the first one highest.</summary>
    public static ulong Of(Vector3[] points)
    {
        var digest = new CloudDigest();
        foreach (Vector3 p in points)
        {
            digest.Add(p.X);
            digest.Add(p.Y);
            digest.Add(p.Z);
        }

        ulong bits = 8UL * 3 * sizeof(float) * (ulong)points.Length;
        digest.Add(0x80000000);
        while (digest._count != BlockWords - 2) digest.Add(0u);
        digest.Add((uint)(bits >> 32));
        digest.Add((uint)bits);
        return (ulong)digest._state[0] << 32 | digest._state[1];
    }

    /// <summary>A word is read with its first byte highest.</summary>
    private unsafe void Add(float x)
    {
        uint bits = *(uint*)&x;
        Add(bits << 24 | (bits & 0xFF00) << 8 | (bits >> 8 & 0xFF00) | bits >> 24);
    }

    private void Add(uint word)
    {
        _words[_count++] = word;
        if (_count < BlockWords) return;
        _count = 0;
        Mix();
    }

    private void Mix()
    {
        uint[] w = _words, state = _state;
        for (int i = BlockWords; i < Rounds; i++)
        {
            uint s0 = RotateRight(w[i - 15], 7) ^ RotateRight(w[i - 15], 18) ^ w[i - 15] >> 3;
            uint s1 = RotateRight(w[i - 2], 17) ^ RotateRight(w[i - 2], 19) ^ w[i - 2] >> 10;
            w[i] = unchecked(w[i - 16] + s0 + w[i - 7] + s1);
        }

        uint a = state[0], b = state[1], c = state[2], d = state[3];
        uint e = state[4], f = state[5], g = state[6], h = state[7];
        for (int i = 0; i < Rounds; i++)
        {
            uint s1 = RotateRight(e, 6) ^ RotateRight(e, 11) ^ RotateRight(e, 25), choice = (e & f) ^ (~e & g);
            uint s0 = RotateRight(a, 2) ^ RotateRight(a, 13) ^ RotateRight(a, 22);
            uint majority = (a & b) ^ (a & c) ^ (b & c);
            uint first = unchecked(h + s1 + choice + RoundConstants[i] + w[i]), second = unchecked(s0 + majority);
            (h, g, f, e, d, c, b) = (g, f, e, unchecked(d + first), c, b, a);
            a = unchecked(first + second);
        }

        unchecked
        {
            state[0] += a;
            state[1] += b;
            state[2] += c;
            state[3] += d;
            state[4] += e;
            state[5] += f;
            state[6] += g;
            state[7] += h;
        }
    }

    private static uint RotateRight(uint word, int bits) => word >> bits | word << (32 - bits);
}
