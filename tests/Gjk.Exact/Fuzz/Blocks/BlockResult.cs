using System.Globalization;

namespace Gjk.Exact.Fuzz.Blocks;

/// <summary>What became of a block's pairs: a line of the log.</summary>
/// <param name="Number">Of the block, from 0.</param>
/// <param name="Seed">Of its pairs.</param>
/// <param name="Pairs">How many there are.</param>
/// <param name="Proved">How many answers are proved; of a depth, that the way out is one.</param>
/// <param name="Open">How many are neither proved nor refuted.</param>
/// <param name="Refuted">How many are refuted, or contradict another answer.</param>
/// <param name="Nanoseconds">What a pair took on its thread.</param>
internal readonly record struct BlockResult(
    long Number, ulong Seed, long Pairs, long Proved, long Open, long Refuted, long Nanoseconds)
{
    /// <summary>The columns of <see cref="Line"/>.</summary>
    public const string Columns = "block,seed,pairs,proved,open,refuted,ns_per_pair";

    /// <summary>As the log has it.</summary>
    public string Line => string.Create(
        CultureInfo.InvariantCulture, $"{Number},{Seed},{Pairs},{Proved},{Open},{Refuted},{Nanoseconds}");

    /// <summary>Reads a line; false for what is none, and where the numbers do not add up.</summary>
    public static bool TryParse(string line, out BlockResult result)
    {
        result = default;
        string[] cells = line.Split(',');
        if (cells.Length != 7 || !TryNumber(cells[1], out ulong seed)) return false;
        Span<long> numbers = stackalloc long[7];
        for (int i = 0; i < cells.Length; i++)
        {
            if (i == 1) continue;
            if (!TryNumber(cells[i], out ulong number) || number > long.MaxValue) return false;
            numbers[i] = (long)number;
        }

        result = new(numbers[0], seed, numbers[2], numbers[3], numbers[4], numbers[5], numbers[6]);
        return result.Pairs > 0 && result.Proved + result.Open + result.Refuted == result.Pairs;
    }

    /// <summary>The seed of a block.</summary>
    public static ulong SeedOf(ulong seed, long block) => Rng.ForPair(seed, block).Next();

    /// <summary>All pairs of a block, each held to its certificate.</summary>
    /// <param name="number">Of the block.</param>
    /// <param name="seed">Of the run.</param>
    /// <param name="pairs">How many.</param>
    /// <param name="isEnding">Asked now and then; true ends it.</param>
    /// <param name="tried">Told now and then how many pairs were asked since.</param>
    /// <param name="finds">What is refuted, the first few.</param>
    /// <returns>Null where it was ended before its last pair.</returns>
    public static BlockResult? Run(
        long number, ulong seed, long pairs, Func<bool> isEnding, Action<long> tried, out List<BlockFind> finds)
    {
        const int PairsPerLook = 4096;
        long start = System.Diagnostics.Stopwatch.GetTimestamp(), proved = 0, open = 0, refuted = 0;
        ulong own = SeedOf(seed, number);
        var drawn = new BlockPairs(own);
        var judge = new BlockJudge(drawn);
        finds = [];
        for (long i = 0; i < pairs; i++)
        {
            if (i % PairsPerLook == PairsPerLook - 1)
            {
                if (isEnding()) return null;
                tried(PairsPerLook);
            }

            drawn.Next();
            CheckStatus verdict = Ask(judge, i, out string? problem);
            if (problem is not null)
            {
                refuted++;
                if (finds.Count < BlockFind.MostOfABlock)
                    finds.Add(new BlockFind(number, i, judge.Verb, problem, judge.Record()));
            }
            else if (verdict == CheckStatus.Open)
            {
                open++;
            }
            else
            {
                proved++;
            }
        }

        TimeSpan elapsed = System.Diagnostics.Stopwatch.GetElapsedTime(start);
        return new BlockResult(number, own, pairs, proved, open, refuted, (long)elapsed.TotalNanoseconds / pairs);
    }

    /// <summary>A query that throws is wrong, too.</summary>
    private static CheckStatus Ask(BlockJudge judge, long index, out string? problem)
    {
        try
        {
            return judge.Ask(index, out problem);
        }
        catch (Exception e)
        {
            problem = Say.Line($"throws {e.GetType().Name}: {e.Message}");
            return CheckStatus.Refuted;
        }
    }

    private static bool TryNumber(string cell, out ulong number) =>
        ulong.TryParse(cell, NumberStyles.None, CultureInfo.InvariantCulture, out number);
}

/// <summary>A pair whose answer is refuted.</summary>
/// <param name="Block">The block's number.</param>
/// <param name="Pair">The pair's number in it.</param>
/// <param name="Verb">What was asked.</param>
/// <param name="Problem">What is wrong.</param>
/// <param name="Record">The question as a line.</param>
internal sealed record BlockFind(long Block, long Pair, string Verb, string Problem, string Record)
{
    /// <summary>What is wrong with a shape is wrong in many places; these are enough to see it.</summary>
    public const int MostOfABlock = 20;

    /// <summary>A line that says what is wrong, and the record.</summary>
    public string Text => Say.Line($"block {Block}, pair {Pair}, {Verb}: {Problem}\n{Record}\n");
}
