using Spectre.Console;

namespace Gjk.Demo.Replay;

/// <summary>Repeats the report's experiment on this machine, or replays a whole world of its objects.</summary>
internal static class ReplayCommand
{
    /// <summary>Replays the report's scenes, or those of files. Each frame asks for the closest points of all
    /// pairs.</summary>
    /// <param name="files">Scene files; none for the report's scenes.</param>
    /// <param name="mesh">The mesh of the report's spheres.</param>
    /// <param name="length">How long to measure each scene.</param>
    /// <param name="jsonFile">Where to write figures and results, or null.</param>
    /// <param name="cancel">Ends the work. Completed scenes are still printed. They are also written, unless that would
    /// replace a file.</param>
    public static int Run(
        string[] files, SphereMesh mesh, ReplayLength length, string? jsonFile, CancellationToken cancel)
    {
        foreach (string file in files) TargetFiles.Check(file, ("--json", jsonFile));

        // A scene is refused before another one is measured.
        ReplayScene[] given = Array.ConvertAll(files, file => ReplayScene.Load(file, cancel));
        return Run(
            given.Length > 0
                ? Array.ConvertAll(given, scene => (Func<ReplayScene>)(() => scene))
                : [
                    () => ReplayScene.Of(BuiltInScenes.Cubes()),
                    () => ReplayScene.Of(BuiltInScenes.Spheres(mesh)),
                ],
            scene => scene.Scene.Name,
            (scene, progress) => SceneReplay.Run(scene, length, progress, cancel),
            jsonFile,
            ReplayJson.Write,
            ReplayTable.Print);
    }

    /// <summary>Replays the same scenes, or larger ones of their kind. The objects may move, and each frame finds the
    /// intersecting pairs.</summary>
    /// <param name="settings">How many objects there are, how they move and how pairs are found.</param>
    /// <param name="mesh">The mesh of the spheres.</param>
    /// <param name="length">How long to measure each scene.</param>
    /// <param name="jsonFile">Where to write figures and pairs, or null.</param>
    /// <param name="cancel">Ends the work. Completed scenes are still printed. They are also written, unless that would
    /// replace a file.</param>
    public static int RunWorlds(
        WorldSettings settings, SphereMesh mesh, ReplayLength length, string? jsonFile, CancellationToken cancel)
    {
        Func<BuiltInScene>[] scenes = settings.Objects is int count
            ? [() => BuiltInScenes.Cubes(count), () => BuiltInScenes.Spheres(count, mesh)]
            : [BuiltInScenes.Cubes, () => BuiltInScenes.Spheres(mesh)];
        return Run(
            scenes,
            scene => scene.Name,
            (scene, progress) => WorldReplay.Run(scene, settings, length, progress, cancel),
            jsonFile,
            ReplayJson.Write,
            WorldTable.Print);
    }

    private static int Run<TScene, TReport>(
        Func<TScene>[] scenes, Func<TScene, string> nameOf, Func<TScene, Action<double>, TReport> replay,
        string? jsonFile, Action<Stream, IReadOnlyList<TReport>> writeJson,
        Action<IAnsiConsole, IReadOnlyList<TReport>, bool> print)
    {
        TargetFiles.Check(null, ("--json", jsonFile));
        if (jsonFile is not null) AtomicFile.Check(jsonFile);
        IAnsiConsole console = OutputConsole.Create();
        bool isWritten = false;
        var reports = new List<TReport>();
        bool cancelled = false;
        ProgressBar.Show(bar => cancelled = !RunScenes(scenes, nameOf, replay, bar, reports));
        if (jsonFile is not null && reports.Count > 0)
            isWritten = WriteJson(jsonFile, !cancelled, stream => writeJson(stream, reports));
        print(console, reports, OutputConsole.IsPlain);
        if (isWritten) StandardError.Wrote(reports.Count, "scene", jsonFile!);
        return cancelled ? ExitCode.Cancelled : ExitCode.Done;
    }

    /// <summary>False if it was cancelled before the last scene was complete.</summary>
    private static bool RunScenes<TScene, TReport>(
        Func<TScene>[] scenes, Func<TScene, string> nameOf, Func<TScene, Action<double>, TReport> replay,
        ProgressBar bar, List<TReport> reports)
    {
        try
        {
            foreach (Func<TScene> make in scenes)
            {
                TScene scene = make();
                reports.Add(replay(scene, bar.Add(nameOf(scene))));
            }

            return true;
        }
        catch (OperationCanceledException)
        {
            return false;
        }
    }

    /// <summary>Writes the file before the table is printed, so that a full disk leaves nothing on standard output. A
    /// cancelled replay has only some of the scenes, or none. It may create a new file, but it must not replace a
    /// complete one.</summary>
    /// <returns>True if the file was written.</returns>
    private static bool WriteJson(string name, bool isComplete, Action<Stream> write)
    {
        using var json = new AtomicFile(name, CancellationToken.None);
        if (!isComplete && json.ReplacesAFile) return false;
        write(json.Stream);
        json.Commit();
        return true;
    }
}
