using System.CommandLine;

namespace Gjk.Demo.Timing;

/// <summary>The command line of <c>time</c>.</summary>
internal static class TimeOptions
{
    /// <param name="seconds">How long to measure.</param>
    /// <param name="cancel">Ends the work.</param>
    public static Command Build(Option<double> seconds, CancellationToken cancel)
    {
        var files = new Argument<string[]>("SCENE.json")
        {
            Description = "The scenes, each at most 512 MiB. Use - to read one from standard input.",
            Arity = ArgumentArity.ZeroOrMore,
        };
        var builtIn = new BuiltInOptions();
        var command = new Command(
            "time",
            "Measure each scene and print nanoseconds per pair as one line of JSON: cold, warm, moving, boolean, "
            + "depths, casts.")
        {
            files, seconds,
        };
        builtIn.AddTo(command);
        command.Validators.Add(result =>
        {
            string[] given = [.. result.GetResult(files)?.Tokens.Select(t => t.Value) ?? []];
            if (given.Length > 0 && builtIn.IsGiven(result))
                result.AddError("--builtin and SCENE.json exclude each other.");
            if (given.Length == 0 && !builtIn.IsGiven(result)) result.AddError("SCENE.json or --builtin is needed.");
            if (given.Count(file => file == InputFile.StandardInput) > 1)
                result.AddError("standard input can be read only once.");
        });
        command.SetAction(r =>
        {
            string[] names = r.GetValue(files)!;
            List<(string Name, Scene Scene)> scenes = names.Length > 0
                ? [.. names.Select(file => (file, SceneFile.Load(file, cancel)))]
                : [(r.GetValue(builtIn.Name)!, builtIn.Load(r))];
            return TimeCommand.Run(scenes, TimeSpan.FromSeconds(r.GetValue(seconds)), cancel);
        });
        return command;
    }
}
