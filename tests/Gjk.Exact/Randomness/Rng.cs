namespace Gjk.Exact.Randomness;

/// <summary>Seeded draws for tests, fuzz, benchmarks and scenes. SplitMix64 (Steele, Lea and Flood 2014): a seed gives
/// the same numbers on every machine and every runtime, which System.Random does not promise, so that a seed in a
/// message is a reproduction.</summary>
public class Rng
{
    private readonly double _least;

    private ulong _state;

    /// <param name="seed">The same seed gives the same numbers.</param>
    /// <param name="least">Squared length: a point of a ball that is nearer to its centre is drawn again, as its
    /// direction is coarse.</param>
    public Rng(ulong seed, double least = 0.01) => (_state, _least) = (seed, least);

    /// <summary>The source of one pair, which depends on no other pair.</summary>
    public static Rng ForPair(ulong seed, long index) => new(new Rng(new Rng(seed).Next() + (ulong)index).Next());

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

    public T Of<T>(params T[] choices) => choices[Below(choices.Length)];

    public int Sign() => OneIn(2) ? -1 : 1;

    /// <summary>From 0 to below 1.</summary>
    public double Unit() => (Next() >> 11) * (1.0 / (1L << 53));

    /// <summary>From -1 to below 1.</summary>
    public double Signed() => 2 * Unit() - 1;

    public double Range(double low, double high) => low + (high - low) * Unit();

    public float Float(double low, double high) => (float)Range(low, high);

    /// <summary>Evenly spread over the magnitudes.</summary>
    public double Magnitude(double low, double high) => Math.Exp(Range(Math.Log(low), Math.Log(high)));

    public float LogFloat(double low, double high) => (float)Magnitude(low, high);

    public Vector3 Vector(double size) => Vector(-size, size);

    public Vector3 Vector(double low, double high) => new(Float(low, high), Float(low, high), Float(low, high));

    /// <summary>Factors for a scale: uneven, some of them mirroring.</summary>
    public Vector3 Factors(double low, double high) =>
        new(Sign() * LogFloat(low, high), Sign() * LogFloat(low, high), Sign() * LogFloat(low, high));

    /// <summary>A unit vector drawn evenly: a point of the ball, brought to unit length. Trigonometry could differ
    /// between machines.</summary>
    public Double3 Direction()
    {
        while (true)
        {
            var v = new Double3(Signed(), Signed(), Signed());
            double squared = v.LengthSquared;
            if (squared > _least && squared <= 1) return v * (1 / Math.Sqrt(squared));
        }
    }

    /// <summary>A direction, rounded to floats.</summary>
    public Vector3 UnitVector() => (Vector3)Direction();

    /// <summary>Spread evenly over all rotations: a direction in four dimensions.</summary>
    public Quaternion Rotation()
    {
        while (true)
        {
            double x = Signed(), y = Signed(), z = Signed(), w = Signed();
            double square = x * x + y * y + z * z + w * w;
            if (square < _least || square > 1) continue;
            double s = 1 / Math.Sqrt(square);
            return new Quaternion((float)(x * s), (float)(y * s), (float)(z * s), (float)(w * s));
        }
    }
}
