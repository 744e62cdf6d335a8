using System.CommandLine;
using Gjk.Demo.Replay;

namespace Gjk.Demo.Judge;

/// <summary>Judges a table of answers, of this or any other engine, by proved ones.</summary>
internal static class JudgeCommand
{
    private const int DefaultLines = 20;

    private static readonly Fault[] Faults = [.. Enum.GetValues<Fault>().Where(f => f != Fault.None)];

    public static Command Build(CancellationToken cancel)
    {
        var results = File("RESULTS.csv", "The answers, in the columns that query or cast writes. Others are skipped.");
        var scene = File("SCENE.json", "The scene that was asked about.");
        var expected = File("EXPECTED.csv", "The proved answers, one row for each pair of SCENE.json.");
        var lines = new Option<int>("--lines")
        {
            Description = "How many wrong answers are shown.",
            HelpName = "N",
            DefaultValueFactory = _ => DefaultLines,
            CustomParser = r =>
                OptionValue.Parse<int>(r, NumberStyles.None, _ => true, "must be a whole number, at least 0") ?? 0,
        };
        var forgiven = new Option<double>("--tolerance")
        {
            Description = "Forgive errors up to this fraction of the size, for an engine in float, such as 1e-5. "
                + "Without it an answer must be right to the rounding of a float.",
            HelpName = "T",
            CustomParser = r => OptionValue.Parse<double>(
                r, NumberStyles.Float, t => t is >= 0 and < 1, "must be a number from 0 to below 1") ?? 0,
        };
        var command = new Command(
            "judge",
            "Compare the answers of an engine with proved ones. Prints the wrong ones and a table of them. Exit code "
            + "0: all are right; 1: some are not; 2: a file cannot be used.")
        {
            results, scene, expected, lines, forgiven,
        };
        command.SetAction(r => Run(
            r.GetValue(results)!, r.GetValue(scene)!, r.GetValue(expected)!, r.GetValue(lines),
            new Referee(r.GetValue(forgiven)), cancel));
        return command;
    }

    private static Argument<string> File(string name, string description) => new(name) { Description = description };

    private static int Run(
        string results, string scene, string expected, int lines, Referee referee, CancellationToken cancel)
    {
        if (new[] { results, scene, expected }.Count(file => file == InputFile.StandardInput) > 1)
            throw new RefusedException("judge: standard input can be read only once.");
        List<Truth> truths = Truth.Read(CsvTable.Load(expected, cancel), SceneFile.Load(scene, cancel));
        Dictionary<(int, int), CsvRow> answers = Answers(CsvTable.Load(results, cancel), truths);
        var rulings = new List<(Truth Truth, Ruling Ruling)>();
        foreach (Truth truth in truths)
        {
            cancel.ThrowIfCancellationRequested();
            rulings.Add((truth, referee.Judge(truth, answers.GetValueOrDefault((truth.IndexA, truth.IndexB)))));
        }

        int wrong = rulings.Count(r => r.Ruling.Fault != Fault.None);
        TextWriter text = OutputConsole.Out;
        foreach ((Truth truth, Ruling ruling) in rulings.Where(r => r.Ruling.Fault != Fault.None).Take(lines))
            text.WriteLine(PlainText.Of($"{truth.IndexA},{truth.IndexB} {truth.Case}: {ruling.Text}"));
        if (wrong > lines && lines > 0) text.WriteLine($"and {wrong - lines} more");
        TextTable.Print(OutputConsole.Create(), Rows(rulings), OutputConsole.IsPlain);
        return wrong == 0 ? ExitCode.Done : ExitCode.Failed;
    }

    /// <summary>The rows by their pair, which must be one of the scene. A pair may have one row only.</summary>
    private static Dictionary<(int, int), CsvRow> Answers(CsvTable table, List<Truth> truths)
    {
        bool isCast = truths is [{ Kind: TruthKind.Cast }, ..];
        table.Require(isCast ? ["a", "b", "status", "fraction"] : ["a", "b", "overlap", "distance"]);
        var pairs = truths.Select(t => (t.IndexA, t.IndexB)).ToHashSet();
        var answers = new Dictionary<(int, int), CsvRow>();
        foreach (CsvRow row in table.Rows)
        {
            (int A, int B) pair = (row.Index("a"), row.Index("b"));
            if (!pairs.Contains(pair)) throw row.Refuse("b", $"the scene has no pair {pair.A},{pair.B}");
            if (!answers.TryAdd(pair, row)) throw row.Refuse("b", $"the pair {pair.A},{pair.B} has a row already");
        }

        return answers;
    }

    /// <summary>A row for every family that has a wrong answer, and one for all.</summary>
    private static List<string[]> Rows(List<(Truth Truth, Ruling Ruling)> rulings)
    {
        List<string[]> rows = [["case", "pairs", "wrong", .. Faults.Select(Title), "largest error / allowed"]];
        foreach (var family in rulings.GroupBy(r => r.Truth.Case.Split('/')[0]))
        {
            Ruling[] own = [.. family.Select(r => r.Ruling)];
            if (own.Any(r => r.Fault != Fault.None)) rows.Add(Row(family.Key, own));
        }

        rows.Add(Row("all", [.. rulings.Select(r => r.Ruling)]));
        return rows;
    }

    private static string[] Row(string name, Ruling[] rulings)
    {
        double error = rulings.Select(r => r.Error).DefaultIfEmpty().Max();
        return
        [
            PlainText.Of(name), Text(rulings.Length), Text(rulings.Count(r => r.Fault != Fault.None)),
            .. Faults.Select(f => Text(rulings.Count(r => r.Fault == f))),
            error.ToString("G3", CultureInfo.InvariantCulture),
        ];
    }

    private static string Title(Fault fault) => fault switch
    {
        Fault.Missing => "no row",
        Fault.NoAnswer => "no answer",
        Fault.Wrong => "flag",
        Fault.Inaccurate => "number",
        Fault.Bound => "bound",
        Fault.Normal => "normal",
        _ => "part",
    };

    private static string Text(int number) => number.ToString(CultureInfo.InvariantCulture);
}
