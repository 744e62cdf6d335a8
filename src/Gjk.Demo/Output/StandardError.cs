namespace Gjk.Demo.Output;

internal static class StandardError
{
    /// <summary>Writes one line. A line break in a name must not break it in two, and other control characters must not
    /// reach the terminal.</summary>
    public static void Line(string message)
    {
        var line = new StringBuilder(message);
        foreach (char space in "\r\n\t") line.Replace(space, ' ');
        Text(PlainText.Of(line.ToString()));
    }

    /// <summary>Tells what was written to a file, such as "wrote 190 pairs to a.csv".</summary>
    /// <param name="count">How many there are.</param>
    /// <param name="thing">What one of them is called.</param>
    /// <param name="file">As the user named it.</param>
    public static void Wrote(long count, string thing, string file) =>
        Line($"wrote {count} {thing}{(count == 1 ? "" : "s")} to {file}");

    /// <summary>Writes the text unchanged. If standard error is closed or its disk is full, nobody can be told. The
    /// exit code is then the only signal.</summary>
    public static void Text(string message)
    {
        try
        {
            (StandardStreams.Current?.Error ?? Console.Error).Write($"gjk-demo: {message}\n");
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            // See the summary of this method.
        }
    }
}
