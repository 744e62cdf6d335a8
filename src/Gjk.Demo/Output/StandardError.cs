using System;
using System.IO;
using System.Text;

namespace Gjk.Demo.Output;

internal static class StandardError
{
    /// <summary>Writes one line: a control character in a file name or a field name may not break it in two.</summary>
    public static void Line(string message)
    {
        var line = new StringBuilder();
        foreach (char c in message) line.Append(char.IsControl(c) ? ' ' : c);
        Text(line.ToString());
    }

    /// <summary>
    /// Writes as it is. If standard error is closed or its disk is full, nobody can be told, and the exit code has to
    /// do.
    /// </summary>
    public static void Text(string message)
    {
        try
        {
            Console.Error.Write($"gjk-demo: {message}\n");
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            // See above.
        }
    }
}
