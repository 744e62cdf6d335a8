using System;
using System.IO;
using System.Threading;
using Gjk.Demo.Output;
using Gjk.Demo.Scenes;

namespace Gjk.Demo.Queries;

/// <summary>Writes a row of CSV for every pair of a scene.</summary>
internal sealed class PairTable
{
    /// <summary>How many pairs are answered between two checks for Ctrl-C.</summary>
    private const int PairsPerLook = 256;

    private readonly Scene _scene;
    private readonly string? _output;
    private readonly string[]? _names;

    /// <param name="scene">The scene.</param>
    /// <param name="output">The file to write, or null for standard output.</param>
    /// <param name="hasNames">Whether two columns with the names of the objects follow the others.</param>
    public PairTable(Scene scene, string? output, bool hasNames)
    {
        _scene = scene;
        _output = output;
        _names = hasNames ? ObjectNames.Of(scene) : null;
    }

    /// <param name="columns">The columns without the names.</param>
    /// <param name="write">Writes the row of two objects.</param>
    /// <param name="cancel">Ends the work. No file is left then.</param>
    public void Write(string columns, Action<CsvWriter, int, int> write, CancellationToken cancel)
    {
        if (_output is null)
        {
            using Stream stdout = OutputConsole.OpenStream(cancel);
            Write(stdout, columns, write, cancel);
            return;
        }

        using (var file = new AtomicFile(_output, cancel))
        {
            Write(file.Stream, columns, write, cancel);
            file.Commit();
        }

        StandardError.Wrote(_scene.Pairs.Count, "pair", _output);
    }

    private void Write(Stream stream, string columns, Action<CsvWriter, int, int> write, CancellationToken cancel)
    {
        var rows = new CsvWriter(stream, columns, _names);
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
    }
}
