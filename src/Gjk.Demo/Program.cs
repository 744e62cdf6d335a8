using Gjk.Import;

namespace Gjk.Demo;

internal static class Program
{
    /// <summary>The program with other standard streams than the process's own. Safe to run side by side.</summary>
    /// <param name="args">The command line.</param>
    /// <param name="streams">Its standard streams.</param>
    /// <param name="cancel">Does what Ctrl-C does.</param>
    /// <returns>The exit code.</returns>
    public static int Run(string[] args, StandardStreams streams, CancellationToken cancel)
    {
        StandardStreams? before = StandardStreams.Current;
        StandardStreams.Current = streams;
        try
        {
            return Run(args, cancel);
        }
        finally
        {
            StandardStreams.Current = before;
        }
    }

    private static int Main(string[] args)
    {
        using var interrupt = new Interrupt();
        OutputConsole.RefuseFailures(interrupt.Token);
        return Run(args, interrupt.Token);
    }

    private static int Run(string[] args, CancellationToken cancel)
    {
        try
        {
            return CommandLine.Run(args, cancel);
        }
        catch (Exception refused) when (refused is RefusedException or ImportException)
        {
            StandardError.Line(refused.Message);
            return ExitCode.Refused;
        }
        catch (ReaderGoneException)
        {
            return ExitCode.Done;
        }
        catch (OperationCanceledException)
        {
            return ExitCode.Cancelled;
        }
        catch (Exception unexpected)
        {
            StandardError.Text($"internal error: {unexpected}");
            return ExitCode.Failed;
        }
    }
}
