using Gjk.Import;

namespace Gjk.Demo.Output;

/// <summary>Reads the bytes of an input: a file, a pipe, or standard input if the name is "-".</summary>
internal static class InputFile
{
    /// <summary>The name that stands for standard input.</summary>
    public const string StandardInput = "-";

    /// <summary>Bytes of one input. The largest scenes that <c>import</c> writes are smaller. A device without an end
    /// is refused after this many bytes.</summary>
    public const int MostBytes = 1 << 29;

    /// <summary>The name of the input in messages.</summary>
    public static string NameOf(string file) => file == StandardInput ? "standard input" : file;

    /// <summary>Reads to the end.</summary>
    /// <exception cref="ImportException">The input cannot be read, or it has more than <see cref="MostBytes"/>
    /// bytes.</exception>
    /// <exception cref="OperationCanceledException">Cancelled before the end was reached.</exception>
    public static byte[] Read(string file, CancellationToken cancel) => file == StandardInput
        ? WholeFile.Read(NameOf(file), OutputConsole.OpenInput, MostBytes, cancel)
        : WholeFile.Read(file, MostBytes, cancel);
}
