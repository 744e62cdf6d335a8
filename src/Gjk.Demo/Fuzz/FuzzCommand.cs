using System;
using System.Threading;
using Gjk.Demo.Output;
using Gjk.Demo.Replay;

namespace Gjk.Demo.Fuzz;

/// <summary>Searches for a pair of shapes that breaks a promise of the library.</summary>
internal static class FuzzCommand
{
    private const double LeastSeconds = 1e-3;

    /// <param name="length">How long to search.</param>
    /// <param name="seed">Of the sequence of pairs.</param>
    /// <param name="cancel">Ends the search; what was done is printed.</param>
    public static int Run(FuzzLength length, ulong seed, CancellationToken cancel)
    {
        var run = new FuzzRun(length, seed);
        BrokenPromise? broken = null;
        ProgressBar.Show(OutputConsole.Create(), OutputConsole.IsPlain, bar => broken = run.Search(bar.Add("pairs"), cancel));
        double seconds = run.Elapsed.TotalSeconds;
        string tried = Say.Line($"{run.Tried} pairs tried in {seconds:F1} s, {run.Tried / Math.Max(seconds, LeastSeconds):F0} pairs per second, seed {seed}");
        if (broken is not null)
        {
            Console.Out.Write(Say.Line($"{tried}\npair {broken.Index} ({broken.Family}) breaks a promise: {broken.Promise}: {broken.How}\n{broken.Record}\n"));
            return ExitCode.Failed;
        }

        Console.Out.Write(cancel.IsCancellationRequested ? $"{tried}: no promise broken until cancelled\n" : $"{tried}: no promise broken\n");
        return cancel.IsCancellationRequested ? ExitCode.Cancelled : ExitCode.Done;
    }
}
