namespace Gjk.Exact.Randomness;

/// <summary>Seeded draws for shapes and poses, as fuzz, the made meshes and the built-in scenes need them.</summary>
public class FuzzRandom : SplitMix64
{
    public FuzzRandom(ulong seed)
        : base(seed)
    {
    }

    /// <summary>The source of one pair, which depends on no other pair.</summary>
    public static FuzzRandom ForPair(ulong seed, long index) =>
        new(new FuzzRandom(new FuzzRandom(seed).Next() + (ulong)index).Next());

    /// <summary>True once in <paramref name="n"/> times.</summary>
    public bool OneIn(int n) => Below(n) == 0;

    public T Of<T>(params T[] choices) => choices[Below(choices.Length)];

    public Vector3 Vector(double size) => new(Float(-size, size), Float(-size, size), Float(-size, size));

    /// <summary>Factors for a scale: uneven, some of them mirroring.</summary>
    public Vector3 Factors(double low, double high) =>
        new(
            Sign() * (float)Magnitude(low, high), Sign() * (float)Magnitude(low, high),
            Sign() * (float)Magnitude(low, high));

    public int Sign() => OneIn(2) ? -1 : 1;

    /// <summary>A unit vector drawn evenly: a point of the ball, brought to unit length. Trigonometry could differ
    /// between machines.</summary>
    public Double3 Direction() => Direction(0.01);

    /// <param name="least">A point of a smaller squared length is drawn again.</param>
    protected Double3 Direction(double least)
    {
        while (true)
        {
            var v = new Double3(Range(-1, 1), Range(-1, 1), Range(-1, 1));
            double squared = v.LengthSquared;
            if (squared > least && squared <= 1) return v * (1 / Math.Sqrt(squared));
        }
    }
}
