using System.CommandLine;
using System.Threading;
using Gjk.Demo.Output;
using Gjk.Demo.Scenes;

namespace Gjk.Demo.Queries;

/// <summary>What <c>query</c> and <c>cast</c> are asked about: a scene, or one pair as a record.</summary>
internal sealed class PairInput
{
    private readonly Argument<string?> _scene = new("SCENE.json")
    {
        Description = "The scene. Use - to read it from standard input.",
        Arity = ArgumentArity.ZeroOrOne,
    };

    private readonly Option<string?> _record = new("--record")
    {
        Description = "Answer one query instead of a scene. The text has the form of the library's QueryRecord. "
            + "Use - to read it from standard input.",
        HelpName = "TEXT",
    };

    /// <summary>Adds the argument and the option to a command.</summary>
    public PairInput(Command command)
    {
        command.Add(_scene);
        command.Add(_record);
        command.Validators.Add(result =>
        {
            bool hasRecord = result.GetResult(_record) is not null;
            bool hasScene = result.GetResult(_scene) is { Implicit: false };
            if (hasRecord && hasScene) result.AddError("--record and SCENE.json exclude each other.");
            if (!hasRecord && !hasScene) result.AddError("SCENE.json or --record is needed.");
        });
    }

    /// <summary>Reads the scene, after a check that the output may be written beside it.</summary>
    /// <param name="parsed">The arguments.</param>
    /// <param name="output">The file to write, or null for standard output.</param>
    /// <param name="cancel">Ends the reading.</param>
    /// <exception cref="RefusedException">The input is not valid.</exception>
    public (Scene Scene, string Name) Read(ParseResult parsed, string? output, CancellationToken cancel)
    {
        string? file = parsed.GetValue(_scene), record = parsed.GetValue(_record);
        TargetFiles.Check(file ?? RecordScene.InputOf(record!), ("--out", output));
        return file is null
            ? (RecordScene.Read(record!, cancel), "--record")
            : (SceneFile.Load(file, cancel), file);
    }
}
