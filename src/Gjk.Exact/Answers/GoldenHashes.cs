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
        ["contacts"] = "d3209a82f5a753f5",
        ["casts"] = "0439b074989db937",
        ["impacts"] = "644f83534344b4ba",
        ["rays"] = "986d5510c045beb9",
        ["shapes"] = "cf7c99aa0c7f883a",
        ["batches"] = "f50047053320661e",
        ["scenes"] = "e02277cd6d229e0e",
    };
}
