using System;
using System.Collections.Generic;
using System.IO;
using System.Threading;
using Gjk.Demo.Output;
using Gjk.Demo.Scenes;
using Spectre.Console;

namespace Gjk.Demo.Replay;

/// <summary>The report's experiment on this machine, or a whole world of its objects.</summary>
internal static class ReplayCommand
{
    /// <summary>The report's scenes, all pairs and their closest points in each frame.</summary>
    /// <param name="length">How long to measure each scene.</param>
    /// <param name="jsonFile">Where to write figures and results, or null.</param>
    /// <param name="cancel">Ends the work; the scenes that were completed are printed, and written where no file would
    /// be replaced.</param>
    public static int Run(ReplayLength length, string? jsonFile, CancellationToken cancel) => Run(
        [BuiltInScenes.Cubes, BuiltInScenes.Spheres],
        (scene, progress) => SceneReplay.Run(scene, length, progress, cancel), jsonFile, ReplayJson.Write, ReplayTable.Print);

    /// <summary>
    /// The same scenes, or larger ones of their kind, moving if they are to; and their intersecting pairs in each
    /// frame.
    /// </summary>
    /// <param name="settings">How many objects, and how they move and are found.</param>
    /// <param name="length">How long to measure each scene.</param>
    /// <param name="jsonFile">Where to write figures and pairs, or null.</param>
    /// <param name="cancel">Ends the work; the scenes that were completed are printed, and written where no file would
    /// be replaced.</param>
    public static int RunWorlds(WorldSettings settings, ReplayLength length, string? jsonFile, CancellationToken cancel) => Run(
        settings.Objects is int count ? [() => BuiltInScenes.Cubes(count), () => BuiltInScenes.Spheres(count)] : [BuiltInScenes.Cubes, BuiltInScenes.Spheres],
        (scene, progress) => WorldReplay.Run(scene, settings, length, progress, cancel), jsonFile, ReplayJson.Write, WorldTable.Print);

    private static int Run<TReport>(
        Func<BuiltInScene>[] scenes, Func<BuiltInScene, Action<double>, TReport> replay, string? jsonFile,
        Action<Stream, IReadOnlyList<TReport>> writeJson, Action<IAnsiConsole, IReadOnlyList<TReport>, bool> print)
    {
        TargetFiles.Check(null, ("--json", jsonFile));
        if (jsonFile is not null) AtomicFile.Check(jsonFile);
        IAnsiConsole console = OutputConsole.Create();
        var reports = new List<TReport>();
        bool cancelled = false;
        ProgressBar.Show(console, OutputConsole.IsPlain, bar => cancelled = !RunScenes(scenes, replay, bar, reports));
        if (jsonFile is not null && reports.Count > 0)
            WriteJson(jsonFile, !cancelled, stream => writeJson(stream, reports));
        print(console, reports, OutputConsole.IsPlain);
        return cancelled ? ExitCode.Cancelled : ExitCode.Done;
    }

    /// <summary>False when it was cancelled before the last scene was complete.</summary>
    private static bool RunScenes<TReport>(Func<BuiltInScene>[] scenes, Func<BuiltInScene, Action<double>, TReport> replay, ProgressBar bar, List<TReport> reports)
    {
        try
        {
            foreach (Func<BuiltInScene> make in scenes)
            {
                BuiltInScene scene = make();
                reports.Add(replay(scene, bar.Add(scene.Name)));
            }

            return true;
        }
        catch (OperationCanceledException)
        {
            return false;
        }
    }

    /// <summary>
    /// Before the table, so that a full disk leaves nothing on standard output. A cancelled replay has only a part of
    /// the scenes, or none: that makes a new file, but takes no complete one's place.
    /// </summary>
    private static void WriteJson(string name, bool isComplete, Action<Stream> write)
    {
        using var json = new AtomicFile(name, CancellationToken.None);
        if (!isComplete && json.ReplacesAFile) return;
        write(json.Stream);
        json.Commit();
    }
}
