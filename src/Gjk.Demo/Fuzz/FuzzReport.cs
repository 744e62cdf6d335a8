using Gjk.Exact.Fuzz;

namespace Gjk.Demo.Fuzz;

/// <summary>What a search says at its end, and its exit code.</summary>
/// <param name="Text">Whole lines.</param>
/// <param name="ExitCode">Done, Failed or Cancelled.</param>
internal readonly record struct FuzzReport(string Text, int ExitCode)
{
    private const double LeastSeconds = 1e-3;

    public static FuzzReport Of(FuzzRun run, BrokenPromise? broken, bool cancelled)
    {
        double seconds = run.Elapsed.TotalSeconds;
        double rate = run.Tried / Math.Max(seconds, LeastSeconds);
        string tried = Say.Line(
            $"{run.Tried} pairs tried in {seconds:F1} s, {rate:F0} pairs per second, seed {run.Seed}");
        if (broken is null)
            return cancelled
                ? new($"{tried}: no promise broken until cancelled\n", Demo.ExitCode.Cancelled)
                : new($"{tried}: no promise broken\n", Demo.ExitCode.Done);
        string found = Say.Line(
            $"pair {broken.Index} ({broken.Family}) breaks a promise: {broken.Promise}: {broken.How}");
        return new($"{tried}\n{found}\n{broken.Record}\n", Demo.ExitCode.Failed);
    }
}
