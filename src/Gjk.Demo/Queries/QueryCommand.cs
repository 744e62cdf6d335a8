using System.IO;
using System.Threading;
using Gjk.Core;
using Gjk.Demo.Output;
using Gjk.Demo.Scenes;

namespace Gjk.Demo.Queries;

/// <summary>
/// Computes the distance, or the signed distance, of every pair of a scene in the poses of its first frame, and writes
/// the answers as CSV.
/// </summary>
internal static class QueryCommand
{
    /// <summary>How many pairs are answered between two checks for Ctrl-C.</summary>
    private const int PairsPerLook = 256;

    /// <param name="scene">The scene.</param>
    /// <param name="output">The file to write, or null for standard output.</param>
    /// <param name="maxDistance">Pairs further apart are reported as such, without a distance. +infinity asks for all
    /// distances.</param>
    /// <param name="depth">Whether overlapping pairs are answered with their depth.</param>
    /// <param name="cancel">Ends the work. No file is left then.</param>
    public static void Run(Scene scene, string? output, float maxDistance, bool depth, CancellationToken cancel)
    {
        if (output is null)
        {
            using Stream stdout = OutputConsole.OpenStream(cancel);
            Write(scene, stdout, maxDistance, depth, cancel);
            return;
        }

        using var file = new AtomicFile(output, cancel);
        Write(scene, file.Stream, maxDistance, depth, cancel);
        file.Commit();
    }

    private static void Write(
        Scene scene, Stream stream, float maxDistance, bool depth, CancellationToken cancel)
    {
        SceneObject[] objects = scene.Objects;
        var rows = new CsvWriter(stream);
        int untilLook = 0;
        foreach ((int a, int b) in scene.Pairs)
        {
            if (--untilLook < 0)
            {
                cancel.ThrowIfCancellationRequested();
                untilLook = PairsPerLook;
            }

            rows.Write(a, b, Answer(objects[a], objects[b], maxDistance, depth));
        }

        rows.Flush();
    }

    private static DistanceResult Answer(SceneObject a, SceneObject b, float maxDistance, bool depth)
    {
        if (depth && float.IsPositiveInfinity(maxDistance))
            return ConvexQuery.SignedDistance(a.Shape, a.Pose, b.Shape, b.Pose);
        DistanceResult result = ConvexQuery.Distance(a.Shape, a.Pose, b.Shape, b.Pose, maxDistance);
        return depth && result.IsOverlapping
            ? ConvexQuery.SignedDistance(a.Shape, a.Pose, b.Shape, b.Pose)
            : result;
    }
}
