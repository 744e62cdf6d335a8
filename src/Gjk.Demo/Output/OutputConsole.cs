using Spectre.Console;

namespace Gjk.Demo.Output;

/// <summary>Standard output as the user sees it. A terminal shows colours and progress bars. A pipe gets plain text of
/// any width.</summary>
internal static class OutputConsole
{
    /// <summary>Characters. No table is wider than this, and a pipe has no edge at which lines must wrap.</summary>
    private const int PlainWidth = 1000;

    /// <summary>The file descriptor of standard output on Unix.</summary>
    private const int StandardOutput = 1;

    public static bool IsPlain => StandardStreams.Current is not null || Console.IsOutputRedirected;

    /// <summary>Standard output for text.</summary>
    public static TextWriter Out => StandardStreams.Current?.Out ?? Console.Out;

    /// <summary>Standard input for bytes. Who is to type them is told so, and how they end.</summary>
    public static Stream OpenInput()
    {
        if (StandardStreams.Current is { } given) return given.Input;
        if (!Console.IsInputRedirected)
        {
            string end = OperatingSystem.IsWindows() ? "Ctrl-Z and Enter" : "Ctrl-D";
            StandardError.Line($"reads what is typed here, until {end} on a line of its own");
        }

        return Console.OpenStandardInput();
    }

    /// <summary>Turns a failed write to <see cref="Out"/> into a refusal, unless it is a terminal.</summary>
    public static void RefuseFailures(CancellationToken cancel)
    {
        if (!IsPlain) return;
        var writer = new StreamWriter(OpenStream(cancel), new UTF8Encoding(false)) { AutoFlush = true, NewLine = "\n" };
        Console.SetOut(writer);
    }

    /// <summary>Opens standard output for bytes. A write that fails throws <see cref="RefusedException"/>.</summary>
    /// <param name="cancel">Ends the wait for a reader that does not read.</param>
    public static RefusingStream OpenStream(CancellationToken cancel)
    {
        if (StandardStreams.Current is { } given)
            return new RefusingStream("standard output", given.Output, CancellationToken.None);

        // Only a regular file has a position. The console's stream shares it with the other processes that write to
        // that file.
        PipeStream? pipe = IsPlain && !OperatingSystem.IsWindows() ? PipeStream.TryOpen(StandardOutput) : null;
        Stream stream = pipe ?? Console.OpenStandardOutput();

        // The console's own stream locks Console.Out, so a write to it must stay on the thread that may hold that lock.
        bool waits = pipe is not null || !IsPlain;
        return new RefusingStream("standard output", stream, waits ? cancel : CancellationToken.None);
    }

    /// <summary>Standard error for progress, or null if it is not a terminal.</summary>
    public static IAnsiConsole? ForProgress() => StandardStreams.Current is not null || Console.IsErrorRedirected
        ? null
        : AnsiConsole.Create(new AnsiConsoleSettings { Out = new AnsiConsoleOutput(Console.Error) });

    public static IAnsiConsole Create()
    {
        if (!IsPlain) return AnsiConsole.Console;
        IAnsiConsole console = AnsiConsole.Create(new AnsiConsoleSettings
        {
            Ansi = AnsiSupport.No,
            ColorSystem = ColorSystemSupport.NoColors,
            Interactive = InteractionSupport.No,
            Out = new AnsiConsoleOutput(Out),
        });
        console.Profile.Width = PlainWidth;
        return console;
    }
}
