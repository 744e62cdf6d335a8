using Gjk.Exact.Randomness;

namespace Gjk.Bench.Scenes;

/// <summary>Seeded draws for the benchmarks, as the published results were drawn: spans in float, and a choice by the
/// upper bits.</summary>
public sealed class Prng(ulong seed) : Rng(seed, least: 1e-4)
{
    /// <summary>Uniform in [min, max).</summary>
    public float Range(float min, float max) => (float)(min + (max - min) * Unit());

    /// <summary>Uniform in 0 .. count - 1.</summary>
    public int Index(int count) => (int)(count * Unit());

    /// <summary>One of a few values.</summary>
    public T OneOf<T>(params T[] values) => values[Index(values.Length)];
}
