namespace Gjk.Core;

/// <summary>What the runtime is asked when it compiles a method.</summary>
internal static class Jit
{
    /// <summary>AggressiveOptimization, which netstandard2.0 has no name for: optimized code from the first call on.
    /// The lanes of scenes and batches need it, because their first, unoptimized code would be slow for seconds.
    /// Extended precision needs it, because it runs too rarely to be compiled again. A query of one pair goes without
    /// it: its branches gain 5 to 15 % from the profile that the runtime collects first.</summary>
    public const MethodImplOptions AtOnce = (MethodImplOptions)512;

    /// <summary>AggressiveInlining where that pays. On Mono the steps of GJK are called: inlined, they would leave the
    /// loop without registers, and Mono would clear all their vectors in each round.</summary>
#if NET
    public const MethodImplOptions Step = MethodImplOptions.AggressiveInlining;
#else
    public const MethodImplOptions Step = MethodImplOptions.NoInlining;
#endif
}
