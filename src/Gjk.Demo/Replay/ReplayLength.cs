using System;

namespace Gjk.Demo.Replay;

/// <summary>How long to measure a scene: a number of frames, or without one a span of time.</summary>
internal readonly struct ReplayLength
{
    public ReplayLength(TimeSpan duration, int? frames)
    {
        Duration = duration;
        Frames = frames;
    }

    public TimeSpan Duration { get; }

    public int? Frames { get; }

    /// <summary>How much of it is done, from 0 to 1.</summary>
    public double Done(int frames, TimeSpan elapsed) => Math.Min(Frames is int n ? (double)frames / n : elapsed / Duration, 1);
}
