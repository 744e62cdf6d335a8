using System;
using Gjk.Demo.Output;

namespace Gjk.Demo;

internal static class Program
{
    private static int Main(string[] args)
    {
        using var interrupt = new Interrupt();
        try
        {
            return CommandLine.Run(args, interrupt.Token);
        }
        catch (RefusedException refused)
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
            Console.Error.WriteLine($"gjk-demo: internal error: {unexpected}");
            return ExitCode.Failed;
        }
    }
}
