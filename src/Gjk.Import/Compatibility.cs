#if !NET
namespace System.Runtime.CompilerServices
{
    /// <summary>What the compiler asks for in records and init accessors, which .NET Standard lacks.</summary>
    internal static class IsExternalInit
    {
    }
}
#endif
