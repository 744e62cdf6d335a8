using System.CommandLine;
using System.CommandLine.Parsing;

namespace Gjk.Demo.Replay;

/// <summary>The options of <c>replay</c> that select whole worlds instead of the report's scenes.</summary>
internal sealed class WorldOptions
{
    /// <summary>Objects. The names, poses and bounds of this many take a gigabyte.</summary>
    private const int MostObjects = 1_000_000;

    /// <summary>Threads. A larger value is most likely a typing error.</summary>
    private const int MostThreads = 256;

    /// <summary>Object sizes per frame. A larger value is most likely a typing error.</summary>
    private const double MostSpeed = 1000;

    private readonly Option<BroadPhaseKind?> _broad;
    private readonly Option<double?> _motion;
    private readonly Option<int?> _objects;
    private readonly Option<int?> _threads;

    /// <summary>Adds the options to the command.</summary>
    public WorldOptions(Command command)
    {
        _broad = new("--broad")
        {
            Description = "Find the intersecting pairs of every frame instead of the report's 190 distances, by sort "
                + "and sweep or a dynamic tree (the default with the options below).",
            HelpName = string.Join('|', WorldSettings.BroadPhaseNames),
            CustomParser = BroadPhase,
        };
        _motion = new("--motion")
        {
            Description = "Move each of the report's objects by this many of its sizes per frame (0) and turn it. Find "
                + "the intersecting pairs of every frame.",
            HelpName = "SPEED",
            CustomParser = r => OptionValue.Parse<double>(
                r, NumberStyles.Float, s => s is >= 0 and <= MostSpeed,
                $"must be a number, at least 0, at most {MostSpeed:F0}"),
        };
        _objects = new("--objects")
        {
            Description = "Place this many objects in a room where about half of them touch another, instead of the "
                + "report's 20. Find the intersecting pairs.",
            HelpName = "N",
            CustomParser = r => Whole(r, 2, MostObjects),
        };
        _threads = new("--threads")
        {
            Description = "Find the intersecting pairs on this many threads (1). The hash depends neither on this nor "
                + "on --broad.",
            HelpName = "N",
            CustomParser = r => Whole(r, 1, MostThreads),
        };
        command.Options.Add(_broad);
        command.Options.Add(_motion);
        command.Options.Add(_objects);
        command.Options.Add(_threads);
    }

    /// <summary>Null if none of the options was given.</summary>
    public WorldSettings? Read(ParseResult result)
    {
        BroadPhaseKind? broad = result.GetValue(_broad);
        double? speed = result.GetValue(_motion);
        int? objects = result.GetValue(_objects), threads = result.GetValue(_threads);
        if (broad is null && speed is null && objects is null && threads is null) return null;
        return new WorldSettings
        {
            BroadPhase = broad ?? BroadPhaseKind.DynamicTree,
            Speed = speed ?? 0,
            Objects = objects,
            Threads = threads ?? 1,
        };
    }

    private static BroadPhaseKind? BroadPhase(ArgumentResult result)
    {
        int kind = Array.IndexOf(WorldSettings.BroadPhaseNames, result.Tokens is [{ Value: var name }] ? name : "");
        if (kind >= 0) return (BroadPhaseKind)kind;
        OptionValue.Refuse(result, $"must be one of {string.Join(", ", WorldSettings.BroadPhaseNames)}");
        return null;
    }

    private static int? Whole(ArgumentResult result, int least, int most) => OptionValue.Parse<int>(
        result, NumberStyles.AllowLeadingSign, n => n >= least && n <= most,
        $"must be a whole number, at least {least}, at most {most}");
}
