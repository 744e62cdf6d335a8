namespace Gjk.Exact.Meshes;

/// <summary>Points on circles, computed in float or in double: each leaves its own residue where the result should be
/// 0.</summary>
/// <param name="InFloat">Whether sine, cosine and products are floats; else they are doubles, rounded at the
/// end.</param>
public readonly record struct Trigonometry(bool InFloat)
{
    public static Trigonometry Any(Rng random) => new(random.OneIn(2));

    /// <summary>A point of a surface of revolution about the y axis.</summary>
    /// <param name="radius">Of the ring.</param>
    /// <param name="height">Of the ring.</param>
    /// <param name="i">Which of the ring's points.</param>
    /// <param name="count">How many points make a full turn.</param>
    public Vector3 OnRing(double radius, double height, int i, int count)
    {
        if (InFloat)
        {
            float angle = 2 * MathF.PI * i / count, r = (float)radius;
            return new Vector3(r * MathF.Cos(angle), (float)height, r * MathF.Sin(angle));
        }

        (double sin, double cos) = Math.SinCos(2 * Math.PI * i / count);
        return new Vector3((float)(radius * cos), (float)height, (float)(radius * sin));
    }

    /// <summary>Sine and cosine of pi times a fraction, as this arithmetic has them: neither is 0 at 1 or at
    /// 1/2.</summary>
    public (double Sin, double Cos) OfHalfTurns(int i, int count)
    {
        if (!InFloat) return Math.SinCos(Math.PI * i / count);
        float angle = MathF.PI * i / count;
        return (MathF.Sin(angle), MathF.Cos(angle));
    }
}
