using System.Numerics;
using System.Security.Cryptography;

namespace Gjk.Core;

/// <summary>A random order of a cloud's points, the same for the same cloud.</summary>
/// <remarks>
/// The seed is the SHA-256 of all coordinates. So the order of a cloud is known only once all its points are, any
/// change of a point changes the whole order, and no cloud can be computed for a wanted seed. Whoever wants a cloud
/// with a bad order has to try clouds, and each is as unlikely to have one as a shuffled deck.
/// </remarks>
internal static class ShuffledOrder
{
    private const int FloatBytes = 4;

    public static int[] Of(Vector3[] points)
    {
        ulong state = Seed(points);
        int[] order = new int[points.Length];
        for (int i = 0; i < order.Length; i++)
        {
            // Fisher and Yates, inside out. The high half of 32 random bits times a count is below the count.
            int j = (int)((Next(ref state) >> 32) * (ulong)(i + 1) >> 32);
            order[i] = order[j];
            order[j] = i;
        }

        return order;
    }

    private static ulong Seed(Vector3[] points)
    {
        byte[] bytes = new byte[3 * FloatBytes * points.Length];
        int count = 0;
        foreach (Vector3 p in points)
        {
            Append(p.X, bytes, ref count);
            Append(p.Y, bytes, ref count);
            Append(p.Z, bytes, ref count);
        }

        using SHA256 sha = SHA256.Create();
        byte[] hash = sha.ComputeHash(bytes);
        ulong seed = 0;
        for (int i = 0; i < sizeof(ulong); i++) seed = seed << 8 | hash[i];
        return seed;
    }

    /// <summary>Lowest byte first on every machine.</summary>
    private static unsafe void Append(float x, byte[] bytes, ref int count)
    {
        uint bits = *(uint*)&x;
        for (int shift = 0; shift < 8 * FloatBytes; shift += 8) bytes[count++] = (byte)(bits >> shift);
    }

    /// <summary>SplitMix64 (Steele, Lea, Flood 2014).</summary>
    private static ulong Next(ref ulong state)
    {
        unchecked
        {
            ulong z = state += 0x9E3779B97F4A7C15UL;
            z = (z ^ z >> 30) * 0xBF58476D1CE4E5B9UL;
            z = (z ^ z >> 27) * 0x94D049BB133111EBUL;
            return z ^ z >> 31;
        }
    }
}
