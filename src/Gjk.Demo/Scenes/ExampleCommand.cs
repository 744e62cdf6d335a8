using System.CommandLine;
using System.Reflection;

namespace Gjk.Demo.Scenes;

/// <summary>Writes a scene with every convex shape that ends, as a beginning for the user's own.</summary>
internal static class ExampleCommand
{
    private const string Resource = "example.scene.json";

    public static Command Build(CancellationToken cancel)
    {
        var output = new Option<string?>("--out")
        {
            Description = "Write the scene to this file instead of standard output.",
            HelpName = "SCENE.json",
        };
        var command = new Command(
            "example",
            "Write a scene with every convex shape that ends, to begin with. gjk-demo query reads it.")
        {
            output,
        };
        command.SetAction(r =>
        {
            Run(r.GetValue(output), cancel);
            return ExitCode.Done;
        });
        return command;
    }

    private static void Run(string? output, CancellationToken cancel)
    {
        TargetFiles.Check(null, ("--out", output));
        using Stream example = Assembly.GetExecutingAssembly().GetManifestResourceStream(Resource)!;
        if (output is null)
        {
            using Stream stdout = OutputConsole.OpenStream(cancel);
            example.CopyTo(stdout);
            return;
        }

        using (var file = new AtomicFile(output, cancel))
        {
            example.CopyTo(file.Stream);
            file.Commit();
        }

        StandardError.Wrote(1, "scene", output);
    }
}
