namespace Gjk.Core;

/// <summary>A random order of a cloud's points, the same for the same cloud.</summary>
/// <remarks>The seed is the SHA-256 of all coordinates (<see cref="CloudDigest"/>). So the order of a cloud is known
/// only once all its points are, any change of a point changes the whole order, and no cloud can be computed for a
/// wanted seed. Whoever wants a cloud with a bad order has to try clouds, and each is as unlikely to have one as a
/// shuffled deck.</remarks>
internal static class ShuffledOrder
{
    public static int[] Of(Vector3[] points)
    {
        ulong state = CloudDigest.Of(points);
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
