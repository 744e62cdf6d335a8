using System.CommandLine;

namespace Gjk.Demo.View;

/// <summary>The arguments that select the scene: a file, standard input, or one of the report's two scenes.</summary>
internal sealed class SceneSource
{
    private readonly BuiltInOptions _builtIn = new();

    public Argument<string?> File { get; } = new("SCENE.json")
    {
        Description = "The scene, at most 512 MiB. Use - to read it from standard input.",
        Arity = ArgumentArity.ZeroOrOne,
    };

    public Option<string?> BuiltIn => _builtIn.Name;

    /// <summary>Adds the option for the mesh of a built-in scene, and makes the command refuse two sources, and
    /// none.</summary>
    /// <param name="command">The command, which has the argument and the option.</param>
    /// <param name="other">Another option that can take the place of a scene.</param>
    public void Validate(Command command, Option? other = null)
    {
        _builtIn.AddTo(command);
        command.Validators.Add(result =>
        {
            bool hasFile = result.GetResult(File) is { Implicit: false };
            bool hasBuiltIn = _builtIn.IsGiven(result);
            bool hasOther = other is not null && result.GetResult(other) is not null;
            if (hasFile && hasBuiltIn) result.AddError("--builtin and SCENE.json exclude each other.");
            else if (hasOther && hasFile) result.AddError($"{other!.Name} and SCENE.json exclude each other.");
            else if (hasOther && hasBuiltIn) result.AddError($"{other!.Name} and --builtin exclude each other.");
            if (hasFile || hasBuiltIn || hasOther) return;
            result.AddError(
                other is null
                    ? "SCENE.json or --builtin is needed."
                    : $"SCENE.json, --builtin or {other.Name} is needed.");
        });
    }

    /// <param name="parsed">The command line.</param>
    /// <param name="cancel">Ends the wait for a pipe.</param>
    /// <param name="name">The user's name for the scene.</param>
    /// <param name="onlyConvex">Whether surfaces and compounds are refused.</param>
    public Scene Load(ParseResult parsed, CancellationToken cancel, out string name, bool onlyConvex = true)
    {
        string? file = parsed.GetValue(File);
        if (file is not null)
        {
            name = InputFile.NameOf(file);
            Scene loaded = SceneFile.Load(file, cancel);
            return onlyConvex ? loaded.Convex(name) : loaded;
        }

        Scene scene = _builtIn.Load(parsed);
        name = scene.Name;
        return scene;
    }
}
