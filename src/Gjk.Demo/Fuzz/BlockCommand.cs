using Gjk.Demo.Replay;
using Gjk.Exact.Fuzz;
using Gjk.Exact.Fuzz.Blocks;

namespace Gjk.Demo.Fuzz;

/// <summary><c>fuzz --certificate</c>: very many pairs, each answer judged by its certificate alone, without another
/// solver.</summary>
internal static class BlockCommand
{
    /// <param name="pairs">How many pairs there are to be, those of the log included.</param>
    /// <param name="seed">Which pairs; null: those of the log, or others each time.</param>
    /// <param name="resume">The log to continue, or to begin; null: none.</param>
    /// <param name="threads">How many at once.</param>
    /// <param name="cancel">Ends it; what was done is printed and in the log.</param>
    /// <returns>The exit code.</returns>
    public static int Run(long pairs, ulong? seed, string? resume, int threads, CancellationToken cancel)
    {
        using BlockLog log = BlockLog.Open(resume, seed, cancel);
        int before = log.Blocks.Count;
        var run = new BlockRun(log.Seed, log.Blocks, pairs, (block, finds) =>
        {
            log.Add(block, finds);
            finds.ForEach(find => OutputConsole.Out.Write(find.Text));
        });
        ProgressBar.Show(bar => run.Run(threads, bar.Add("pairs"), cancel));
        OutputConsole.Out.Write(Summary(log, before, threads));
        if (cancel.IsCancellationRequested) return ExitCode.Cancelled;
        return log.Blocks.Values.Any(b => b.Refuted > 0) ? ExitCode.Failed : ExitCode.Done;
    }

    private static string Summary(BlockLog log, int before, int threads)
    {
        long pairs = log.Pairs, proved = log.Blocks.Values.Sum(b => b.Proved);
        long open = log.Blocks.Values.Sum(b => b.Open), refuted = log.Blocks.Values.Sum(b => b.Refuted);
        double nanoseconds = log.Blocks.Values.Sum(b => (double)b.Nanoseconds * b.Pairs) / Math.Max(1, pairs);
        string finds = refuted > 0 && log.FindsName is { } name ? $", see {name}" : "";
        string blocks = log.Blocks.Count == 1 ? "1 block" : $"{log.Blocks.Count} blocks";
        return Say.Line($"{pairs} pairs, seed {log.Seed}: {proved} proved, {open} open, {refuted} refuted{finds}\n")
            + Say.Line($"{blocks}, {log.Blocks.Count - before} of them now on {threads} threads; ")
            + Say.Line($"{nanoseconds:F0} ns a pair and thread\n");
    }
}
