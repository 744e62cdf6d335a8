using Gjk.Exact.Randomness;

namespace Gjk.Bench.Scenes;

/// <summary>Seeded draws for the benchmarks: the same numbers on every machine and every runtime.</summary>
public sealed class Prng
{
    private readonly SplitMix64 _source;

    public Prng(ulong seed) => _source = new SplitMix64(seed);

    /// <summary>Uniform in [min, max).</summary>
    public float Range(float min, float max) => (float)(min + (max - min) * _source.Unit());

    /// <summary>Uniform in 0 .. count - 1.</summary>
    public int Index(int count) => (int)(count * _source.Unit());

    /// <summary>One of a few values.</summary>
    public T OneOf<T>(params T[] values) => values[Index(values.Length)];

    /// <summary>Uniform on the unit sphere, by rejection. Trigonometry is avoided because its results could differ
    /// between machines.</summary>
    public Vector3 Direction()
    {
        while (true)
        {
            double x = _source.Signed(), y = _source.Signed(), z = _source.Signed();
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
            double x = _source.Signed(), y = _source.Signed(), z = _source.Signed(), w = _source.Signed();
            double squared = x * x + y * y + z * z + w * w;
            if (squared is > 1 or < 1e-4) continue;
            double scale = 1 / Math.Sqrt(squared);
            return new Quaternion((float)(x * scale), (float)(y * scale), (float)(z * scale), (float)(w * scale));
        }
    }
}
