namespace Gjk.Exact.Answers;

/// <summary>The hashes of <see cref="GoldenRun"/>: one table for all builds and processors, since nothing contracts or
/// reorders the arithmetic. After a change that is meant to move bits, GJK_UPDATE_GOLDEN=1 and the tests of
/// GoldenHashTests write the new ones here.</summary>
public static class GoldenHashes
{
    public static readonly IReadOnlyDictionary<string, string> All = new Dictionary<string, string>
    {
        ["distances"] = "533df80e35cd6025",
        ["depths"] = "9dc7d9ad23e41f09",
        ["contacts"] = "2727a1e9d509bfb1",
        ["casts"] = "0368b0538acfe0d0",
        ["impacts"] = "691cefd8934d6e93",
        ["rays"] = "503e567f26354dca",
        ["shapes"] = "be8bd5af713e08d6",
        ["batches"] = "02cb1d8ad93d25b4",
        ["scenes"] = "90dd6f09792a9c73",
        ["half-spaces"] = "f78c86a599dec090",
        ["masses"] = "9aeba980eb23503b",
    };
}
