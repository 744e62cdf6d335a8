using System.CommandLine;
using Gjk.Demo.Scenes;

namespace Gjk.Demo.View;

/// <summary>The arguments that say which scene: a file, or one of the report's two.</summary>
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

    public Argument<string?> File { get; } = new("SCENE.json") { Description = "The scene.", Arity = ArgumentArity.ZeroOrOne };

    public Option<string?> BuiltIn { get; } = new("--builtin") { Description = "Show one of the report's scenes, cubes or spheres, instead of a file.", HelpName = "NAME" };

    /// <summary>Lets the command refuse both, and neither.</summary>
    public void Validate(Command command) => command.Validators.Add(result =>
    {
        bool hasFile = result.GetResult(File) is { Implicit: false }, hasBuiltIn = result.GetResult(BuiltIn) is not null;
        if (hasFile && hasBuiltIn) result.AddError("--builtin and SCENE.json exclude each other.");
        if (!hasFile && !hasBuiltIn) result.AddError("SCENE.json or --builtin is needed.");
    });

    /// <param name="parsed">The command line.</param>
    /// <param name="name">What the user calls the scene.</param>
    public Scene Load(ParseResult parsed, out string name)
    {
        string? file = parsed.GetValue(File);
        Scene scene = file is not null ? SceneFile.Load(file) : Scene.From(parsed.GetValue(BuiltIn) == "cubes" ? BuiltInScenes.Cubes() : BuiltInScenes.Spheres());
        name = file ?? scene.Name;
        return scene;
    }
}
