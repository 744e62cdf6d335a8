namespace Gjk.Demo.Queries;

/// <summary>Writes a row of CSV for every pair of a scene.</summary>
internal sealed class PairTable
{
    /// <summary>How many pairs are answered between two checks for Ctrl-C.</summary>
    private const int PairsPerLook = 256;

    private readonly Scene _scene;
    private readonly string? _output;
    private readonly string[]? _names;
    private readonly bool _hasHeading;

    /// <param name="scene">The scene.</param>
    /// <param name="output">The file to write, or null for standard output.</param>
    /// <param name="hasNames">Whether two columns with the names of the objects follow the others.</param>
    /// <param name="isChecked">Whether a column with the verdict of the check follows these.</param>
    /// <param name="hasHeading">Whether the columns are named, as they are in the first of several parts.</param>
    public PairTable(Scene scene, string? output, bool hasNames, bool isChecked, bool hasHeading = true)
    {
        _hasHeading = hasHeading;
        IsChecked = isChecked;
        _scene = scene;
        _output = output;
        _names = hasNames ? ObjectNames.Of(scene) : null;
    }

    /// <summary>Whether each row is to have a verdict.</summary>
    public bool IsChecked { get; }

    /// <param name="columns">The columns without the names and the verdict.</param>
    /// <param name="write">Writes the rows of two objects.</param>
    /// <param name="thing">What a row is of.</param>
    /// <param name="cancel">Ends the work. No file is left then.</param>
    /// <returns>The exit code: Failed where an answer is refuted.</returns>
    public int Write(
        string columns, Action<CsvWriter, int, int> write, CancellationToken cancel, string thing = "pair")
    {
        CsvWriter rows;
        if (_output is null)
        {
            using Stream stdout = OutputConsole.OpenStream(cancel);
            rows = Write(stdout, columns, write, cancel);
        }
        else
        {
            using var file = new AtomicFile(_output, cancel);
            rows = Write(file.Stream, columns, write, cancel);
            file.Commit();
        }

        if (_output is not null) StandardError.Wrote(rows.Rows, thing, _output);
        if (rows.RefutedRows == 0) return ExitCode.Done;
        StandardError.Line($"the check refutes {rows.RefutedRows} of {rows.Rows} answers");
        return ExitCode.Failed;
    }

    private CsvWriter Write(Stream stream, string columns, Action<CsvWriter, int, int> write, CancellationToken cancel)
    {
        var rows = new CsvWriter(stream, _hasHeading ? columns : null, _names, IsChecked);
        int untilLook = 0;
        foreach ((int a, int b) in _scene.Pairs)
        {
            if (--untilLook < 0)
            {
                cancel.ThrowIfCancellationRequested();
                untilLook = PairsPerLook;
            }

            write(rows, a, b);
        }

        rows.Flush();
        return rows;
    }
}
