namespace Gjk.Bench.Mono;

/// <summary>A runtime and the build of the library that it gets.</summary>
/// <param name="Name">The head of its column.</param>
/// <param name="Framework">What the program is built for.</param>
/// <param name="Library">The library's target; empty for that of the framework.</param>
/// <param name="Build">How that build of the library names itself.</param>
internal sealed record MonoColumn(string Name, string Framework, string Library, string Build)
{
    public const string MonoFramework = "net472";

    /// <summary>The runtimes that are compared. The netstandard2.1 library on .NET is the nearest thing to IL2CPP that
    /// can be run without Unity: the same sources without vector registers, and a good compiler.</summary>
    public static IReadOnlyList<MonoColumn> All { get; } =
    [
        new("mono", MonoFramework, "", ".NETStandard,Version=v2.0"),
        new("net10.0", "net10.0", "", ".NETCoreApp,Version=v10.0"),
        new("netstandard2.1", "net10.0", "netstandard2.1", ".NETStandard,Version=v2.1"),
    ];
}
