using Gjk.Demo.Replay;
using Gjk.Exact.Fuzz;
using Gjk.Exact.Fuzz.Promises;

namespace Gjk.Demo.Fuzz;

/// <summary>Searches for a pair of shapes that breaks a promise of the library.</summary>
internal static class FuzzCommand
{
    /// <param name="length">How long to search.</param>
    /// <param name="seed">Of the sequence of pairs.</param>
    /// <param name="isConcave">Whether to leave out the pairs of convex shapes.</param>
    /// <param name="cancel">Ends the search; what was done is printed.</param>
    public static int Run(FuzzLength length, ulong seed, bool isConcave, CancellationToken cancel)
    {
        IPairSource concave = PairSources.Concave();
        var convex = new MixedPairs(PairSources.Convex(AllPromises.Make()), PairSources.HalfSpaces(), place: 3);
        var run = new FuzzRun(length, seed, isConcave ? concave : new MixedPairs(convex, concave, place: 7));
        BrokenPromise? broken = null;
        ProgressBar.Show(bar => broken = run.Search(bar.Add("pairs"), cancel));
        FuzzReport report = FuzzReport.Of(run, broken, cancel.IsCancellationRequested);
        OutputConsole.Out.Write(report.Text);
        return report.ExitCode;
    }
}
