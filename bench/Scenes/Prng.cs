using System;
using System.Numerics;

namespace Gjk.Bench.Scenes;

/// <summary>
/// SplitMix64. It gives the same numbers on every machine and every runtime. System.Random does not promise that.
/// </summary>
public sealed class Prng
{
    private ulong _state;

    public Prng(ulong seed) => _state = seed;

    /// <summary>Uniform in [min, max).</summary>
    public float Range(float min, float max) => (float)(min + (max - min) * Unit());

    /// <summary>Uniform in 0 .. count - 1.</summary>
    public int Index(int count) => (int)(count * Unit());

    /// <summary>
    /// Uniform on the unit sphere, by rejection. Trigonometry is avoided because its results could differ between
    /// machines.
    /// </summary>
    public Vector3 Direction()
    {
        while (true)
        {
            double x = Signed(), y = Signed(), z = Signed();
            double squared = x * x + y * y + z * z;
            if (squared is > 1 or < 1e-4) continue;
            double scale = 1 / Math.Sqrt(squared);
            return new Vector3((float)(x * scale), (float)(y * scale), (float)(z * scale));
        }
    }

    /// <summary>Uniform over all rotations. It is a direction in four dimensions.</summary>
    public Quaternion Rotation()
    {
        while (true)
        {
            double x = Signed(), y = Signed(), z = Signed(), w = Signed();
            double squared = x * x + y * y + z * z + w * w;
            if (squared is > 1 or < 1e-4) continue;
            double scale = 1 / Math.Sqrt(squared);
            return new Quaternion((float)(x * scale), (float)(y * scale), (float)(z * scale), (float)(w * scale));
        }
    }

    private double Signed() => 2 * Unit() - 1;

    private double Unit() => (Next() >> 11) * (1.0 / (1UL << 53));

    private ulong Next()
    {
        ulong z = _state += 0x9E3779B97F4A7C15UL;
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9UL;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBUL;
        return z ^ (z >> 31);
    }
}
