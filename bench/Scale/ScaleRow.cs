namespace Gjk.Bench.Scale;

/// <summary>The cost of a frame of a scene. Times are in milliseconds.</summary>
/// <param name="Scene">"cubes" or "spheres" for the report's scenes, or "room" for any number of cubes.</param>
/// <param name="Question">The question that each frame asks.</param>
/// <param name="Objects">How many objects there are.</param>
/// <param name="IsMoving">True if all objects move from frame to frame.</param>
/// <param name="Phase">How pairs are found.</param>
/// <param name="Threads">How many threads share the work.</param>
/// <param name="Figures">What was measured.</param>
internal sealed record ScaleRow(
    string Scene, Question Question, int Objects, bool IsMoving, Core.BroadPhaseKind Phase, int Threads,
    FrameFigures Figures);

/// <summary>The question that each frame asks.</summary>
internal enum Question
{
    /// <summary>Which pairs intersect.</summary>
    Overlaps,

    /// <summary>All distances, with warm starts from the last frame.</summary>
    Distances,
}

/// <summary>The medians over many frames. A value is null if it was not measured separately.</summary>
/// <param name="BroadMs">The time to move the objects and to find candidates.</param>
/// <param name="NarrowMs">What testing the candidates adds.</param>
/// <param name="FrameMs">The time of a whole frame.</param>
/// <param name="Candidates">The mean number of pairs that are left for the narrow phase.</param>
/// <param name="Pairs">The mean number of pairs that intersect.</param>
/// <param name="TouchingShare">The share of objects that touch another one.</param>
/// <param name="BytesPerFrame">The mean number of bytes allocated per frame after the warm-up, on all threads.</param>
/// <param name="MemoryMb">The memory of the scene, including its lists and excluding the shape.</param>
internal sealed record FrameFigures(
    double? BroadMs, double? NarrowMs, double FrameMs, double? Candidates, double Pairs, double? TouchingShare,
    double BytesPerFrame, double? MemoryMb);
