using System;
using System.Text;

namespace Gjk.Demo.Output;

internal static class StandardError
{
    /// <summary>Writes one line: a control character in a file name or a field name may not break it in two.</summary>
    public static void Line(string message)
    {
        var line = new StringBuilder("gjk-demo: ");
        foreach (char c in message) line.Append(char.IsControl(c) ? ' ' : c);
        Console.Error.Write(line.Append('\n').ToString());
    }
}
