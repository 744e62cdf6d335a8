using System.Runtime.Intrinsics;
using System.Threading.Tasks;
using Gjk.Exact.Cases;

namespace Gjk.Core.Tests.Queries;

/// <summary>Contract 7 across processes: the golden hashes hold whatever vectors the machine has and however the code
/// was compiled.</summary>
public class SameBitsTests
{
    /// <summary>All hashes, where the library takes other ways; elsewhere that of the distances will do.</summary>
    private static readonly string[] All = [.. GoldenHashes.All.Keys], Distances = ["distances"];

    [Fact]
    public void SerialAndParallelGiveTheSameBits()
    {
        CasePair[] pairs = [.. HashProgram.Read().Pairs];
        var results = new DistanceResult[pairs.Length];
        Parallel.For(
            0, pairs.Length, i => results[i] = ConvexQuery.Distance(
                pairs[i].A.Shape, pairs[i].A.Pose, pairs[i].B.Shape, pairs[i].B.Pose));
        var hash = new BitHash();
        foreach (DistanceResult result in results) hash.Add(result);
        Assert.Equal(GoldenHashes.All["distances"], hash.ToString());
    }

    [Fact]
    public void AChildProcessGivesTheSameBits() =>
        Assert.Equal(
            $"{Vector256.IsHardwareAccelerated} {Vector128.IsHardwareAccelerated} {Golden(Distances)}",
            Child("TieredPGO", "1", Distances));

    [Fact]
    public void TheBitsAreTheSameWithoutWideVectors() =>
        Assert.Equal($"False {Vector128.IsHardwareAccelerated} {Golden(All)}", Child("EnableAVX2", "0", All));

    [Fact]
    public void TheBitsAreTheSameWithoutAnyVectors() =>
        Assert.Equal($"False False {Golden(All)}", Child("EnableHWIntrinsic", "0", All));

    /// <summary>What the compiler makes of a debug build: every value through memory, nothing inlined or
    /// merged.</summary>
    [Fact]
    public void TheBitsAreTheSameWithoutOptimisation() =>
        Assert.EndsWith(" " + Golden(Distances), Child("JITMinOpts", "1", Distances));

    [Fact]
    public void TheBitsAreTheSameWhenOptimisedAtOnce() =>
        Assert.EndsWith(" " + Golden(Distances), Child("TieredCompilation", "0", Distances));

    private static string Golden(string[] names) => string.Join(' ', names.Select(n => GoldenHashes.All[n]));

    private static string Child(string option, string value, string[] names) =>
        ChildProcess.Run(option, value, [HashProgram.Command, .. names]);
}
