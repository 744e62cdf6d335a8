namespace Gjk.Core;

/// <summary>The opposite of a vector of floats, whose zeros stay 0.</summary>
/// <remarks>The minus of System.Numerics makes them 0 on some runtimes and -0 on others.</remarks>
internal static class Opposite
{
    public static Vector3 Of(Vector3 v) => Vector3.Zero - v;
}
