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
        ["contacts"] = "3c946585c80f01d5",
        ["casts"] = "a41d9714908af600",
        ["impacts"] = "97fefd12e0317273",
        ["rays"] = "f97003a7a9720186",
        ["shapes"] = "0665a2ef1e62c5c4",
        ["batches"] = "02cb1d8ad93d25b4",
        ["scenes"] = "0a3e697b10e6f945",
    };
}
