using System.Collections.Generic;
using System.CommandLine;
using System.IO;
using System.Linq;
using System.Numerics;
using System.Threading;
using Gjk.Demo.Import;
using Gjk.Demo.Output;
using Gjk.Demo.Scenes;
using Gjk.Demo.View;
using Gjk.Import;

namespace Gjk.Demo.Play;

/// <summary>The command line of <c>play</c>, and the command itself.</summary>
internal static class PlayOptions
{
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
        var mesh = new Option<string?>("--obj")
        {
            Description = "Add the parts of this mesh file to the shapes to choose from, each as its convex "
                + "hull. Its name must end in .obj, .stl or .ply.",
            HelpName = "FILE.obj",
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
            bool hasScene = result.GetResult(scene) is not null, hasMesh = result.GetResult(mesh) is not null;
            if (hasScene && hasMesh) result.AddError("--scene and --obj exclude each other.");
            if (hasMesh && result.GetValue(mesh) is { } name && !IsPartsFile(name))
                result.AddError($"--obj {name}: its name must end in .obj, .stl or .ply.");
        });
        command.SetAction(r =>
        {
            string html = r.GetValue(page)!;
            string? sceneFile = r.GetValue(scene), meshFile = r.GetValue(mesh);
            TargetFiles.Check(sceneFile ?? meshFile, ("--out", html));
            ImportResult? parts = meshFile is null ? null : Importer.Read(meshFile, null, cancel);
            Scene? bodies = sceneFile is not null
                ? SceneFile.Load(sceneFile, cancel).Convex(InputFile.NameOf(sceneFile))
                : parts is not null ? Parts(meshFile!, parts.Objects)
                : null;
            Write(bodies, sceneFile ?? meshFile, html, cancel);
            ImportCommand.Print(parts?.Problems ?? []);
            return ExitCode.Done;
        });
        return command;
    }

    private static bool IsPartsFile(string file) =>
        Path.GetExtension(file).ToLowerInvariant() is ".obj" or ".stl" or ".ply";

    private static Scene Parts(string file, IEnumerable<ImportedObject> parts)
    {
        SceneObject[] objects =
            [.. parts.Select(o => new SceneObject(o.Name, o.ToConvexShape(), o.Pose, Vector3.Zero, Vector3.Zero))];
        return new Scene(Path.GetFileNameWithoutExtension(file), objects, ScenePairs.All(objects.Length), 1);
    }

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
