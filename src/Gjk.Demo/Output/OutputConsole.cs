using System;
using System.IO;
using System.Text;
using System.Threading;
using Spectre.Console;

namespace Gjk.Demo.Output;

/// <summary>
/// Standard output as the user sees it: colours and bars on a terminal, plain text of any width when it is piped.
/// </summary>
internal static class OutputConsole
{
    /// <summary>No table is wider; there is no edge to wrap at in a pipe.</summary>
    private const int PlainWidth = 1000;

    /// <summary>What Unix calls standard output.</summary>
    private const int StandardOutput = 1;

    public static bool IsPlain => Console.IsOutputRedirected;

    /// <summary>Makes a failed write to <see cref="Console.Out"/> a refusal, unless it is a terminal.</summary>
    public static void RefuseFailures(CancellationToken cancel)
    {
        if (!IsPlain) return;
        Console.SetOut(new StreamWriter(OpenStream(cancel), new UTF8Encoding(false)) { AutoFlush = true, NewLine = "\n" });
    }

    /// <summary>Standard output as bytes; a write that fails throws <see cref="RefusedException"/>.</summary>
    /// <param name="cancel">Ends the wait for a reader that does not read.</param>
    public static RefusingStream OpenStream(CancellationToken cancel)
    {
        // Only a regular file has a position, which the console's stream shares with the other processes that write to
        // it.
        bool isPipe = IsPlain && !OperatingSystem.IsWindows() && FileStatus.Of("/dev/stdout").Kind == FileKind.Stream;
        Stream stream = isPipe ? new PipeStream(StandardOutput) : Console.OpenStandardOutput();

        // The console's own stream locks Console.Out, so a write to it must stay on the thread that may hold that lock.
        bool waits = isPipe || !IsPlain;
        return new RefusingStream("standard output", stream, waits ? cancel : CancellationToken.None);
    }

    public static IAnsiConsole Create()
    {
        if (!IsPlain) return AnsiConsole.Console;
        IAnsiConsole console = AnsiConsole.Create(new AnsiConsoleSettings
        {
            Ansi = AnsiSupport.No,
            ColorSystem = ColorSystemSupport.NoColors,
            Interactive = InteractionSupport.No,
            Out = new AnsiConsoleOutput(Console.Out),
        });
        console.Profile.Width = PlainWidth;
        return console;
    }
}
