using System.CommandLine;
using System.Threading;
using Gjk.Demo.Output;
using Gjk.Demo.Scenes;

namespace Gjk.Demo.View;

/// <summary>The arguments that select the scene: a file, or one of the report's two scenes.</summary>
internal sealed class SceneSource
{
    public SceneSource()
    {
        BuiltIn.Validators.Add(result =>
        {
            if (result.Tokens.Count == 1 && result.Tokens[0].Value is not ("cubes" or "spheres"))
                result.AddError($"--builtin {result.Tokens[0].Value}: must be cubes or spheres.");
        });
    }

    public Argument<string?> File { get; } = new("SCENE.json")
    {
        Description = "The scene. Use - to read it from standard input.",
        Arity = ArgumentArity.ZeroOrOne,
    };

    public Option<string?> BuiltIn { get; } = new("--builtin")
    {
        Description = "Show one of the report's scenes, cubes or spheres, instead of a file.",
        HelpName = "NAME",
    };

    /// <summary>Makes the command refuse both arguments together, and neither of them.</summary>
    /// <param name="command">The command that has both arguments.</param>
    /// <param name="unless">An option that takes the place of both.</param>
    public void Validate(Command command, Option? unless = null) => command.Validators.Add(result =>
    {
        bool hasFile = result.GetResult(File) is { Implicit: false };
        bool hasBuiltIn = result.GetResult(BuiltIn) is not null;
        if (hasFile && hasBuiltIn) result.AddError("--builtin and SCENE.json exclude each other.");
        bool isReplaced = unless is not null && result.GetResult(unless) is not null;
        if (isReplaced && (hasFile || hasBuiltIn)) result.AddError($"{unless!.Name} and a scene exclude each other.");
        if (!hasFile && !hasBuiltIn && !isReplaced) result.AddError("SCENE.json or --builtin is needed.");
    });

    /// <param name="parsed">The command line.</param>
    /// <param name="cancel">Ends the wait for a pipe.</param>
    /// <param name="name">The user's name for the scene.</param>
    public Scene Load(ParseResult parsed, CancellationToken cancel, out string name)
    {
        string? file = parsed.GetValue(File);
        if (file is not null)
        {
            name = InputFile.NameOf(file);
            return SceneFile.Load(file, cancel);
        }

        Scene scene = Scene.From(parsed.GetValue(BuiltIn) == "cubes" ? BuiltInScenes.Cubes() : BuiltInScenes.Spheres());
        name = scene.Name;
        return scene;
    }
}
