using Gjk.Core.Tests.Api;

namespace Gjk.Core.Tests.Queries;

/// <summary>Contract 7: the same bits for every build of the library, SIMD on or off, debug or release, serial or
/// parallel. The runners of tests/Gjk.Mono and tests/Gjk.Arm64 hold other runtimes to the same hashes.</summary>
public class GoldenHashTests
{
    private const string Table = "tests/Gjk.Exact/Answers/GoldenHashes.cs", Update = "GJK_UPDATE_GOLDEN";

    private static readonly GoldenRun Run = HashProgram.Read();

    public static TheoryData<string> Names => [.. Run.Parts.Select(p => p.Name)];

    [Theory]
    [MemberData(nameof(Names))]
    public void TheBitsAreGolden(string name)
    {
        string actual = Run.Parts.Single(p => p.Name == name).Hash().ToString(), golden = GoldenHashes.All[name];
        if (Environment.GetEnvironmentVariable(Update) == "1") Write(golden, actual, name);
        else Assert.True(
            golden == actual,
            $"{BuildUnderTest.TargetFramework}, {name}: the bits are {actual}, golden is {golden}. "
            + $"If the change is meant, run these tests once with {Update}=1.");
    }

    [Fact]
    public void EveryHashHasItsQueries() => Assert.Equal(Run.Parts.Select(p => p.Name), GoldenHashes.All.Keys);

    /// <summary>Puts a new hash in the place of the old one.</summary>
    private static void Write(string golden, string actual, string name)
    {
        string table = Path.Combine(ProjectFolder.Root, Table), text = File.ReadAllText(table);
        string old = $"[\"{name}\"] = \"{golden}\"";
        Assert.Contains(old, text);
        File.WriteAllText(table, text.Replace(old, $"[\"{name}\"] = \"{actual}\"", StringComparison.Ordinal));
    }
}
