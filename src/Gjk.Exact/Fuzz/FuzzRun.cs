using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Threading;
using Gjk.Exact.Fuzz.Families;
using Gjk.Exact.Fuzz.Promises;
using Gjk.Exact.Fuzz.Shrinking;

namespace Gjk.Exact.Fuzz;

/// <summary>A pair that breaks a promise.</summary>
/// <param name="Index">Its number in the seed's sequence.</param>
/// <param name="Family">Its family.</param>
/// <param name="Promise">What it breaks.</param>
/// <param name="How">In what way, after shrinking.</param>
/// <param name="Record">The shrunk pair as a line.</param>
internal sealed record BrokenPromise(long Index, string Family, string Promise, string How, string Record);

/// <summary>Draws pairs and holds each to all promises until one breaks, or time, count or patience ends.</summary>
internal sealed class FuzzRun
{
    private readonly FuzzLength _length;
    private readonly IReadOnlyList<Promise> _promises;

    public FuzzRun(FuzzLength length, ulong seed, IReadOnlyList<Promise> promises)
    {
        _length = length;
        Seed = seed;
        _promises = promises;
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
            FuzzPair pair = PairFamilies.Draw(Seed, Tried, out string family);
            foreach (Promise promise in _promises)
            {
                if (promise.Broken(pair) is { } how) return Smallest(pair, family, promise, how, cancel);
            }

            Tried++;
            Elapsed = Stopwatch.GetElapsedTime(start);
            progress(_length.Done(Tried, Elapsed));
        }

        return null;
    }

    private BrokenPromise Smallest(FuzzPair pair, string family, Promise promise, string how, CancellationToken cancel)
    {
        FuzzPair shrunk = Shrinker.Shrink(pair, promise, cancel);
        return new BrokenPromise(Tried, family, promise.Name, promise.Broken(shrunk) ?? how, shrunk.Text);
    }
}
