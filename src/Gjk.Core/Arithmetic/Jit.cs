namespace Gjk.Core;

/// <summary>What the runtime is asked when it compiles a method.</summary>
internal static class Jit
{
    /// <summary>AggressiveOptimization, which netstandard2.0 has no name for: the best code from the first call on. It
    /// is for the lanes of scenes and batches, which are too large for the first seconds to be spent on what the
    /// runtime compiles in a hurry, and for extended precision, which is too rare to be compiled again soon. A query of
    /// one pair goes without it: its branches gain 5 to 15 % from the profile that the runtime then takes.</summary>
    public const MethodImplOptions AtOnce = (MethodImplOptions)512;

    /// <summary>AggressiveInlining where that pays. Mono has no registers left for a loop that a step of GJK is put
    /// into, and clears all its vectors: there the steps are called.</summary>
#if NET
    public const MethodImplOptions Step = MethodImplOptions.AggressiveInlining;
#else
    public const MethodImplOptions Step = MethodImplOptions.NoInlining;
#endif
}
