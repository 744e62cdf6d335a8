namespace Gjk.Core;

/// <summary>Branchless selection by sign: the sign is unpredictable, and a misprediction costs about twelve
/// multiplications. Zero of either sign counts as positive, as it does for the operator &lt;.</summary>
internal static class BranchFree
{
    /// <summary>1 where x &lt; 0, else 0.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int IsNegative(double x) => x < 0 ? 1 : 0;

    /// <summary>-size where x &lt; 0, else size; the size is at least 0.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double WithSign(double size, double x)
    {
#if NET
        // -0 + 0 is 0.
        return Math.CopySign(size, x + 0.0);
#else
        return x < 0 ? -size : size;
#endif
    }
}
