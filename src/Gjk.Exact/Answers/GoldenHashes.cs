using System;
using System.Collections.Generic;

namespace Gjk.Exact.Answers;

/// <summary>The hashes of cold results, per target framework of the library (contract 7).</summary>
public static class GoldenHashes
{
    /// <summary>
    /// One table serves all: no build contracts or reorders the arithmetic, so all targets give the same bits on x64.
    /// </summary>
    private static readonly Dictionary<string, string> Golden = new()
    {
        ["cases"] = "472da24ad165bdef",
        ["allCases"] = "3fa1e20f8a287e40",
        ["random"] = "bba608ef5fee06a0",
        ["depths"] = "0782201a64be44cd",
        ["contacts"] = "320536bd06cc987c",
    };

    public static IReadOnlyDictionary<string, string> Of(string targetFramework) => targetFramework switch
    {
        ".NETCoreApp,Version=v10.0" or ".NETStandard,Version=v2.0" or ".NETStandard,Version=v2.1" => Golden,
        _ => throw new ArgumentException($"No golden hashes for {targetFramework}.", nameof(targetFramework)),
    };
}
