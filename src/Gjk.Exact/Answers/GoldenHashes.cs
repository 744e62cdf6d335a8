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
        ["contacts"] = "1c4b41f969ba4b03",
        ["casts"] = "9246966b07c7056d",
        ["impacts"] = "c0d4540ba908c3d4",
        ["rays"] = "e9e01845239071a8",
        ["shapes"] = "65b14258d13dcb77",
        ["scenes"] = "a23030cc81caf923",
    };
}
