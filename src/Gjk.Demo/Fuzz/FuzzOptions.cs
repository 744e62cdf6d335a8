using System.CommandLine;
using System.CommandLine.Parsing;
using Gjk.Exact.Fuzz;

namespace Gjk.Demo.Fuzz;

/// <summary>The command line of <c>fuzz</c>.</summary>
internal static class FuzzOptions
{
    private const double DefaultSeconds = 60;

    /// <summary>A month; more is a slip of the finger.</summary>
    private const double MostSeconds = 31 * 86_400.0;

    private const int MostThreads = 1024;

    public static Command Build(CancellationToken cancel)
    {
        var seconds = new Option<double?>("--seconds")
        {
            Description = "How long to search. Without it and without --count: 60.",
            HelpName = "S",
            CustomParser = r => OptionValue.Parse<double>(
                r, NumberStyles.Float, s => s > 0 && s <= MostSeconds,
                $"must be a number above 0, at most {MostSeconds:F0}"),
        };
        var count = new Option<long?>("--count", "--pairs")
        {
            Description = "End after so many pairs; 1e6 is a million.",
            HelpName = "N",
            CustomParser = r => OptionValue.Parse<long>(
                r, NumberStyles.AllowExponent, n => n >= 1, "must be a whole number, at least 1"),
        };
        var seed = new Option<ulong?>("--seed")
        {
            Description = "The seed of the random pairs: the same seed gives the same pairs. Without it, every "
                + "run takes another.",
            HelpName = "S",
            CustomParser = r => OptionValue.Parse<ulong>(
                r, NumberStyles.None, _ => true, "must be a whole number, at least 0"),
        };
        var concave = new Option<bool>("--concave")
        {
            Description = "Only pairs with a surface, solid or compound. Without it one pair of eight has one.",
        };
        Option<bool> certificate = Certificate();
        Option<string?> resume = Resume();
        Option<int?> threads = Threads();
        const string Purpose =
            "Ask random pairs of shapes until a distance, depth or cast breaks a promise of the library. Then "
            + "shrink that pair to a short record, or, of shapes that are not convex, to a scene in one line.";
        var command = new Command("fuzz", Purpose) { seconds, seed, count, concave, certificate, resume, threads };
        command.Validators.Add(result => Validate(result, seconds, count, concave, certificate, resume, threads));
        command.SetAction(r =>
        {
            if (r.GetValue(certificate))
            {
                return BlockCommand.Run(
                    r.GetValue(count) ?? 0, r.GetValue(seed), r.GetValue(resume),
                    r.GetValue(threads) ?? Environment.ProcessorCount, cancel);
            }

            double? time = r.GetValue(seconds) ?? (r.GetValue(count) is null ? DefaultSeconds : null);
            return FuzzCommand.Run(
                new FuzzLength(
                    time is null ? null : TimeSpan.FromSeconds(time.Value),
                    r.GetValue(count)), r.GetValue(seed) ?? (ulong)Random.Shared.Next(), r.GetValue(concave), cancel);
        });
        return command;
    }

    private static Option<bool> Certificate() => new("--certificate")
    {
        Description = "Judge each answer by its certificate alone, in some 15 microseconds a pair. Needs --pairs; goes "
            + "on when an answer is refuted, and ends with exit code 1 then.",
    };

    private static Option<string?> Resume() => new("--resume")
    {
        Description = "With --certificate: keep a log, a line for each finished block of a million pairs, and continue "
            + "where it ends. What is refuted is written to FILE.finds, too.",
        HelpName = "FILE",
    };

    private static Option<int?> Threads() => new("--threads")
    {
        Description = "With --certificate: on how many threads; all cores without it.",
        HelpName = "T",
        CustomParser = r => OptionValue.Parse<int>(
            r, NumberStyles.None, n => n is >= 1 and <= MostThreads, $"must be a whole number from 1 to {MostThreads}"),
    };

    private static void Validate(
        CommandResult result, Option seconds, Option count, Option concave, Option<bool> certificate, Option resume,
        Option threads)
    {
        bool isJudged = result.GetValue(certificate);
        bool Has(Option option) => result.GetResult(option) is not null;
        if (!isJudged && Has(resume)) result.AddError("--resume needs --certificate.");
        if (!isJudged && Has(threads)) result.AddError("--threads needs --certificate.");
        if (isJudged && Has(concave)) result.AddError("--certificate and --concave exclude each other.");
        if (isJudged && !Has(count)) result.AddError("--certificate needs --pairs.");
        if (isJudged && Has(seconds)) result.AddError("--certificate and --seconds exclude each other.");
    }
}
