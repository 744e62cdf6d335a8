namespace Gjk.Demo.Replay;

/// <summary>How a whole scene is replayed.</summary>
internal sealed class WorldSettings
{
    public BroadPhaseKind BroadPhase { get; init; } = BroadPhaseKind.DynamicTree;

    /// <summary>Object sizes per frame.</summary>
    public double Speed { get; init; }

    /// <summary>Null for the report's own scenes.</summary>
    public int? Objects { get; init; }

    /// <summary>How many threads work at once. This includes the calling thread.</summary>
    public int Threads { get; init; } = 1;

    /// <summary>The words on the command line, in the order of <see cref="BroadPhaseKind"/>.</summary>
    public static string[] BroadPhaseNames { get; } = ["sort", "tree"];

    public string BroadPhaseName => BroadPhaseNames[(int)BroadPhase];
}
