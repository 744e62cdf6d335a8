using System.Collections.Generic;

namespace Gjk.Exact.Answers;

/// <summary>
/// The hashes of <see cref="GoldenRun"/>: one table for all builds and processors, since nothing contracts or reorders
/// the arithmetic. After a change that is meant to move bits, GJK_UPDATE_GOLDEN=1 and the tests of GoldenHashTests
/// write the new ones here.
/// </summary>
public static class GoldenHashes
{
    public static readonly IReadOnlyDictionary<string, string> All = new Dictionary<string, string>
    {
        ["distances"] = "533df80e35cd6025",
        ["depths"] = "ae978d1d82c9e9c6",
        ["contacts"] = "08349d9c796b97c1",
        ["casts"] = "0c2574f0ce9d9562",
        ["impacts"] = "37d05805bedaf4c6",
        ["rays"] = "c5d3aedc05127f04",
        ["shapes"] = "a01523d40c75a8b0",
        ["scenes"] = "94e988fdb567841f",
    };
}
