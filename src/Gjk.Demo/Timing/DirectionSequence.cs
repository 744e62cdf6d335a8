namespace Gjk.Demo.Timing;

/// <summary>Pseudo-random unit vectors. The sequence is the same in every run.</summary>
internal sealed class DirectionSequence
{
    private ulong _state = 0x4D_6F_74_69_6F_6E;

    /// <summary>A uniformly distributed unit vector: a point of the ball, scaled to unit length.</summary>
    public Double3 Next()
    {
        while (true)
        {
            var v = new Double3(NextSigned(), NextSigned(), NextSigned());
            double square = v.LengthSquared;
            if (square <= 1 && square > 0.01) return v * (1 / Math.Sqrt(square));
        }
    }

    /// <summary>A number from -1 up to 1, by xorshift64* (Vigna 2016).</summary>
    private double NextSigned()
    {
        _state ^= _state >> 12;
        _state ^= _state << 25;
        _state ^= _state >> 27;
        return (unchecked(_state * 0x2545F4914F6CDD1D) >> 11) * (2.0 / (1UL << 53)) - 1;
    }
}
