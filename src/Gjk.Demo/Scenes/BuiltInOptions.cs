using System.CommandLine;
using System.CommandLine.Parsing;

namespace Gjk.Demo.Scenes;

/// <summary>The options that select one of the report's two scenes, and the mesh of its spheres.</summary>
internal sealed class BuiltInOptions
{
    private const string Cubes = "cubes", Spheres = "spheres";

    public BuiltInOptions()
    {
        Name.Validators.Add(result =>
        {
            if (result.Tokens.Count == 1 && result.Tokens[0].Value is not (Cubes or Spheres))
                result.AddError($"--builtin {result.Tokens[0].Value}: must be cubes or spheres.");
        });
    }

    public Option<string?> Name { get; } = new("--builtin")
    {
        Description = "Take one of the report's scenes, cubes or spheres, instead of a file.",
        HelpName = "NAME",
    };

    public Option<SphereMesh> Mesh { get; } = MeshOption();

    /// <summary>The mesh of the spheres, for a command that has spheres anyway.</summary>
    public static Option<SphereMesh> MeshOption() => new("--mesh")
    {
        Description = "The mesh of the built-in spheres. even, the default: 515 distinct corners. unity: as "
            + "Unity's own sphere, 515 vertices with 386 distinct corners, as far as is known those of a cube's faces "
            + "in 8 x 8 squares, pushed out to a sphere.",
        HelpName = "even|unity",
        CustomParser = result =>
        {
            switch (result.Tokens[0].Value)
            {
                case "even":
                    return SphereMesh.Even;
                case "unity":
                    return SphereMesh.Unity;
                default:
                    result.AddError($"--mesh {result.Tokens[0].Value}: must be even or unity.");
                    return default;
            }
        },
    };

    /// <summary>Adds both options, and refuses a mesh without spheres.</summary>
    public void AddTo(Command command)
    {
        if (!command.Options.Contains(Name)) command.Options.Add(Name);
        command.Options.Add(Mesh);
        command.Validators.Add(result =>
        {
            bool hasSpheres = result.GetResult(Name) is { Tokens: [{ Value: Spheres }] };
            if (result.GetResult(Mesh) is { Implicit: false } && !hasSpheres)
                result.AddError("--mesh is for --builtin spheres.");
        });
    }

    public bool IsGiven(CommandResult result) => result.GetResult(Name) is not null;

    /// <summary>The selected scene.</summary>
    public Scene Load(ParseResult parsed) => Scene.From(
        parsed.GetValue(Name) == Cubes ? BuiltInScenes.Cubes() : BuiltInScenes.Spheres(parsed.GetValue(Mesh)));
}
