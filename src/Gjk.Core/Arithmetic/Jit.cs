using System.Runtime.CompilerServices;

namespace Gjk.Core;

/// <summary>What the runtime is asked when it compiles a method.</summary>
internal static class Jit
{
    /// <summary>
    /// AggressiveOptimization, which netstandard2.0 has no name for: the best code from the first call on. The solvers
    /// are too large for the first seconds to be spent on what the runtime compiles in a hurry, and what they profit
    /// from (types known by their generic arguments) needs no profile.
    /// </summary>
    public const MethodImplOptions AtOnce = (MethodImplOptions)512;
}
