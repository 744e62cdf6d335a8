#if !NET
namespace System.Runtime.CompilerServices;

/// <summary>What the compiler asks for where OpenGJKSharp's sources say <c>init</c> and <c>required</c>.</summary>
internal static class IsExternalInit;

internal sealed class RequiredMemberAttribute : Attribute;

[AttributeUsage(AttributeTargets.All, AllowMultiple = true)]
internal sealed class CompilerFeatureRequiredAttribute(string featureName) : Attribute
{
    public string FeatureName { get; } = featureName;
}
#endif
