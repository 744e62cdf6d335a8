using Gjk.Import;

namespace Gjk.Demo.Import;

/// <summary>Makes a scene of a file of another program. What cannot be read is listed on standard error, one line each,
/// and the exit code tells of it. The rest is written.</summary>
internal static class ImportCommand
{
    /// <param name="file">The file to import. Its ending says what it is.</param>
    /// <param name="project">The folder of a Unity project, or null.</param>
    /// <param name="output">The file to write, or null for standard output.</param>
    /// <param name="isConcave">Whether meshes that are not convex are written as surfaces.</param>
    /// <param name="cancel">Ends the work. No file is left then.</param>
    /// <returns><see cref="ExitCode.Failed"/> if something could not be read.</returns>
    public static int Run(string file, string? project, string? output, bool isConcave, CancellationToken cancel)
    {
        using AtomicFile? target = output is null ? null : new AtomicFile(output, cancel);
        ImportResult scene = Importer.Read(file, project, cancel);
        if (scene.Objects.Count == 0 && scene.MissingCount == 0)
            throw new RefusedException($"{file}: there is no active object with a shape in it");
        bool isEmpty = scene.Objects.Count == 0;
        if (!isEmpty) Write(Path.GetFileNameWithoutExtension(file), scene, target, isConcave, cancel);
        Print(scene.Problems.Where(problem => !isConcave || !problem.IsOfHull));
        if (scene.MissingCount == 0)
        {
            if (output is not null) StandardError.Wrote(scene.Objects.Count, "object", output);
            return ExitCode.Done;
        }

        string things = scene.MissingCount == 1 ? "1 thing" : $"{scene.MissingCount} things";
        string rest = isEmpty ? "nothing is left to write" : $"the scene has the other {Objects(scene.Objects.Count)}";
        StandardError.Line($"{file}: {things} could not be read; {rest}");
        return ExitCode.Failed;
    }

    /// <summary>Tells what could not be read, and what was read but may surprise. At the end, because a refusal must
    /// stay a single line.</summary>
    public static void Print(IEnumerable<ImportProblem> problems)
    {
        foreach (ImportProblem problem in problems) StandardError.Line(problem.ToString());
    }

    private static string Objects(int count) => count == 1 ? "object" : $"{count} objects";

    private static void Write(
        string name, ImportResult scene, AtomicFile? target, bool isConcave, CancellationToken cancel)
    {
        if (target is not null)
        {
            SceneJson.Write(target.Stream, name, scene, isConcave, cancel);
            target.Commit();
            return;
        }

        using Stream stdout = OutputConsole.OpenStream(cancel);
        SceneJson.Write(stdout, name, scene, isConcave, cancel);
    }
}
