using System.CommandLine;
using Gjk.Demo.View;

namespace Gjk.Demo.Trace;

/// <summary>The command line of <c>trace</c>, and the command itself.</summary>
internal static class TraceOptions
{
    public static Command Build(CancellationToken cancel)
    {
        var source = new SceneSource();
        var pair = new Option<string?>("--pair")
        {
            Description = "The two objects, by their names or their indices in the scene, such as crate,ball or 0,1.",
            HelpName = "A,B",
        };
        var example = new ExampleOption();
        var page = new Option<string?>("--out")
        {
            Description = "Write the page to this file.",
            HelpName = "FILE.html",
            Required = true,
        };
        pair.Validators.Add(result =>
        {
            if (result.Tokens is not [{ Value: var text }]) return;
            if (!text.Contains(',') || (NamedPair.TryParseIndices(text, out int a, out int b) && a == b))
                result.AddError($"--pair {text}: must be two different objects, such as 0,1 or crate,ball.");
        });
        var command = new Command(
            "trace",
            "Write a page that shows one query step by step, with the textbook's GJK beside it. If the shapes overlap, "
            + "it shows the search for the depth, too. The page needs no network.")
        {
            source.File, source.BuiltIn, pair, example.Option, page,
        };
        source.Validate(command, example.Option);
        example.Validate(command, pair);
        command.SetAction(r =>
        {
            string html = r.GetValue(page)!;
            TargetFiles.Check(r.GetValue(source.File), ("--out", html));
            if (example.Of(r) is { } pairScene)
            {
                Write(pairScene, (0, 1), isExample: true, html, cancel);
                return ExitCode.Done;
            }

            Scene scene = source.Load(r, cancel, out string name);
            (int a, int b) = NamedPair.Find(scene, name, r.GetValue(pair)!);
            ShapeRange.Check(scene, name, a);
            ShapeRange.Check(scene, name, b);
            Write(scene, (a, b), isExample: false, html, cancel);
            return ExitCode.Done;
        });
        return command;
    }

    private static void Write(
        Scene scene, (int A, int B) pair, bool isExample, string target, CancellationToken cancel)
    {
        SceneObject a = scene.Objects[pair.A], b = scene.Objects[pair.B];
        using var file = new AtomicFile(target, cancel);
        var steps = new List<TraceStep>();
        var recorder = new TraceRecorder(steps);
        DistanceResult result = ConvexQuery.Explain(a.Shape, a.Pose, b.Shape, b.Pose, ref recorder);
        DepthAnswer? depth = result.IsOverlapping ? DepthAnswer.Of(a, b) : null;
        TracePage.Write(file.Stream, scene, pair, steps, result, depth, isExample);
        file.Commit();
        StandardError.Wrote(steps.Count + (depth?.Search.Steps.Count ?? 0), "step", target);
    }
}
