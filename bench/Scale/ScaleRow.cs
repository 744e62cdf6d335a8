namespace Gjk.Bench.Scale;

/// <summary>What a frame of a scene costs. Times are in milliseconds.</summary>
/// <param name="Scene">The report's "cubes" or "spheres", or "room" for any number of cubes.</param>
/// <param name="Question">What is asked of the scene.</param>
/// <param name="Objects">How many.</param>
/// <param name="IsMoving">Whether all of them move from frame to frame.</param>
/// <param name="Phase">How pairs are found.</param>
/// <param name="Threads">How many share the narrow phase.</param>
/// <param name="Figures">What was measured.</param>
/// <param name="Goal">On the goals' machine; null where none was set.</param>
/// <param name="GoalHere">The goal scaled to this machine.</param>
internal sealed record ScaleRow(
    string Scene, Question Question, int Objects, bool IsMoving, Core.BroadPhaseKind Phase, int Threads, FrameFigures Figures, double? Goal = null, double? GoalHere = null)
{
    public bool? Met => GoalHere is double goal ? Figures.FrameMs <= goal : null;
}

/// <summary>What is asked in each frame.</summary>
internal enum Question
{
    /// <summary>Which pairs intersect.</summary>
    Overlaps,

    /// <summary>All distances, from where the last frame ended.</summary>
    Distances,
}

/// <summary>The medians over many frames; null where it was not measured apart.</summary>
/// <param name="BroadMs">Moving the objects and finding candidates.</param>
/// <param name="NarrowMs">Asking the candidates.</param>
/// <param name="FrameMs">Both.</param>
/// <param name="Candidates">How many pairs are left to the narrow phase; the mean.</param>
/// <param name="Pairs">How many intersect; the mean.</param>
/// <param name="TouchingShare">Of the objects.</param>
/// <param name="BytesPerFrame">Allocated after the warm-up, on all threads; the mean.</param>
/// <param name="MemoryMb">What the scene holds, its lists included and the shape excluded.</param>
internal sealed record FrameFigures(
    double? BroadMs, double? NarrowMs, double FrameMs, double? Candidates, double Pairs, double? TouchingShare, double BytesPerFrame, double? MemoryMb);
