using System;
using System.Numerics;

namespace Gjk.Core.Tests.Support;

/// <summary>SplitMix64 (Steele, Lea, Flood 2014): the same numbers for a seed on every runtime, so that a seed in a message is a reproduction.</summary>
internal sealed class Rng(ulong seed)
{
    private ulong _state = seed;

    public ulong Next()
    {
        ulong z = _state += 0x9E3779B97F4A7C15UL;
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9UL;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBUL;
        return z ^ (z >> 31);
    }

    public int Below(int n) => (int)(Next() % (ulong)n);

    /// <summary>From 0 to below 1.</summary>
    public double Unit() => (Next() >> 11) * (1.0 / (1L << 53));

    public double Range(double low, double high) => low + (high - low) * Unit();

    public float Float(double low, double high) => (float)Range(low, high);

    /// <summary>Evenly spread over the exponents.</summary>
    public float LogFloat(double low, double high) => (float)Math.Exp(Range(Math.Log(low), Math.Log(high)));

    public double Gauss() => Math.Sqrt(-2 * Math.Log(1 - Unit())) * Math.Cos(2 * Math.PI * Unit());

    public Vector3 Vector(double low, double high) => new(Float(low, high), Float(low, high), Float(low, high));

    public Vector3 Direction()
    {
        while (true)
        {
            double x = Gauss(), y = Gauss(), z = Gauss(), length = Math.Sqrt(x * x + y * y + z * z);
            if (length > 0.1) return new Vector3((float)(x / length), (float)(y / length), (float)(z / length));
        }
    }

    public Quaternion Rotation()
    {
        while (true)
        {
            double x = Gauss(), y = Gauss(), z = Gauss(), w = Gauss(), length = Math.Sqrt(x * x + y * y + z * z + w * w);
            if (length > 0.1) return new Quaternion((float)(x / length), (float)(y / length), (float)(z / length), (float)(w / length));
        }
    }
}
