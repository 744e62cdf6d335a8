namespace Gjk.Exact.Randomness;

/// <summary>SplitMix64 (Steele, Lea and Flood 2014): a seed gives the same numbers on every machine and every runtime,
/// which System.Random does not promise, so that a seed in a message is a reproduction.</summary>
public class SplitMix64
{
    private ulong _state;

    public SplitMix64(ulong seed) => _state = seed;

    public ulong Next()
    {
        ulong z = unchecked(_state += 0x9E3779B97F4A7C15);
        z = unchecked((z ^ (z >> 30)) * 0xBF58476D1CE4E5B9);
        z = unchecked((z ^ (z >> 27)) * 0x94D049BB133111EB);
        return z ^ (z >> 31);
    }

    public int Below(int n) => (int)(Next() % (ulong)n);

    /// <summary>From 0 to below 1.</summary>
    public double Unit() => (Next() >> 11) * (1.0 / (1L << 53));

    /// <summary>From -1 to below 1.</summary>
    public double Signed() => 2 * Unit() - 1;

    public double Range(double low, double high) => low + (high - low) * Unit();

    public float Float(double low, double high) => (float)Range(low, high);

    /// <summary>Evenly spread over the magnitudes.</summary>
    public double Magnitude(double low, double high) => Math.Exp(Range(Math.Log(low), Math.Log(high)));
}
