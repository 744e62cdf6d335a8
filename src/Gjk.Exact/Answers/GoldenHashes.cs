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
        ["depths"] = "c7ab17cf145b9ea6",
        ["contacts"] = "a0f0c573fac87960",
        ["casts"] = "12dbb977fca3a35e",
        ["impacts"] = "3efb193442007c1d",
        ["rays"] = "e8c5042b37b8cc9e",
        ["shapes"] = "c73216de22fea6c0",
        ["scenes"] = "3ee4862f4ef43c25",
    };
}
