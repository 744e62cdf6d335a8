using System.Text.RegularExpressions;
using Gjk.Demo.Fuzz;
using Gjk.Exact.Fuzz.Blocks;

namespace Gjk.Demo.Tests.Fuzz;

/// <summary><c>fuzz --certificate</c>: blocks, their log, and how it is continued.</summary>
public sealed class BlockTests
{
    private const string Header =
        "# gjk-demo fuzz --certificate --seed 3\nblock,seed,pairs,proved,open,refuted,ns_per_pair";

    [Fact]
    public void PairsAreJudgedAndCounted()
    {
        DemoRun run = DemoRun.Of("fuzz", "--certificate", "--pairs", "2e4", "--seed", "3", "--threads", "2");
        run.AssertDone();
        Match said = Regex.Match(
            run.Out,
            @"^20000 pairs, seed 3: (\d+) proved, (\d+) open, 0 refuted\n1 block, 1 of them now on 2 threads; "
                + @"\d+ ns a "
            + @"pair and thread\n$");
        Assert.True(said.Success, run.Out);
        Assert.Equal(20_000, int.Parse(said.Groups[1].Value) + int.Parse(said.Groups[2].Value));
        Assert.InRange(int.Parse(said.Groups[2].Value), 0, 200);
    }

    /// <summary>Most pairs are near contact; both answers of each question are asked for.</summary>
    [Fact]
    public void ThePairsAreHardAndTestBothAnswers()
    {
        const int Count = 20_000;
        int overlaps = 0, near = 0, hits = 0;
        var drawn = new BlockPairs(1);
        for (int i = 0; i < Count; i++)
        {
            drawn.Next();
            DistanceResult r = ConvexQuery.SignedDistance(drawn.A, drawn.PoseA, drawn.B, drawn.PoseB);
            drawn.Tell(r);
            drawn.DrawRay(out var origin, out var direction);
            overlaps += r.IsOverlapping ? 1 : 0;
            near += Math.Abs(r.Distance) < 1e-3 * drawn.Size ? 1 : 0;
            hits += ConvexQuery.RayCast(drawn.A, drawn.PoseA, origin, direction).IsHit ? 1 : 0;
        }

        Assert.InRange(overlaps, 0.3 * Count, 0.7 * Count);
        Assert.InRange(hits, 0.3 * Count, 0.8 * Count);
        Assert.InRange(near, 0.3 * Count, Count);
    }

    [Fact]
    public void ABlockIsTheSameWhoeverAsksIt()
    {
        string[] Lines(int threads)
        {
            using var log = BlockLog.Open(null, 5, default);
            new BlockRun(5, log.Blocks, 5_500, log.Add, 1_000).Run(threads, _ => { }, default);
            return [.. log.Blocks.Values.Select(Told)];
        }

        string[] one = Lines(1);
        Assert.Equal(6, one.Length);
        Assert.Contains(",500,", one[5]);
        Assert.Equal(one, Lines(3));
    }

    [Fact]
    public void ALogIsContinuedWhereItEnds()
    {
        using var directory = new TempDirectory();
        string file = Path.Combine(directory.Path, "log.csv"), whole = Path.Combine(directory.Path, "whole.csv");
        Sit(file, 3_000);
        Assert.Equal(3, Sit(file, 3_000));

        // A sitting that was interrupted left out a block; it is made up for.
        string[] lines = File.ReadAllLines(file);
        File.WriteAllLines(file, lines.Where((_, i) => i != 3));
        Assert.Equal(5, Sit(file, 5_000));
        Sit(whole, 5_000);
        string[] told = [.. Blocks(file).OrderBy(b => b.Number).Select(Told)];
        Assert.Equal([.. Blocks(whole).OrderBy(b => b.Number).Select(Told)], told);
        Assert.False(File.Exists(file + ".finds"));

        static int Sit(string file, long pairs)
        {
            using var log = BlockLog.Open(file, 3, default);
            new BlockRun(3, log.Blocks, pairs, log.Add, 1_000).Run(2, _ => { }, default);
            return log.Blocks.Count;
        }
    }

    [Fact]
    public void ARunWithoutASeedIsThatOfItsLog()
    {
        using var directory = new TempDirectory();
        string file = Path.Combine(directory.Path, "log.csv");
        DemoRun.Of("fuzz", "--certificate", "--pairs", "500", "--seed", "3", "--resume", file).AssertDone();
        string before = File.ReadAllText(file);
        Assert.StartsWith(Header + "\n0,", before);
        DemoRun again = DemoRun.Of("fuzz", "--certificate", "--pairs", "500", "--resume", file);
        again.AssertDone();
        Assert.StartsWith("500 pairs, seed 3: ", again.Out);
        Assert.Contains("1 block, 0 of them now", again.Out);
        Assert.Equal(before, File.ReadAllText(file));
        DemoRun.Of("fuzz", "--certificate", "--pairs", "500", "--seed", "4", "--resume", file)
            .AssertRefused(file, "line 1", "3, not 4");
    }

    [Theory]
    [InlineData("no log", "line 1")]
    [InlineData(Header + "\n0,1,2", "line 3")]
    [InlineData(Header + "\n0,1,1000,1000,0,0,99\n", "line 3")]
    [InlineData(Header + "\n0,SEED0,1000,999,0,0,99\n", "line 3")]
    [InlineData(Header + "\n0,SEED0,1000,-1,1001,0,99\n", "line 3")]
    [InlineData(Header + "\n0,SEED0,1000,1000,0,0,99\n0,SEED0,1000,1000,0,0,99\n", "line 4")]
    [InlineData("# gjk-demo fuzz --certificate --seed 3\nblock\n", "line 2")]
    public void ADamagedLogIsRefusedAndKept(string text, string part)
    {
        using var directory = new TempDirectory();
        text = text.Replace("SEED0", $"{BlockResult.SeedOf(3, 0)}", StringComparison.Ordinal);
        string file = directory.Write("log.csv", text);
        DemoRun.Of("fuzz", "--certificate", "--pairs", "500", "--resume", file).AssertRefused(file, part);
        Assert.Equal(text, File.ReadAllText(file));
    }

    [Fact]
    public void ALogThatCannotBeIsRefused()
    {
        using var directory = new TempDirectory();
        DemoRun.Of("fuzz", "--certificate", "--pairs", "5", "--resume", directory.Path)
            .AssertRefused(directory.Path, "cannot be continued");
        string file = Path.Combine(directory.Path, "log.csv");
        using var log = BlockLog.Open(file, 3, default);
        DemoRun.Of("fuzz", "--certificate", "--pairs", "5", "--resume", file).AssertRefused(file);
    }

    [Fact]
    public void CtrlCKeepsTheLog()
    {
        if (OperatingSystem.IsWindows()) return;
        using var directory = new TempDirectory();
        string file = Path.Combine(directory.Path, "log.csv");
        using RunningDemo demo = RunningDemo.Start(
            "fuzz", "--certificate", "--pairs", "1e9", "--seed", "3", "--resume", file);
        while (!File.Exists(file) || new FileInfo(file).Length == 0) Thread.Sleep(50);
        Thread.Sleep(500);
        demo.Interrupt();
        DemoRun run = demo.Wait();
        Assert.Equal((130, ""), (run.ExitCode, run.Error));
        Assert.Matches(@"^(block.*\n.*\n)*\d+ pairs, seed 3: ", run.Out);
        using var log = BlockLog.Open(file, 3, default);
        Assert.Equal(log.Pairs, log.Blocks.Count * BlockRun.PairsOfABlock);
    }

    /// <summary>What is found stands beside the log, as lines that <c>query --record</c> reads.</summary>
    [Fact]
    public void FindsStandBesideTheLog()
    {
        using var directory = new TempDirectory();
        string file = Path.Combine(directory.Path, "log.csv");
        var drawn = new BlockPairs(2);
        var judge = new BlockJudge(drawn);
        drawn.Next();
        judge.Ask(2, out _);
        using (var log = BlockLog.Open(file, 3, default))
        {
            log.Add(
                new BlockResult(0, BlockResult.SeedOf(3, 0), 10, 8, 1, 1, 99),
                [new BlockFind(0, 7, judge.Verb, "Refuted", judge.Record())]);
        }

        string[] lines = File.ReadAllLines(file + ".finds");
        Assert.Equal("block 0, pair 7, cast: Refuted", lines[0]);
        Assert.True(QueryRecord.TryParse(lines[1], out QueryRecord record, out string? reason), reason);
        Assert.NotEqual(default, record.MotionB.Velocity);
        DemoRun again = DemoRun.Of("fuzz", "--certificate", "--pairs", "10", "--resume", file);
        Assert.Equal(1, again.ExitCode);
        Assert.StartsWith($"10 pairs, seed 3: 8 proved, 1 open, 1 refuted, see {file}.finds\n", again.Out);
    }

    [Theory]
    [InlineData("--certificate", "--pairs")]
    [InlineData("--certificate --pairs 10 --seconds 5", "--seconds")]
    [InlineData("--certificate --pairs 1e-3", "--pairs 1e-3")]
    [InlineData("--certificate --pairs 10 --threads 0", "--threads 0")]
    [InlineData("--resume log.csv", "--certificate")]
    [InlineData("--threads 2", "--certificate")]
    public void WrongArgumentsAreOneLine(string args, string part) =>
        DemoRun.Of(["fuzz", .. args.Split(' ')]).AssertRefused("fuzz: ", part);

    private static IEnumerable<BlockResult> Blocks(string file)
    {
        foreach (string line in File.ReadLines(file).Skip(2))
        {
            Assert.True(BlockResult.TryParse(line, out BlockResult block), line);
            Assert.Equal(line, block.Line);
            yield return block;
        }
    }

    /// <summary>All but the time.</summary>
    private static string Told(BlockResult block) => (block with { Nanoseconds = 0 }).Line;
}
