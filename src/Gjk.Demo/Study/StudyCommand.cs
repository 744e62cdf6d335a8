using System.CommandLine;
using System.CommandLine.Parsing;
using Gjk.Demo.Study.Data;
using Gjk.Demo.Study.Plan;
using Gjk.Demo.Study.Saves;
using Gjk.Demo.Study.Simulate;
using Gjk.Demo.View;

namespace Gjk.Demo.Study;

/// <summary>The command line of <c>study</c>: its plan, its data and what follows from them.</summary>
internal static class StudyCommand
{
    private const string DefaultPlan = "default.plan.json";

    public static Command Build(CancellationToken cancel) => new(
        "study",
        "A perceptual study: how near two objects come before people see them touch. Plan it, run it in a browser, and "
        + "fit the answers.")
    {
        BuildPlan(cancel), StudyPage.Build(cancel), FitCommand.Build(cancel), BuildSimulate(cancel), BuildPower(cancel),
        SavesCommand.Build(cancel),
    };

    /// <summary>Writes texts to files, and says so, or to standard output. No file appears before all are
    /// complete.</summary>
    public static void Write(CancellationToken cancel, params (string? File, string Text)[] outputs)
    {
        var files = new List<AtomicFile>();
        try
        {
            foreach ((string? file, string text) in outputs)
            {
                if (file is null)
                {
                    OutputConsole.Out.Write(text);
                    continue;
                }

                files.Add(new AtomicFile(file, cancel));
                PageText.Add(files[^1].Stream, text);
            }

            foreach (AtomicFile file in files) file.Complete();
            foreach (AtomicFile file in files) file.Commit();
            foreach ((string? file, _) in outputs)
            {
                if (file is not null) StandardError.Line($"wrote {file}");
            }
        }
        finally
        {
            foreach (AtomicFile file in files) file.Dispose();
        }
    }

    private static Command BuildPlan(CancellationToken cancel)
    {
        Option<string?> output = Output("Write the plan to this file instead of standard output.", "PLAN.json");
        var check = new Option<string?>("--check")
        {
            Description = "Read this plan instead, and say what it asks of a person.",
            HelpName = "PLAN.json",
        };
        var command =
            new Command("plan", "Write a plan in which every field is explained, to begin with.") { output, check };
        command.SetAction(r =>
        {
            if (r.GetValue(check) is { } file)
            {
                StudyPlan plan = StudyPlanFile.Load(file, cancel);
                Write(cancel, (r.GetValue(output),
                    $"{PlainText.Of(plan.Name)}: {Count(plan.Pairs.Count, "pair")}, {Count(plan.Views.Count, "view")}, "
                    + $"{StudyPlanFile.TrialsOf(plan)} trials for each person, plan {plan.Id}\n"));
                return ExitCode.Done;
            }

            Write(cancel, (r.GetValue(output), PageText.Asset(DefaultPlan)));
            return ExitCode.Done;
        });
        return command;
    }

    private static string Count(int count, string word) => count == 1 ? $"1 {word}" : $"{count} {word}s";

    private static Command BuildSimulate(CancellationToken cancel)
    {
        Option<string?> plan = Named("--plan", "The plan; the default one if none is given.", "PLAN.json");
        Option<string?> output = Output("Write the data to this file instead of standard output.", "DATA.csv");
        Option<int> people = Whole("--people", "How many people.", 12, 1, 10_000);
        Option<int> seed = Whole("--seed", "Where the random numbers begin.", 1, 0, int.MaxValue);
        var observer = new ObserverOptions();
        var command = new Command("simulate", "Write the data of simulated people with known bias, noise and lapses.")
        {
            plan, output, people, seed,
        };
        observer.AddTo(command);
        command.SetAction(r =>
        {
            TargetFiles.Check(r.GetValue(plan), "the plan", ("--out", r.GetValue(output)));
            StudyPlan study = LoadPlan(r.GetValue(plan), cancel);
            var csv = new StringBuilder(Trial.Header + "\n");
            foreach (Trial trial in Simulation.Run(study, observer.Read(r), r.GetValue(people), r.GetValue(seed)))
            {
                cancel.ThrowIfCancellationRequested();
                csv.Append(trial.ToCsv()).Append('\n');
            }

            Write(cancel, (r.GetValue(output), csv.ToString()));
            return ExitCode.Done;
        });
        return command;
    }

    private static Command BuildPower(CancellationToken cancel)
    {
        Option<string?> plan =
            Named("--plan", "The plan whose gaps are shown; the default one if none is given.", "PLAN.json");
        Option<string?> output = Output("Write the table to this file instead of standard output.", "FILE.csv");
        Option<int> studies = Whole("--studies", "Simulated studies for each row.", 200, 20, 100_000);
        Option<int> most = Whole("--people", "The most people to try.", 60, 4, 1_000);
        Option<int> seed = Whole("--seed", "Where the random numbers begin.", 1, 0, int.MaxValue);
        var observer = new ObserverOptions();
        var command = new Command(
            "power",
            "Say how many people and trials find a difference of --difference between two conditions in 80 % of "
                + "studies.")
        {
            plan, output, studies, most, seed,
        };
        observer.AddTo(command);
        command.SetAction(r =>
        {
            TargetFiles.Check(r.GetValue(plan), "the plan", ("--out", r.GetValue(output)));
            ConstantPlan task = LoadPlan(r.GetValue(plan), cancel).Constant
                ?? throw new RefusedException("power: the plan has no task constant");
            var simulation = new PowerSimulation(observer.Read(r), task.Gaps, r.GetValue(studies), r.GetValue(seed));
            var csv = new StringBuilder("people,trials_per_gap,trials_per_person,power,enough\n");
            int[] trials = [.. ((int[])[task.Repeats, 2 * task.Repeats, 4 * task.Repeats]).Distinct()];
            foreach (PowerPoint p in simulation.Until(trials, r.GetValue(most)))
            {
                cancel.ThrowIfCancellationRequested();
                int each = 2 * p.TrialsPerGap * task.Gaps.Length;
                string enough = p.Power >= PowerSimulation.Wanted ? "yes" : "no";
                csv.Append(
                    CultureInfo.InvariantCulture, $"{p.People},{p.TrialsPerGap},{each},{p.Power:F3},{enough}\n");
            }

            Write(cancel, (r.GetValue(output), csv.ToString()));
            return ExitCode.Done;
        });
        return command;
    }

    /// <summary>A plan from a file, or the default one.</summary>
    public static StudyPlan LoadPlan(string? file, CancellationToken cancel) => file is null
        ? StudyPlanFile.Parse(DefaultPlan, Encoding.UTF8.GetBytes(PageText.Asset(DefaultPlan)))
        : StudyPlanFile.Load(file, cancel);

    public static Option<string?> Output(string description, string name) => Named("--out", description, name);

    public static Option<string?> Named(string option, string description, string name) =>
        new(option) { Description = description, HelpName = name };

    public static Option<string> Word(string name, string description, params string[] words)
    {
        var option = new Option<string>(name)
        {
            Description = description,
            HelpName = string.Join('|', words),
            DefaultValueFactory = _ => words[0],
        };
        option.Validators.Add(result =>
        {
            if (result.Tokens.Count == 1 && !words.Contains(result.Tokens[0].Value))
                result.AddError($"{name} {result.Tokens[0].Value}: must be {string.Join(" or ", words)}.");
        });
        return option;
    }

    public static Option<int> Whole(string name, string description, int standard, int least, int most) =>
        Number(name, description, standard, least, most, "a whole number");

    public static Option<double> Real(string name, string description, double standard, double least, double most) =>
        Number(name, description, standard, least, most, "a number");

    private static Option<T> Number<T>(string name, string description, T standard, T least, T most, string what)
        where T : struct, IParsable<T>, IComparable<T>
    {
        bool Parse(SymbolResult result, out T value) =>
            T.TryParse(result.Tokens[0].Value, CultureInfo.InvariantCulture, out value)
            && value.CompareTo(least) >= 0 && value.CompareTo(most) <= 0;
        var option = new Option<T>(name)
        {
            Description = description,
            HelpName = "N",
            DefaultValueFactory = _ => standard,
            CustomParser = result => Parse(result, out T value) ? value : standard,
        };
        option.Validators.Add(result =>
        {
            if (result.Tokens.Count == 1 && !Parse(result, out _))
            {
                result.AddError(FormattableString.Invariant(
                    $"{name} {result.Tokens[0].Value}: must be {what}, {least} to {most}."));
            }
        });
        return option;
    }
}
