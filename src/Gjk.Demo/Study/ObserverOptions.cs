using System.CommandLine;
using Gjk.Demo.Study.Simulate;

namespace Gjk.Demo.Study;

/// <summary>The options that describe simulated people.</summary>
internal sealed class ObserverOptions
{
    private static readonly Observer Usual = new();

    private readonly Option<double> _bias =
        Length("--bias", "The gap that looks like touching half of the time.", Usual.Bias);
    private readonly Option<double> _noise =
        Length("--noise", "The standard deviation of a judgement.", Usual.Noise, 1e-9);
    private readonly Option<double> _between =
        Length("--between", "The bias's standard deviation between people.", Usual.Between, 0);
    private readonly Option<double> _difference =
        Length("--difference", "How much the bias grows from each pair of the plan to the next.", Usual.Difference);
    private readonly Option<double> _lapse =
        StudyCommand.Real("--lapse", "The share of careless answers at either end.", Usual.Lapse, 0, 0.5);

    public void AddTo(Command command)
    {
        foreach (Option option in (Option[])[_bias, _noise, _between, _difference, _lapse]) command.Options.Add(option);
    }

    public Observer Read(ParseResult parsed) => Usual with
    {
        Bias = parsed.GetValue(_bias),
        Noise = parsed.GetValue(_noise),
        Between = parsed.GetValue(_between),
        Difference = parsed.GetValue(_difference),
        Lapse = parsed.GetValue(_lapse),
    };

    private static Option<double> Length(string name, string description, double standard, double least = -1e6) =>
        StudyCommand.Real(name, description, standard, least, 1e6);
}
