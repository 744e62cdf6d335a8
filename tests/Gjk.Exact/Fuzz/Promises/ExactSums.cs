namespace Gjk.Exact.Fuzz.Promises;

/// <summary>Sums of floats that lose nothing.</summary>
internal static class ExactSums
{
    /// <summary>False where a component of the sum is rounded.</summary>
    public static bool TryAdd(Vector3 a, Vector3 b, out Vector3 sum)
    {
        sum = a + b;
        return IsSum(a.X, b.X, sum.X) && IsSum(a.Y, b.Y, sum.Y) && IsSum(a.Z, b.Z, sum.Z);
    }

    /// <summary>Both parts come back out of the sum, which then has lost nothing (Knuth's test).</summary>
    private static bool IsSum(float a, float b, float sum) => float.IsFinite(sum) && sum - a == b && sum - b == a;
}
