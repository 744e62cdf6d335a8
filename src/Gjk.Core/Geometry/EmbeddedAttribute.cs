#if !NET
namespace Microsoft.CodeAnalysis;

/// <summary>The compiler hides types with it from other assemblies, friends too.</summary>
internal sealed class EmbeddedAttribute : System.Attribute
{
}
#endif
