using Gjk.Exact.Randomness;

namespace Gjk.Bench.Scenes;

/// <summary>Seeded draws for the benchmarks: the same numbers on every machine and every runtime.</summary>
public sealed class Prng(ulong seed) : FuzzRandom(seed)
{
    /// <summary>Draws of a smaller squared length are drawn again.</summary>
    private const double Least = 1e-4;

    /// <summary>Uniform in [min, max).</summary>
    public float Range(float min, float max) => (float)(min + (max - min) * Unit());

    /// <summary>Uniform in 0 .. count - 1.</summary>
    public int Index(int count) => (int)(count * Unit());

    /// <summary>One of a few values.</summary>
    public T OneOf<T>(params T[] values) => values[Index(values.Length)];

    public new Vector3 Direction() => (Vector3)Direction(Least);

    public Quaternion Rotation() => Rotations.Even(this, Least);
}
