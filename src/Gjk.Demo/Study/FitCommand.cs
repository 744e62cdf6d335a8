using System.CommandLine;
using Gjk.Demo.Study.Data;
using Gjk.Demo.Study.Fit;

namespace Gjk.Demo.Study;

/// <summary>The command line of <c>study fit</c>, and the command itself.</summary>
internal sealed class FitCommand
{
    private readonly Argument<string[]> _data = new("DATA")
    {
        Description = "Files of trials, CSV or JSON, as the page of a study saves them.",
        Arity = ArgumentArity.OneOrMore,
    };

    private readonly (Option<string?> Option, bool IsFirst)[] _outputs =
    [
        (StudyCommand.Output("Write the figures as CSV to this file instead of standard output.", "FILE.csv"), true),
        (StudyCommand.Named("--page", "Also write a page with pictures and tables.", "FILE.html"), false),
        (StudyCommand.Named("--curves", "Also draw the psychometric curves.", "FILE.svg"), false),
        (StudyCommand.Named("--thresholds", "Also draw the thresholds.", "FILE.svg"), false),
    ];

    private readonly Option<string> _form = StudyCommand.Word("--form", "The curve.", "gaussian", "logistic");

    private readonly Option<string> _by =
        StudyCommand.Word("--by", "What conditions are told apart by.", "pair", "view", "both");

    private readonly Option<bool> _noLapse = new("--no-lapse")
    {
        Description = "Fit without a lapse rate, as a probit model does.",
    };

    private readonly Option<double> _errors = StudyCommand.Real(
        "--max-catch-errors", "Leave people out who fail a larger share of catch trials.", 0.25, 0, 1);

    private FitCommand()
    {
    }

    public static Command Build(CancellationToken cancel)
    {
        var fit = new FitCommand();
        var command = new Command("fit", "Fit the answers of a study: thresholds, differences and their intervals.")
        {
            fit._data, fit._form, fit._by, fit._noLapse, fit._errors,
        };
        foreach ((Option<string?> option, _) in fit._outputs) command.Options.Add(option);
        command.SetAction(r => fit.Run(r, cancel));
        return command;
    }

    private int Run(ParseResult r, CancellationToken cancel)
    {
        string[] files = r.GetValue(_data)!;
        (string, string?)[] named = [.. _outputs.Select(o => (o.Option.Name, r.GetValue(o.Option)))];
        foreach (string file in files) TargetFiles.Check(file, "the data", named);
        var settings = new AnalysisSettings
        {
            Form = r.GetValue(_form) == "logistic" ? CurveForm.Logistic : CurveForm.Gaussian,
            HasLapse = !r.GetValue(_noLapse),
            By = r.GetValue(_by)!,
            MostCatchErrors = r.GetValue(_errors),
        };
        List<Trial> trials = TrialFiles.Load(files, cancel);
        StudyAnalysis analysis = Analyse(files, trials, settings);
        string[] texts =
        [
            StudyReport.Csv(analysis), StudyReport.Page(analysis, trials, settings),
            StudyPlot.PsychometricCurves(analysis), StudyPlot.Thresholds(analysis),
        ];
        StudyCommand.Write(
            cancel,
            [
                .. _outputs.Zip(texts).Where(o => o.First.IsFirst || r.GetValue(o.First.Option) is not null)
                    .Select(o => (r.GetValue(o.First.Option), o.Second)),
            ]);
        StandardError.Line(StudyReport.Exclusions(analysis, settings));
        return ExitCode.Done;
    }

    private static StudyAnalysis Analyse(string[] files, List<Trial> trials, AnalysisSettings settings)
    {
        try
        {
            return new StudyAnalysis(trials, settings);
        }
        catch (RefusedException e)
        {
            throw new RefusedException($"{string.Join(", ", files.Select(InputFile.NameOf))}: {e.Message}");
        }
    }
}
