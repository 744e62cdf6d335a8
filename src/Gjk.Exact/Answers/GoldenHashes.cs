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
        ["casts"] = "39159121f13f5fe0",
        ["impacts"] = "bcffe15aa874ff62",
        ["rays"] = "cc035761d7ecbf2d",
        ["shapes"] = "a2fd6bcbbda5f628",
        ["batches"] = "fa189d073c2db4ba",
        ["scenes"] = "9b076e6d774d54ac",
    };
}
