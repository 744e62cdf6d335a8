using System;
using System.IO;
using System.Threading;
using Gjk.Core;
using Gjk.Demo.Output;
using Gjk.Demo.Scenes;

namespace Gjk.Demo.Queries;

/// <summary>Asks for the distance of every pair of a scene, in the poses of its first frame, and writes the answers as CSV.</summary>
internal static class QueryCommand
{
    /// <summary>How many pairs are answered between two looks at Ctrl-C.</summary>
    private const int PairsPerLook = 256;

    /// <param name="scene">What to ask about.</param>
    /// <param name="output">The file to write, or null for standard output.</param>
    /// <param name="maxDistance">Pairs further apart are only known to be so; +infinity asks for all distances.</param>
    /// <param name="cancel">Ends the work; no file is left then.</param>
    public static void Run(Scene scene, string? output, float maxDistance, CancellationToken cancel)
    {
        if (output is null)
        {
            using Stream stdout = Console.OpenStandardOutput();
            Write(scene, stdout, "standard output", maxDistance, cancel);
            return;
        }

        using var file = new AtomicFile(output);
        Write(scene, file.Stream, output, maxDistance, cancel);
        cancel.ThrowIfCancellationRequested();
        file.Commit();
    }

    private static void Write(Scene scene, Stream stream, string name, float maxDistance, CancellationToken cancel)
    {
        SceneObject[] objects = scene.Objects;
        try
        {
            var rows = new CsvWriter(stream);
            int untilLook = 0;
            foreach ((int a, int b) in scene.Pairs)
            {
                if (--untilLook < 0)
                {
                    cancel.ThrowIfCancellationRequested();
                    untilLook = PairsPerLook;
                }

                rows.Write(a, b, ConvexQuery.Distance(objects[a].Shape, objects[a].Pose, objects[b].Shape, objects[b].Pose, maxDistance));
            }

            rows.Flush();
        }
        catch (IOException e)
        {
            throw new RefusedException(name, "cannot be written", e);
        }
    }
}
