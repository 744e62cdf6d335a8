using System;
using System.Numerics;
using System.Threading;
using Gjk.Core;
using Gjk.Demo.Scenes;

namespace Gjk.Demo.Queries;

/// <summary>
/// Casts every pair of a scene: its objects move by their velocities over one frame, and the first touch is written as
/// CSV.
/// </summary>
internal static class CastCommand
{
    /// <param name="scene">The scene.</param>
    /// <param name="file">Its name, for the message.</param>
    /// <param name="output">The file to write, or null for standard output.</param>
    /// <param name="cancel">Ends the work. No file is left then.</param>
    /// <exception cref="RefusedException">An object turns.</exception>
    public static void Run(Scene scene, string file, string? output, CancellationToken cancel)
    {
        SceneObject[] objects = scene.Objects;
        int turning = Array.FindIndex(objects, o => o.AngularVelocity != Vector3.Zero);
        if (turning >= 0)
        {
            throw new RefusedException(
                $"{file}: $.objects[{turning}].angularVelocity: objects that turn cannot be cast.");
        }

        PairTable.Write(
            scene, output, CsvWriter.Casts, (rows, a, b) => rows.Write(a, b, Answer(objects[a], objects[b])), cancel);
    }

    private static CastResult Answer(SceneObject a, SceneObject b) =>
        ConvexQuery.Cast(a.Shape, a.Pose, a.Velocity, b.Shape, b.Pose, b.Velocity);
}
