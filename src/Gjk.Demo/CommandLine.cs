using System.CommandLine;
using System.CommandLine.Invocation;
using System.CommandLine.Parsing;
using Gjk.Demo.Fuzz;
using Gjk.Demo.Import;
using Gjk.Demo.Judge;
using Gjk.Demo.Play;
using Gjk.Demo.Queries;
using Gjk.Demo.Replay;
using Gjk.Demo.Study;
using Gjk.Demo.Timing;
using Gjk.Demo.Trace;
using Gjk.Demo.View;

namespace Gjk.Demo;

/// <summary>The commands, their options and help.</summary>
internal static class CommandLine
{
    private const string Default = "replay";

    private const double DefaultSeconds = 3;

    /// <summary>One day. A larger value is most likely a typing error.</summary>
    private const double MaxSeconds = 86_400;

    /// <summary>Parses the arguments and runs the command. Refused arguments throw
    /// <see cref="RefusedException"/>.</summary>
    public static int Run(string[] args, CancellationToken cancel)
    {
        var root = new RootCommand(
            "Give it a scene of shapes: it tells you which of them intersect, how far apart or how deep they are, "
            + "where, and when they will touch. Without a command it runs replay.")
        {
            BuildReplay(cancel),
            QueryOptions.Build(cancel),
            BuildCast(cancel),
            JudgeCommand.Build(cancel),
            ImportOptions.Build(cancel),
            ExampleCommand.Build(cancel),
            TimeOptions.Build(Seconds(), cancel),
            FuzzOptions.Build(cancel),
            ViewOptions.Build(cancel),
            TraceOptions.Build(cancel),
            PlayOptions.Build(cancel),
            StudyCommand.Build(cancel),
        };

        // A file name may begin with @. It must not be taken for a response file with more arguments.
        ParseResult parsed = root.Parse(
            WithDefault(args), new ParserConfiguration { ResponseFileTokenReplacer = null });
        string where = parsed.CommandResult.Command is RootCommand ? "" : parsed.CommandResult.Command.Name + ": ";
        if (parsed.CommandResult.Command is RootCommand && parsed.UnmatchedTokens is [{ } word, ..] && word[0] != '-')
        {
            string meant = Suggestion.For(word, root.Subcommands.Select(c => c.Name));
            throw new RefusedException($"{word}: there is no such command{meant}");
        }

        if (StrayOption(parsed) is { } stray) throw new RefusedException(where + stray);
        if (parsed.Errors.Count > 0 && parsed.Action is ParseErrorAction)
            throw new RefusedException(where + string.Join(" ", Faults(parsed)));

        return parsed.Invoke(new InvocationConfiguration
        {
            EnableDefaultExceptionHandler = false,
            ProcessTerminationTimeout = null,
            Output = OutputConsole.Out,
        });
    }

    /// <summary>Options without a command belong to the default command, except for the options of the program
    /// itself.</summary>
    private static IReadOnlyList<string> WithDefault(string[] args)
    {
        bool isOwn = args is ["-h" or "--help" or "-?" or "--version", ..];
        bool isDefault = args.Length == 0 || (args[0].StartsWith('-') && !isOwn);
        return isDefault ? [Default, .. args] : args;
    }

    /// <summary>What is wrong, a sentence each. All that is missing is told at once, so that nobody hears of it piece
    /// by piece.</summary>
    private static IEnumerable<string> Faults(ParseResult parsed)
    {
        Command command = parsed.CommandResult.Command;
        IEnumerable<Symbol> arguments = command.Arguments
            .Where(a => a.Arity.MinimumNumberOfValues > 0 && parsed.GetResult(a) is not { Tokens.Count: > 0 });
        IEnumerable<Symbol> options = command.Options
            .Where(o => o.Required && parsed.GetResult(o)?.IdentifierToken is null);
        string[] missing = [.. arguments.Concat(options).Select(s => s.Name)];
        IEnumerable<string> faults = parsed.Errors
            .Where(e => e.SymbolResult is not (ArgumentResult { Tokens.Count: 0, Parent: CommandResult }
                or OptionResult { IdentifierToken: null }))
            .Select(e => e.SymbolResult is OptionResult { Tokens.Count: 0 } option
                ? $"{option.Option.Name}: its value is missing."
                : e.Message);
        return missing.Length == 0 ? faults : faults.Append(Missing(missing));
    }

    private static string Missing(string[] names) => names.Length == 1
        ? $"{names[0]} is needed."
        : $"{string.Join(", ", names[..^1])} and {names[^1]} are needed.";

    /// <summary>Finds an argument that looks like an option, but not like a number, and was parsed as a file or as an
    /// option's value. After "--" everything is a file.</summary>
    private static string? StrayOption(ParseResult parsed)
    {
        Token? before = null;
        foreach (Token token in parsed.Tokens.TakeWhile(t => t.Type != TokenType.DoubleDash))
        {
            if (token.Type == TokenType.Argument && token.Value is ['-', not (>= '0' and <= '9' or '.'), ..])
            {
                bool isKnown = parsed.CommandResult.Command.Options.Any(o => o.Name == token.Value);
                return isKnown && before?.Type == TokenType.Option
                    ? $"{before.Value}: its value is missing before {token.Value}."
                    : $"{token.Value}: there is no such option"
                        + Suggestion.For(token.Value, parsed.CommandResult.Command.Options.Select(o => o.Name))
                        + $"; a file of that name is ./{token.Value}";
            }

            before = token;
        }

        return null;
    }

    private static Command BuildReplay(CancellationToken cancel)
    {
        Option<double> seconds = Seconds();
        var frames = new Option<int?>("--frames")
        {
            Description = "How many frames to measure for each scene, instead of --seconds.",
            HelpName = "N",
            CustomParser = result =>
            {
                string text = result.Tokens[0].Value;
                return int.TryParse(text, NumberStyles.Integer, CultureInfo.InvariantCulture, out int n) ? n : 0;
            },
        };
        frames.Validators.Add(result => OptionValue.Check(
            result, frames, n => n >= 1, $"must be a whole number, at least 1, at most {int.MaxValue}"));
        var json = new Option<string?>("--json")
        {
            Description = "Also write the figures and all results to this file. An interrupted replay writes the "
                + "scenes that it completed, but it leaves an existing file unchanged.",
            HelpName = "FILE",
        };
        var files = new Argument<string[]>("SCENE.json")
        {
            Description = "Scenes to replay instead of the report's, such as import makes. Their objects rest. Use - "
                + "to read one from standard input.",
            Arity = ArgumentArity.ZeroOrMore,
        };
        var command = new Command(
            Default,
            "Replay the report's two scenes, with 20 objects and 190 pairs per frame, and print the report's table "
            + "beside the figures of this machine; or replay scene files in the same way.")
        {
            files, seconds, frames, json,
        };
        command.Validators.Add(result =>
        {
            string[] given = [.. result.GetResult(files)?.Tokens.Select(t => t.Value) ?? []];
            if (given.Count(file => file == InputFile.StandardInput) > 1)
                result.AddError("standard input can be read only once.");
            string? other = given.Length == 0 ? null : result.Children.OfType<OptionResult>()
                .FirstOrDefault(o => !o.Implicit && o.Option != seconds && o.Option != frames && o.Option != json)
                ?.Option.Name;
            if (other is not null) result.AddError($"{other} is for the report's scenes.");
            if (result.GetResult(seconds) is { Implicit: false } && result.GetResult(frames) is { Implicit: false })
                result.AddError("--frames and --seconds exclude each other.");
        });
        var world = new WorldOptions(command);
        Option<SphereMesh> mesh = BuiltInOptions.MeshOption();
        command.Options.Add(mesh);
        command.SetAction(r =>
        {
            var length = new ReplayLength(TimeSpan.FromSeconds(r.GetValue(seconds)), r.GetValue(frames));
            return world.Read(r) is { } settings
                ? ReplayCommand.RunWorlds(settings, r.GetValue(mesh), length, r.GetValue(json), cancel)
                : ReplayCommand.Run(r.GetValue(files)!, r.GetValue(mesh), length, r.GetValue(json), cancel);
        });
        return command;
    }

    private static Command BuildCast(CancellationToken cancel)
    {
        var command = new Command(
            "cast",
            "Move and turn every pair's objects by their velocities over one frame, and write when and where they "
            + "first touch as CSV.");
        var input = new PairInput(
            command,
            "An overlap at the start is proved-at-most: there is a way out as long as its depth, but there may be a "
                + "shorter one. The answer of a pair that turns is open.");
        command.SetAction(r =>
        {
            (Scene scene, PairTable table) = input.Read(r, cancel);
            return CastCommand.Run(scene, table, cancel);
        });
        return command;
    }

    private static Option<double> Seconds()
    {
        var seconds = new Option<double>("--seconds")
        {
            Description = "How many seconds to measure each scene.",
            HelpName = "S",
            DefaultValueFactory = _ => DefaultSeconds,
            CustomParser = OptionValue.Number<double>,
        };
        seconds.Validators.Add(result => OptionValue.Check(
            result, seconds, s => s > 0 && s <= MaxSeconds, $"must be a number above 0, at most {MaxSeconds:F0}"));
        return seconds;
    }
}
