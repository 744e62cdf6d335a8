using System;
using System.IO;
using System.Text;

namespace Gjk.Demo.Output;

internal static class StandardError
{
    /// <summary>Writes one line. Control characters in a file name or a field name must not break it in two.</summary>
    public static void Line(string message)
    {
        var line = new StringBuilder();
        foreach (char c in message) line.Append(char.IsControl(c) ? ' ' : c);
        Text(line.ToString());
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
