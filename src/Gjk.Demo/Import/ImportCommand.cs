using System.IO;
using System.Threading;
using Gjk.Demo.Import.Meshes;
using Gjk.Demo.Import.Unity;
using Gjk.Demo.Output;

namespace Gjk.Demo.Import;

/// <summary>
/// Makes a scene of a file of another program. What cannot be read is listed on standard error, one line each, and the
/// exit code tells of it. The rest is written.
/// </summary>
internal static class ImportCommand
{
    /// <param name="file">The file to import. Its ending says what it is.</param>
    /// <param name="project">The folder of a Unity project, or null.</param>
    /// <param name="output">The file to write, or null for standard output.</param>
    /// <param name="cancel">Ends the work. No file is left then.</param>
    /// <returns><see cref="ExitCode.Failed"/> if something could not be read.</returns>
    public static int Run(string file, string? project, string? output, CancellationToken cancel)
    {
        using AtomicFile? target = output is null ? null : new AtomicFile(output, cancel);
        var scene = new SceneBuilder();
        var log = new ImportLog();
        Read(file, project, scene, log, cancel);
        if (scene.Objects.Count == 0 && log.Missing == 0)
            throw new RefusedException($"{file}: there is no active object with a shape in it");
        bool isEmpty = scene.Objects.Count == 0;
        if (!isEmpty) Write(Path.GetFileNameWithoutExtension(file), scene, target, cancel);
        log.Print();
        if (log.Missing == 0)
        {
            if (output is not null) StandardError.Wrote(scene.Objects.Count, "object", output);
            return ExitCode.Done;
        }

        string things = log.Missing == 1 ? "1 thing" : $"{log.Missing} things";
        string rest = isEmpty ? "nothing is left to write" : $"the scene has the other {Objects(scene.Objects.Count)}";
        StandardError.Line($"{file}: {things} could not be read; {rest}");
        return ExitCode.Failed;
    }

    /// <summary>Reads a file of any of the formats.</summary>
    /// <exception cref="RefusedException">The file cannot be used at all.</exception>
    public static void Read(
        string file, string? project, SceneBuilder scene, ImportLog log, CancellationToken cancel)
    {
        if (UnityImport.IsUnityFile(file)) UnityImport.Import(file, project, scene, log, cancel);
        else if (MeshFile.IsGlb(file)) GlbImport.Import(file, scene, log, cancel);
        else MeshFile.Import(file, scene, log, cancel);
    }

    private static string Objects(int count) => count == 1 ? "object" : $"{count} objects";

    private static void Write(string name, SceneBuilder scene, AtomicFile? target, CancellationToken cancel)
    {
        if (target is not null)
        {
            SceneJson.Write(target.Stream, name, scene, cancel);
            target.Commit();
            return;
        }

        using Stream stdout = OutputConsole.OpenStream(cancel);
        SceneJson.Write(stdout, name, scene, cancel);
    }
}
