namespace Gjk.Core;

/// <summary>Sine and cosine to a few units in the last place, with the same bits on every runtime, which
/// <see cref="Math.Sin"/> does not promise.</summary>
internal static class SineCosine
{
    /// <summary>Radians: up to here the number of quarter turns that are taken off has 20 bits, so that its products
    /// with the parts below are exact. Pinned by SineCosineTests.</summary>
    public const double MaxAngle = 1 << 20;

    /// <summary>A quarter turn in two parts of 33 bits and what is left of it (Cody and Waite, "Software Manual for the
    /// Elementary Functions", 1980).</summary>
    private const double Quarter1 = 6746518852.0 / (1L << 32);

    /// <inheritdoc cref="Quarter1"/>
    private const double Quarter2 = 4484108710.0 / (1L << 33) / (1L << 33);

    /// <inheritdoc cref="Quarter1"/>
    private const double Quarter3 = 2.0222662487959506e-21;

    /// <summary>The sine and the cosine, by their series about the nearest quarter turn.</summary>
    /// <param name="angle">Radians, at most <see cref="MaxAngle"/> either way.</param>
    /// <param name="sine">Of the angle.</param>
    /// <param name="cosine">Of the angle.</param>
    public static void Compute(double angle, out double sine, out double cosine)
    {
        double quarters = Math.Floor(angle * (2 / Math.PI) + 0.5);
        double x = angle - quarters * Quarter1 - quarters * Quarter2 - quarters * Quarter3;
        double y = x * x;

        // Up to an eighth of a turn the first terms left out are below a quarter of a unit in the last place.
        double s = x + x * y * (-1.0 / 6 + y * (1.0 / 120 + y * (-1.0 / 5040 + y * (1.0 / 362880
            + y * (-1.0 / 39916800 + y * (1.0 / 6227020800 + y * (-1.0 / 1307674368000)))))));
        double c = 1 - y * (0.5 - y * (1.0 / 24 - y * (1.0 / 720 - y * (1.0 / 40320 - y * (1.0 / 3628800
            - y * (1.0 / 479001600 - y * (1.0 / 87178291200 - y * (1.0 / 20922789888000))))))));
        int turned = (int)quarters & 3;
        sine = (turned & 1) == 0 ? s : c;
        cosine = (turned & 1) == 0 ? c : s;
        if ((turned & 2) != 0) sine = -sine;
        if (turned is 1 or 2) cosine = -cosine;
    }
}
