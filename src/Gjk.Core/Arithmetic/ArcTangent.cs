namespace Gjk.Core;

/// <summary>The angle of a sine and a cosine, with the same bits on every runtime, which <see cref="Math.Atan2"/> does
/// not promise.</summary>
internal static class ArcTangent
{
    /// <summary>Radians from -π to π, to 1e-15; 0 where both are 0.</summary>
    /// <remarks>The smaller of the two over the larger is the tangent of at most an eighth of a turn. Halved twice
    /// (Abramowitz and Stegun, "Handbook of Mathematical Functions", 1964, 4.3.20) it is at most a 32nd of a turn, with
    /// a tangent below 0.199; of its arc (4.4.42, Gregory's series) the first term left out is below 2^-55 of the
    /// first. Pinned by ArcTangentTests.</remarks>
    /// <param name="sine">Of any scale, the cosine's.</param>
    /// <param name="cosine">Of the same scale.</param>
    public static double Atan2(double sine, double cosine)
    {
        double s = Math.Abs(sine), c = Math.Abs(cosine);
        if (!(s + c > 0)) return 0;
        double x = Halved(Halved(Math.Min(s, c) / Math.Max(s, c))), y = x * x;
        double arc = x - x * y * (1.0 / 3 - y * (1.0 / 5 - y * (1.0 / 7 - y * (1.0 / 9 - y * (1.0 / 11 - y * (1.0 / 13
            - y * (1.0 / 15 - y * (1.0 / 17 - y * (1.0 / 19 - y * (1.0 / 21))))))))));
        double angle = s > c ? Math.PI / 2 - 4 * arc : 4 * arc;
        if (cosine < 0) angle = Math.PI - angle;
        return sine < 0 ? -angle : angle;
    }

    /// <summary>The tangent of half the angle.</summary>
    private static double Halved(double tangent) => tangent / (1 + Math.Sqrt(1 + tangent * tangent));
}
