using System.CommandLine;
using Gjk.Demo.View;

namespace Gjk.Demo.Queries;

/// <summary>What <c>query</c> and <c>cast</c> are asked about, a scene or one pair as a record, and where the answers
/// go.</summary>
internal sealed class PairInput
{
    private readonly SceneSource _scene = new();

    private readonly Option<string?> _record = new("--record")
    {
        Description = "Answer one query instead of a scene. The text has the form of the library's QueryRecord. "
            + "Use - to read it from standard input.",
        HelpName = "TEXT",
    };

    private readonly Option<string?> _output = new("--out")
    {
        Description = "Write the CSV to this file instead of standard output.",
        HelpName = "FILE.csv",
    };

    private readonly Option<bool> _names = new("--names")
    {
        Description = "Add the columns a_name and b_name with the names of the objects. Control characters are written "
            + "as \\u001b.",
    };

    private readonly Option<bool> _check;

    private readonly Option<Shard> _shard = Shard.Option();

    /// <summary>The option that asks for verdicts.</summary>
    public Option Check => _check;

    /// <summary>Adds the argument and the options to a command.</summary>
    /// <param name="command">The command.</param>
    /// <param name="verdicts">Which of its answers cannot be proved wholly, for the help of --check.</param>
    public PairInput(Command command, string verdicts)
    {
        _check = new("--check")
        {
            Description = "Add the column check. It says whether the supports of the shapes alone prove the answer. "
                + $"{verdicts} Exit code 1 if an answer is refuted.",
        };
        command.Add(_output);
        command.Add(_names);
        command.Add(_check);
        command.Add(_shard);
        command.Add(_scene.File);
        command.Add(_scene.BuiltIn);
        _scene.Validate(command, _record);
        command.Add(_record);
    }

    /// <summary>Reads the scene, after a check that the output may be written beside it.</summary>
    /// <param name="parsed">The arguments.</param>
    /// <param name="cancel">Ends the reading.</param>
    /// <returns>The scene, and the table for its answers.</returns>
    /// <exception cref="RefusedException">The input is not valid.</exception>
    public (Scene Scene, PairTable Table) Read(ParseResult parsed, CancellationToken cancel)
    {
        string? output = parsed.GetValue(_output);
        Scene scene = Load(parsed, output, cancel, out string name);
        bool hasNames = parsed.GetValue(_names);
        if (hasNames) ObjectNames.WarnOfRepeats(scene, name);
        Shard shard = parsed.GetValue(_shard);
        scene = shard.Cut(scene);
        return (scene, new PairTable(scene, output, hasNames, parsed.GetValue(_check), hasHeading: shard.Number == 1));
    }

    private Scene Load(ParseResult parsed, string? output, CancellationToken cancel, out string name)
    {
        if (parsed.GetValue(_record) is { } record)
        {
            TargetFiles.Check(RecordScene.InputOf(record), "the record", ("--out", output));
            name = "--record";
            return RecordScene.Read(record, cancel);
        }

        TargetFiles.Check(parsed.GetValue(_scene.File), ("--out", output));
        return _scene.Load(parsed, cancel, out name, onlyConvex: false);
    }
}
