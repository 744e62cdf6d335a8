namespace Gjk.Demo.Tests;

/// <summary><c>query --record</c>: one query as text, answered like a scene of two objects.</summary>
public sealed class RecordTests
{
    private const string Spheres = "gjk1 point 1 @ 0 0 0 1 0 0 0 point 0.5 @ 0 0 0 1 3 0 0";

    [Fact]
    public void TheAnswerIsTheLibrarys()
    {
        DemoRun run = DemoRun.Of("query", "--record", Spheres);
        run.AssertDone();
        CsvRow row = Assert.Single(CsvRow.Parse(run.Out));
        DistanceResult expected = QueryRecord.Parse(Spheres).Distance();
        Assert.Equal((0, 1, "Separated", false, 1.5f), (row.A, row.B, row.Status, row.Overlap, row.Distance));
        Assert.Equal(
            (expected.PointA, expected.PointB, expected.Normal, expected.LowerBound),
            (row.PointA, row.PointB, row.Normal, row.LowerBound));
    }

    [Fact]
    public void AFileAndALimitAreTaken()
    {
        using var directory = new TempDirectory();
        string target = directory.File("out.csv");
        DemoRun run = DemoRun.Of("query", "--record", Spheres, "--out", target, "--max-distance", "1");
        run.AssertDone();
        Assert.Equal("", run.Out);
        Assert.Equal("BeyondMaxDistance", Assert.Single(CsvRow.Parse(File.ReadAllText(target))).Status);
    }

    [Theory]
    [InlineData("", "--record: The record ends where 'gjk1' should be.")]
    [InlineData("hello", "--record: Word 1, 'hello', should be 'gjk1'.")]
    [InlineData("gjk1 point 1 @ 0 0 0 1 0 0 0", "--record: The record ends where a shape should be.")]
    [InlineData(
        "gjk1 point 1 @ 0 0 0 2 0 0 0 point 1 @ 0 0 0 1 0 0 0", "--record: Before word 12: The quaternion's length")]
    [InlineData(Spheres + "\nmore", "--record: Word 22, 'more', comes after the end")]
    public void WhatIsNoRecordIsRefused(string text, string message) =>
        DemoRun.Of("query", "--record", text).AssertRefused(message);

    [Fact]
    public void NothingIsWrittenForABadRecord()
    {
        using var directory = new TempDirectory();
        DemoRun.Of("query", "--record", "nothing", "--out", directory.File("out.csv")).AssertRefused("nothing");
        Assert.Empty(directory.Files);
    }

    [Fact]
    public void ASceneAndARecordExcludeEachOther()
    {
        DemoRun.Of("query", "scene.json", "--record", Spheres).AssertRefused("exclude each other");
        DemoRun.Of("query").AssertRefused("SCENE.json, --builtin or --record");
        DemoRun.Of("query", "--record").AssertRefused("--record");
    }

    /// <summary>The process has an empty standard input here.</summary>
    [Fact]
    public void ADashReadsStandardInput() =>
        DemoRun.Of("query", "--record", "-").AssertRefused("--record: The record ends where 'gjk1' should be.");
}
