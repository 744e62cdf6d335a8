using System.CommandLine;

namespace Gjk.Demo.Trace;

/// <summary>The option of <c>trace</c> that takes the place of a scene and a pair.</summary>
internal sealed class ExampleOption
{
    private readonly Option<string?> _option = new("--example")
    {
        Description = "Instead of a scene and a pair, trace a built-in pair on which the textbook's GJK fails: loop "
            + "(it never ends) or wrong (it finds an intersection where there is none).",
        HelpName = "NAME",
    };

    public ExampleOption() => _option.Validators.Add(result =>
    {
        if (result.Tokens.Count == 1 && TextbookExamples.Named(result.Tokens[0].Value) is null)
            result.AddError($"--example {result.Tokens[0].Value}: must be loop or wrong.");
    });

    public Option Option => _option;

    /// <summary>Makes the command refuse both, and neither of them.</summary>
    public void Validate(Command command, Option pair) => command.Validators.Add(result =>
    {
        bool isExample = result.GetResult(_option) is not null, hasPair = result.GetResult(pair) is not null;
        if (isExample && hasPair) result.AddError("--example and --pair exclude each other.");
        if (!isExample && !hasPair) result.AddError("--pair is needed.");
    });

    /// <summary>The scene of the example, or null where none is asked for.</summary>
    public Scene? Of(ParseResult parsed) =>
        parsed.GetValue(_option) is { } name ? TextbookExamples.Named(name) : null;
}
