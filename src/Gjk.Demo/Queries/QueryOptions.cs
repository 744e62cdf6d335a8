using System.CommandLine;

namespace Gjk.Demo.Queries;

/// <summary>The command line of <c>query</c>.</summary>
internal static class QueryOptions
{
    private const string DistanceRule = "must be a number, at least 0, or Infinity";

    public static Command Build(CancellationToken cancel)
    {
        Option<float> max = Distance(
            "--max-distance", "Pairs further apart than this get the status BeyondMaxDistance and no distance.");
        Option<float> within = Distance(
            "--within", "List only the pairs that are at most this far apart; with --contacts, the points.");
        var depth = new Option<bool>("--depth")
        {
            Description = "For pairs that overlap, write minus the depth, the deepest points and the shortest way out.",
        };
        var parts = new Option<bool>("--parts")
        {
            Description = "Add the columns part_a and part_b: between which triangles or parts the distance is.",
        };
        var contacts = new Option<bool>("--contacts")
        {
            Description = "Write a row for every contact point instead: those of shapes that touch or overlap, and "
                + "with --within also those whose gap is at most D.",
        };
        var command = new Command("query", "Write the distance and the closest points of every pair of a scene as CSV.")
        {
            max, within, depth, parts, contacts,
        };
        var input = new PairInput(
            command, "A depth is proved-at-most: there is such a way out, but there may be a shorter one.");
        command.Validators.Add(result =>
        {
            bool IsGiven(Option option) => result.GetResult(option) is { Implicit: false };
            if (IsGiven(max) && IsGiven(within)) result.AddError("--max-distance and --within exclude each other.");
            if (!IsGiven(contacts)) return;
            Option? other = new[] { max, depth, parts, input.Check }.FirstOrDefault(IsGiven);
            if (other is not null) result.AddError($"--contacts and {other.Name} exclude each other.");
        });
        command.SetAction(r =>
        {
            (Scene scene, PairTable table) = input.Read(r, cancel);
            bool isNear = r.GetResult(within) is { Implicit: false };
            return r.GetValue(contacts)
                ? ContactsCommand.Run(scene, table, isNear ? r.GetValue(within) : 0, cancel)
                : QueryCommand.Run(
                    scene, table, r.GetValue(isNear ? within : max), isNear, r.GetValue(depth), r.GetValue(parts),
                    cancel);
        });
        return command;
    }

    private static Option<float> Distance(string name, string description)
    {
        var option = new Option<float>(name)
        {
            Description = description,
            HelpName = "D",
            DefaultValueFactory = _ => float.PositiveInfinity,
            CustomParser = OptionValue.Number<float>,
        };
        option.Validators.Add(result =>
        {
            if (!result.Implicit) OptionValue.Check(result, option, d => d >= 0, DistanceRule);
        });
        return option;
    }
}
