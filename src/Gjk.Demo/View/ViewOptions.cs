using System.CommandLine;
using System.Threading;
using Gjk.Demo.Scenes;

namespace Gjk.Demo.View;

/// <summary>The command line of <c>view</c>.</summary>
internal static class ViewOptions
{
    public static Command Build(CancellationToken cancel)
    {
        var file = new Argument<string?>("SCENE.json") { Description = "The scene.", Arity = ArgumentArity.ZeroOrOne };
        var builtIn = new Option<string?>("--builtin") { Description = "Show one of the report's scenes, cubes or spheres, instead of a file.", HelpName = "NAME" };
        var page = new Option<string?>("--out") { Description = "Write the page to this file: 3D view, list of pairs and, for a moving scene, its frames.", HelpName = "FILE.html" };
        var picture = new Option<string?>("--svg") { Description = "Write a still picture of the first frame to this file.", HelpName = "FILE.svg" };
        builtIn.Validators.Add(result =>
        {
            if (result.Tokens.Count == 1 && result.Tokens[0].Value is not ("cubes" or "spheres"))
                result.AddError($"--builtin {result.Tokens[0].Value}: must be cubes or spheres.");
        });
        var command = new Command("view", "Show a scene in the browser, one file that needs no network, or as a picture.") { file, builtIn, page, picture };
        command.Validators.Add(result =>
        {
            bool hasFile = result.GetResult(file) is { Implicit: false }, hasBuiltIn = result.GetResult(builtIn) is not null;
            if (hasFile && hasBuiltIn) result.AddError("--builtin and SCENE.json exclude each other.");
            if (!hasFile && !hasBuiltIn) result.AddError("SCENE.json or --builtin is needed.");
            if (result.GetResult(page) is null && result.GetResult(picture) is null) result.AddError("--out or --svg is needed.");
        });
        command.SetAction(r =>
        {
            string? name = r.GetValue(file), html = r.GetValue(page), svg = r.GetValue(picture);
            TargetFiles.Check(name, ("--out", html), ("--svg", svg));
            Scene scene = name is not null ? SceneFile.Load(name) : Scene.From(r.GetValue(builtIn) == "cubes" ? BuiltInScenes.Cubes() : BuiltInScenes.Spheres());
            return ViewCommand.Run(scene, name ?? scene.Name, html, svg, cancel);
        });
        return command;
    }
}
