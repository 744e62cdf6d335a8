using System;
using System.IO;
using System.Text;

namespace Gjk.Demo.Output;

internal static class StandardError
{
    /// <summary>
    /// Writes one line. A line break in a name must not break it in two, and other control characters must not reach
    /// the terminal.
    /// </summary>
    public static void Line(string message)
    {
        var line = new StringBuilder(message);
        foreach (char space in "\r\n\t") line.Replace(space, ' ');
        Text(PlainText.Of(line.ToString()));
    }

    /// <summary>
    /// Writes the text unchanged. If standard error is closed or its disk is full, nobody can be told. The exit code is
    /// then the only signal.
    /// </summary>
    public static void Text(string message)
    {
        try
        {
            Console.Error.Write($"gjk-demo: {message}\n");
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            // See the summary of this method.
        }
    }
}
