#if !NET
namespace System.Runtime.CompilerServices;

/// <summary>Known to the compiler by its name; netstandard does not have it. Embedded, it is not seen by the tests,
/// which have their own.</summary>
[Microsoft.CodeAnalysis.Embedded]
internal sealed class SkipLocalsInitAttribute : Attribute
{
}
#endif
