using System.Reflection;
using System.Runtime.Versioning;

namespace Gjk.Core.Tests.Api;

/// <summary>Which build of the library these tests run against.</summary>
internal static class BuildUnderTest
{
    public static Assembly Library => typeof(ConvexQuery).Assembly;

    public static string TargetFramework => Library.GetCustomAttribute<TargetFrameworkAttribute>()!.FrameworkName;

    /// <summary>What the test project asked for.</summary>
    public static string Expected =>
        typeof(BuildUnderTest).Assembly.GetCustomAttributes<AssemblyMetadataAttribute>().Single(
            m => m.Key == "GjkCoreTarget").Value!;

    public static bool IsModern => TargetFramework.StartsWith(".NETCoreApp", System.StringComparison.Ordinal);
}
