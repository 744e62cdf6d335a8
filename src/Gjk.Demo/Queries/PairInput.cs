using System.CommandLine;
using System.Threading;
using Gjk.Demo.Output;
using Gjk.Demo.Scenes;
using Gjk.Demo.View;

namespace Gjk.Demo.Queries;

/// <summary>What <c>query</c> and <c>cast</c> are asked about: a scene, or one pair as a record.</summary>
internal sealed class PairInput
{
    private readonly SceneSource _scene = new();

    private readonly Option<string?> _record = new("--record")
    {
        Description = "Answer one query instead of a scene. The text has the form of the library's QueryRecord. "
            + "Use - to read it from standard input.",
        HelpName = "TEXT",
    };

    /// <summary>Adds the argument and the options to a command.</summary>
    public PairInput(Command command)
    {
        command.Add(_scene.File);
        command.Add(_scene.BuiltIn);
        _scene.Validate(command, _record);
        command.Add(_record);
    }

    /// <summary>Reads the scene, after a check that the output may be written beside it.</summary>
    /// <param name="parsed">The arguments.</param>
    /// <param name="output">The file to write, or null for standard output.</param>
    /// <param name="cancel">Ends the reading.</param>
    /// <exception cref="RefusedException">The input is not valid.</exception>
    public (Scene Scene, string Name) Read(ParseResult parsed, string? output, CancellationToken cancel)
    {
        if (parsed.GetValue(_record) is { } record)
        {
            TargetFiles.Check(RecordScene.InputOf(record), "the record", ("--out", output));
            return (RecordScene.Read(record, cancel), "--record");
        }

        TargetFiles.Check(parsed.GetValue(_scene.File), ("--out", output));
        Scene scene = _scene.Load(parsed, cancel, out string name);
        return (scene, name);
    }
}
