namespace Gjk.Demo.Replay;

/// <summary>How long a scene is measured: a number of frames or, if none is given, a time span.</summary>
internal readonly struct ReplayLength
{
    public ReplayLength(TimeSpan duration, int? frames)
    {
        Duration = duration;
        Frames = frames;
    }

    public TimeSpan Duration { get; }

    public int? Frames { get; }

    /// <summary>The completed share, from 0 to 1.</summary>
    public double Done(int frames, TimeSpan elapsed) =>
        Math.Min(Frames is int n ? (double)frames / n : elapsed / Duration, 1);
}
