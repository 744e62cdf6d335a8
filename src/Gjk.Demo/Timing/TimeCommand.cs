using Gjk.Demo.Replay;

namespace Gjk.Demo.Timing;

/// <summary>Prints nanoseconds per pair for each scene, as one line of JSON per scene. Each line is printed as soon as
/// it is known.</summary>
internal static class TimeCommand
{
    /// <summary>Pairs. Every pair keeps a warm start, so the list must fit into memory.</summary>
    private const long MostPairs = 50_000_000;

    /// <param name="scenes">The scenes, each with the user's name for it.</param>
    /// <param name="duration">How long to measure each of them.</param>
    /// <param name="cancel">Ends the work. The lines of the finished scenes stay.</param>
    public static int Run(List<(string Name, Scene Scene)> scenes, TimeSpan duration, CancellationToken cancel)
    {
        foreach ((string name, Scene scene) in scenes)
        {
            if (scene.Pairs.Count <= MostPairs) continue;
            throw new RefusedException(
                $"{InputFile.NameOf(name)}: $.pairs: {scene.Pairs.Count} pairs, but at most {MostPairs} can be timed");
        }

        using Stream stdout = OutputConsole.OpenStream(cancel);
        foreach ((string name, Scene scene) in scenes)
        {
            SceneTimes? times = null;
            ProgressBar.Show(bars => times = new SceneTimer(scene, duration, bars.Add(scene.Name), cancel).Run());
            times!.Scene = Path.GetFileNameWithoutExtension(name);
            times.Write(stdout);
        }

        return ExitCode.Done;
    }
}
