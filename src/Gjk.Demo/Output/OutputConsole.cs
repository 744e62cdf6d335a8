using System;
using System.IO;
using System.Text;
using Spectre.Console;

namespace Gjk.Demo.Output;

/// <summary>
/// Standard output as the user sees it: colours and bars on a terminal, plain text of any width when it is piped.
/// </summary>
internal static class OutputConsole
{
    /// <summary>No table is wider; there is no edge to wrap at in a pipe.</summary>
    private const int PlainWidth = 1000;

    public static bool IsPlain => Console.IsOutputRedirected;

    /// <summary>Standard output as bytes; a write that fails throws <see cref="RefusedException"/>.</summary>
    public static Stream OpenStream() => new RefusingStream("standard output", Console.OpenStandardOutput());

    public static IAnsiConsole Create()
    {
        if (!IsPlain) return AnsiConsole.Console;
        var writer = new StreamWriter(OpenStream(), new UTF8Encoding(false)) { AutoFlush = true, NewLine = "\n" };
        IAnsiConsole console = AnsiConsole.Create(new AnsiConsoleSettings
        {
            Ansi = AnsiSupport.No,
            ColorSystem = ColorSystemSupport.NoColors,
            Interactive = InteractionSupport.No,
            Out = new AnsiConsoleOutput(writer),
        });
        console.Profile.Width = PlainWidth;
        return console;
    }
}
