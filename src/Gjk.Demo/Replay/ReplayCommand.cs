using System;
using System.Collections.Generic;
using System.IO;
using System.Threading;
using Gjk.Demo.Output;
using Gjk.Demo.Scenes;
using Spectre.Console;

namespace Gjk.Demo.Replay;

/// <summary>The report's experiment on this machine.</summary>
internal static class ReplayCommand
{
    /// <param name="length">How long to measure each scene.</param>
    /// <param name="jsonFile">Where to write figures and results, or null.</param>
    /// <param name="cancel">Ends the work; the scenes that were completed are printed and written.</param>
    public static int Run(ReplayLength length, string? jsonFile, CancellationToken cancel)
    {
        using AtomicFile? json = jsonFile is null ? null : new AtomicFile(jsonFile);
        IAnsiConsole console = OutputConsole.Create();
        var reports = new List<SceneReport>();
        bool cancelled = false;
        ProgressBar.Show(console, OutputConsole.IsPlain, bar => cancelled = !RunScenes(length, bar, reports, cancel));
        WriteJson(json, jsonFile, reports);
        ReplayTable.Print(console, reports, OutputConsole.IsPlain);
        return cancelled ? ExitCode.Cancelled : ExitCode.Done;
    }

    /// <summary>False when it was cancelled before the last scene was complete.</summary>
    private static bool RunScenes(ReplayLength length, ProgressBar bar, List<SceneReport> reports, CancellationToken cancel)
    {
        try
        {
            foreach (BuiltInScene scene in (ReadOnlySpan<BuiltInScene>)[BuiltInScenes.Cubes(), BuiltInScenes.Spheres()])
                reports.Add(SceneReplay.Run(scene, length, bar.Add(scene.Name), cancel));
            return true;
        }
        catch (OperationCanceledException)
        {
            return false;
        }
    }

    /// <summary>Before the table, so that a full disk leaves nothing on standard output.</summary>
    private static void WriteJson(AtomicFile? json, string? name, List<SceneReport> reports)
    {
        if (json is null) return;
        try
        {
            ReplayJson.Write(json.Stream, reports);
        }
        catch (IOException e)
        {
            throw new RefusedException(name!, "cannot be written", e);
        }

        json.Commit();
    }
}
