using System;
using Gjk.Demo.Output;
using Gjk.Import;

namespace Gjk.Demo;

internal static class Program
{
    private static int Main(string[] args)
    {
        using var interrupt = new Interrupt();
        OutputConsole.RefuseFailures(interrupt.Token);
        try
        {
            return CommandLine.Run(args, interrupt.Token);
        }
        catch (Exception refused) when (refused is RefusedException or ImportException)
        {
            StandardError.Line(refused.Message);
            return ExitCode.Refused;
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
