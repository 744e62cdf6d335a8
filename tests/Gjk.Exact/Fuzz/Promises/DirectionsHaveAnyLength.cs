namespace Gjk.Exact.Fuzz.Promises;

/// <summary>A direction may be of any length: far beyond what can be squared, down to where its own components lose
/// digits, with components that differ by as much.</summary>
internal static class DirectionsHaveAnyLength
{
    /// <summary>The last but one leaves few digits of a component in the range of doubles; the direction is taken as it
    /// then is.</summary>
    private static readonly double[] Lengths = [1e-170, 1e200, 1e-20, 1e20, 1e300, 1e-307, double.Epsilon];

    public static string? Broken(FuzzPair pair) => Problem(pair.A, pair.BodyA, "A") ?? Problem(pair.B, pair.BodyB, "B");

    private static string? Problem(in ConvexShape shape, PosedShape body, string name)
    {
        for (int i = 0; i < Directions.Few.Length; i += 2)
        {
            Double3 d = Directions.Few[i] * Lengths[i / 2 % Lengths.Length];
            if (SupportsReachTheCloud.Problem(shape, body, d, name) is { } problem) return problem;
        }

        return null;
    }
}
