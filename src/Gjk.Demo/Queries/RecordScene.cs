using System;
using System.IO;
using System.Numerics;
using Gjk.Core;
using Gjk.Demo.Output;
using Gjk.Demo.Scenes;

namespace Gjk.Demo.Queries;

/// <summary>
/// One query as text, as the library's <see cref="QueryRecord"/> writes it, as a scene of two objects.
/// </summary>
internal static class RecordScene
{
    /// <summary>
    /// What is read for the text: standard input if it is "-", where a record may be longer than a command line;
    /// otherwise no file.
    /// </summary>
    public static string? InputOf(string text) => text == TargetFiles.StandardInput ? text : null;

    /// <exception cref="RefusedException">The text is no record.</exception>
    public static Scene Read(string text)
    {
        if (text == TargetFiles.StandardInput) text = ReadInput();
        if (!QueryRecord.TryParse(text, out QueryRecord record, out string? reason))
            throw new RefusedException("--record: " + reason);
        SceneObject[] objects = [Object("A", record.A, record.PoseA), Object("B", record.B, record.PoseB)];
        return new Scene("record", objects, ScenePairs.All(objects.Length), 1);
    }

    private static SceneObject Object(string name, in ConvexShape shape, in RigidPose pose) => new(name, shape, pose, Vector3.Zero, Vector3.Zero);

    private static string ReadInput()
    {
        try
        {
            return Console.In.ReadToEnd();
        }
        catch (IOException e)
        {
            throw new RefusedException("standard input", "cannot be read", e);
        }
    }
}
