using System.CommandLine;
using Gjk.Demo.Import;
using Gjk.Demo.View;
using Gjk.Import;

namespace Gjk.Demo.Play;

/// <summary>The command line of <c>play</c>, and the command itself.</summary>
internal static class PlayOptions
{
    private const string PartsFiles = ".obj, .stl, .ply, .glb or .gltf";

    public static Command Build(CancellationToken cancel)
    {
        var page = new Option<string>("--out")
        {
            Description = "Write the page to this file.",
            HelpName = "FILE.html",
            Required = true,
        };
        var scene = new Option<string?>("--scene")
        {
            Description = "Add the objects of this scene to the shapes to choose from. Use - to read it from "
                + "standard input.",
            HelpName = "SCENE.json",
        };
        var mesh = new Option<string?>("--mesh", "--obj")
        {
            Description = "Add the parts of this mesh file to the shapes to choose from, each as its convex "
                + $"hull. Its name must end in {PartsFiles}.",
            HelpName = "FILE.glb",
        };
        var command = new Command(
            "play",
            "Write a page that runs this library: two shapes to move, turn and throw, with every answer while they "
            + "move, and the search in the plane step by step. It is one file that needs no network.")
        {
            page, scene, mesh,
        };
        command.Validators.Add(result =>
        {
            if (result.GetValue(mesh) is { } name && !IsPartsFile(name))
                result.AddError($"--mesh {name}: its name must end in {PartsFiles}.");
        });
        command.SetAction(r =>
        {
            string html = r.GetValue(page)!;
            string? sceneFile = r.GetValue(scene), meshFile = r.GetValue(mesh);
            TargetFiles.Check(sceneFile, ("--out", html));
            TargetFiles.Check(meshFile, "the mesh", ("--out", html));
            ImportResult? parts = meshFile is null ? null : Importer.Read(meshFile, null, cancel);
            Scene? given = sceneFile is null
                ? null
                : SceneFile.Load(sceneFile, cancel).Convex(InputFile.NameOf(sceneFile));
            Scene? bodies = parts is null ? given : WithParts(given, meshFile!, parts.Objects);
            Write(bodies, sceneFile ?? meshFile, html, cancel);
            ImportCommand.Print(parts?.Problems ?? []);
            StandardError.Line(bodies is null
                ? $"wrote the playground to {html}"
                : $"wrote the playground with {Bodies(bodies.Objects.Length)} to {html}");
            return ExitCode.Done;
        });
        return command;
    }

    private static bool IsPartsFile(string file) =>
        Path.GetExtension(file).ToLowerInvariant() is ".obj" or ".stl" or ".ply" or ".glb" or ".gltf";

    /// <summary>The bodies of a scene, if there is one, and behind them the parts of a file.</summary>
    private static Scene WithParts(Scene? scene, string file, IEnumerable<ImportedObject> parts)
    {
        SceneObject[] objects =
        [
            .. scene?.Objects ?? [],
            .. parts.Select(o => new SceneObject(o.Name, o.ToConvexShape(), o.Pose, Vector3.Zero, Vector3.Zero)),
        ];
        string name = scene?.Name ?? Path.GetFileNameWithoutExtension(file);
        return new Scene(name, objects, ScenePairs.All(objects.Length), 1);
    }

    private static string Bodies(int count) => count == 1 ? "1 body" : $"{count} bodies";

    private static void Write(Scene? scene, string? name, string target, CancellationToken cancel)
    {
        if (scene?.Objects.Length > PlayData.MostBodies)
        {
            throw new RefusedException(
                $"{name}: {scene.Objects.Length} objects are more than the {PlayData.MostBodies} that a page lists");
        }

        using var file = new AtomicFile(target, cancel);
        using var data = new PageData();
        PlayData.Write(data, scene);
        ScriptPage.Write(file.Stream, scene is null ? "Gjk playground" : $"{scene.Name}: Gjk playground", data.Text);
        file.Commit();
    }
}
