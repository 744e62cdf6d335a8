using System;
using System.IO;
using System.Threading;
using Gjk.Demo.Output;
using Gjk.Demo.Scenes;

namespace Gjk.Demo.Queries;

/// <summary>Writes a row of CSV for every pair of a scene.</summary>
internal static class PairTable
{
    /// <summary>How many pairs are answered between two checks for Ctrl-C.</summary>
    private const int PairsPerLook = 256;

    /// <param name="scene">The scene.</param>
    /// <param name="output">The file to write, or null for standard output.</param>
    /// <param name="header">The columns.</param>
    /// <param name="write">Writes the row of two objects.</param>
    /// <param name="cancel">Ends the work. No file is left then.</param>
    public static void Write(
        Scene scene, string? output, string header, Action<CsvWriter, int, int> write, CancellationToken cancel)
    {
        if (output is null)
        {
            using Stream stdout = OutputConsole.OpenStream(cancel);
            Write(scene, stdout, header, write, cancel);
            return;
        }

        using var file = new AtomicFile(output, cancel);
        Write(scene, file.Stream, header, write, cancel);
        file.Commit();
    }

    private static void Write(
        Scene scene, Stream stream, string header, Action<CsvWriter, int, int> write, CancellationToken cancel)
    {
        var rows = new CsvWriter(stream, header);
        int untilLook = 0;
        foreach ((int a, int b) in scene.Pairs)
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
