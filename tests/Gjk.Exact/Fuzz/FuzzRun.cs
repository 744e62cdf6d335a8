using System.Diagnostics;
using System.Threading;

namespace Gjk.Exact.Fuzz;

/// <summary>A pair that breaks a promise.</summary>
/// <param name="Index">Its number in the seed's sequence.</param>
/// <param name="Family">Its family.</param>
/// <param name="Promise">What it breaks.</param>
/// <param name="How">In what way, after shrinking.</param>
/// <param name="Record">The shrunk pair in one line: a record, or a scene file where shapes are not convex.</param>
internal sealed record BrokenPromise(long Index, string Family, string Promise, string How, string Record);

/// <summary>Draws pairs and holds each to all promises until one breaks, or time, count or patience ends.</summary>
internal sealed class FuzzRun
{
    private readonly FuzzLength _length;
    private readonly IPairSource _pairs;

    public FuzzRun(FuzzLength length, ulong seed, IPairSource pairs)
    {
        _length = length;
        Seed = seed;
        _pairs = pairs;
    }

    public ulong Seed { get; }

    /// <summary>How many pairs were held to all promises.</summary>
    public long Tried { get; private set; }

    public TimeSpan Elapsed { get; private set; }

    /// <param name="progress">Told how much is done, from 0 to 1.</param>
    /// <param name="cancel">Ends the search after the pair at hand.</param>
    /// <returns>The first pair that breaks a promise, or null.</returns>
    public BrokenPromise? Search(Action<double> progress, CancellationToken cancel)
    {
        long start = Stopwatch.GetTimestamp();
        while (!cancel.IsCancellationRequested && _length.Done(Tried, Elapsed) < 1)
        {
            if (_pairs.Try(Seed, Tried, cancel) is { } broken) return broken;
            Tried++;
            Elapsed = Stopwatch.GetElapsedTime(start);
            progress(_length.Done(Tried, Elapsed));
        }

        return null;
    }
}
