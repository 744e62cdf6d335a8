using System.CommandLine;
using Gjk.Import;

namespace Gjk.Demo.Import;

/// <summary>The command line of <c>import</c>.</summary>
internal static class ImportOptions
{
    public static Command Build(CancellationToken cancel)
    {
        var file = new Argument<string>("FILE")
        {
            Description = "What to import. Its name must end in " + Importer.Endings + ". Each part of a mesh file is "
                + "an object (o and g of an OBJ, a solid of an STL, a primitive in its place of a glTF). A mesh counts "
                + "as its convex hull; a part that is not convex gets a warning.",
        };
        var output = new Option<string?>("--out")
        {
            Description = "Write the scene to this file instead of standard output.",
            HelpName = "SCENE.json",
        };
        var project = new Option<string?>("--project")
        {
            Description = "The Unity project that FILE needs for its prefabs and meshes. By default the folder that "
                + "holds the Assets folder above FILE.",
            HelpName = "DIR",
        };
        var concave = new Option<bool>("--concave")
        {
            Description = "Write a mesh that is not convex as the surface of its triangles, and as a solid if it is "
                + "closed and consistently oriented. Convex meshes, and those without faces, stay hulls.",
        };
        var command = new Command(
            "import",
            "Make a scene of a Unity scene or prefab, or of a mesh file. Units and axes stay as they are: Unity's axes "
            + "are left-handed, which changes no distance. An object of Unity becomes its enabled colliders, or its "
            + "mesh if it has none; inactive objects are left out. Unity's own sphere, capsule and cylinder become the "
            + "smooth shapes. What cannot be read is counted, and the first of each kind listed on standard error with "
            + "file, line and fileID; the rest is "
            + "written, and the exit code is 1.")
        {
            file, output, project, concave,
        };
        command.Validators.Add(result =>
        {
            if (result.GetResult(file) is not { Implicit: false } || result.GetValue(file) is not { } name) return;
            if (!Importer.CanRead(name))
                result.AddError(Importer.Refusal(name) + ".");
            else if (!Importer.IsUnityFile(name) && result.GetResult(project) is not null)
                result.AddError("--project is for files of Unity.");
        });
        command.SetAction(r =>
        {
            string name = r.GetValue(file)!;
            string? target = r.GetValue(output);
            TargetFiles.Check(name, "the file that is imported", ("--out", target));
            return ImportCommand.Run(name, r.GetValue(project), target, r.GetValue(concave), cancel);
        });
        return command;
    }
}
