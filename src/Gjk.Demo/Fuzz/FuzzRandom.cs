using System;
using System.Numerics;
using Gjk.Core;

namespace Gjk.Demo.Fuzz;

/// <summary>SplitMix64 (Steele, Lea and Flood 2014): a seed gives the same pairs on every machine.</summary>
internal sealed class FuzzRandom
{
    private ulong _state;

    public FuzzRandom(ulong seed) => _state = seed;

    /// <summary>The source of one pair, which depends on no other pair.</summary>
    public static FuzzRandom ForPair(ulong seed, long index) =>
        new(new FuzzRandom(new FuzzRandom(seed).Next() + (ulong)index).Next());

    public ulong Next()
    {
        ulong z = unchecked(_state += 0x9E3779B97F4A7C15);
        z = unchecked((z ^ (z >> 30)) * 0xBF58476D1CE4E5B9);
        z = unchecked((z ^ (z >> 27)) * 0x94D049BB133111EB);
        return z ^ (z >> 31);
    }

    public int Below(int n) => (int)(Next() % (ulong)n);

    /// <summary>True once in <paramref name="n"/> times.</summary>
    public bool OneIn(int n) => Below(n) == 0;

    public T Of<T>(params ReadOnlySpan<T> choices) => choices[Below(choices.Length)];

    /// <summary>From 0 to below 1.</summary>
    public double Unit() => (Next() >> 11) * (1.0 / (1L << 53));

    public double Range(double low, double high) => low + (high - low) * Unit();

    public float Float(double low, double high) => (float)Range(low, high);

    /// <summary>Evenly spread over the magnitudes.</summary>
    public double Magnitude(double low, double high) => Math.Exp(Range(Math.Log(low), Math.Log(high)));

    public Vector3 Vector(double size) => new(Float(-size, size), Float(-size, size), Float(-size, size));

    /// <summary>Factors for a scale: uneven, some of them mirroring.</summary>
    public Vector3 Factors(double low, double high) =>
        new(
            Sign() * (float)Magnitude(low, high), Sign() * (float)Magnitude(low, high),
            Sign() * (float)Magnitude(low, high));

    public int Sign() => OneIn(2) ? -1 : 1;

    public Vector3D Direction()
    {
        while (true)
        {
            var v = new Vector3D(Range(-1, 1), Range(-1, 1), Range(-1, 1));
            double squared = v.LengthSquared;
            if (squared is > 0.01 and <= 1) return v * (1 / Math.Sqrt(squared));
        }
    }
}
