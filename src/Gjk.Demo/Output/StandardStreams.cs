namespace Gjk.Demo.Output;

/// <summary>Standard streams that a caller of <see cref="Program.Run(string[], StandardStreams, CancellationToken)"/>
/// gives instead of the process's own. They are neither a terminal nor closed. Each run has its own, on whatever
/// threads it works, so runs may go on side by side.</summary>
internal sealed class StandardStreams
{
    private static readonly AsyncLocal<StandardStreams?> Given = new();

    public StandardStreams(Stream input, Stream output, Stream error)
    {
        Input = input;
        Output = output;
        Out = Writer(new RefusingStream("standard output", output, CancellationToken.None));
        Error = Writer(error);
    }

    /// <summary>Those of the run that this thread works for; null for the process's own.</summary>
    public static StandardStreams? Current
    {
        get => Given.Value;
        set => Given.Value = value;
    }

    public Stream Input { get; }

    /// <summary>Standard output, for bytes.</summary>
    public Stream Output { get; }

    /// <summary>Standard output, for text.</summary>
    public TextWriter Out { get; }

    public TextWriter Error { get; }

    private static TextWriter Writer(Stream stream) => TextWriter.Synchronized(
        new StreamWriter(stream, new UTF8Encoding(false)) { AutoFlush = true, NewLine = "\n" });
}
