using System;
using System.IO;
using System.Threading;
using Gjk.Demo.Output;
using Gjk.Demo.Scenes;

namespace Gjk.Demo.Timing;

/// <summary>
/// Prints nanoseconds per pair for each scene, as one line of JSON per scene. Each line is printed as soon as it is
/// known.
/// </summary>
internal static class TimeCommand
{
    /// <summary>Pairs. Every pair keeps a warm start, so the list must fit into memory.</summary>
    private const long MostPairs = 50_000_000;

    public static int Run(string[] files, TimeSpan duration, CancellationToken cancel)
    {
        Scene[] scenes = Array.ConvertAll(files, file => Load(file, cancel));
        using Stream stdout = OutputConsole.OpenStream(cancel);
        for (int i = 0; i < scenes.Length; i++)
        {
            SceneTimes times = new SceneTimer(scenes[i], duration, cancel).Run();
            times.Write(stdout, Path.GetFileNameWithoutExtension(files[i]));
        }

        return ExitCode.Done;
    }

    private static Scene Load(string file, CancellationToken cancel)
    {
        Scene scene = SceneFile.Load(file, cancel);
        return scene.Pairs.Count <= MostPairs
            ? scene
            : throw new RefusedException(
                $"{file}: $.pairs: {scene.Pairs.Count} pairs, but at most {MostPairs} can be timed");
    }
}
