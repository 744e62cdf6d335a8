using System;
using System.Diagnostics;

namespace Gjk.Bench.Table;

/// <summary>One measured loop over a list of pairs. Its figure is that of the fastest sample: a disturbance only ever adds time.</summary>
internal sealed class TimedLoop
{
    /// <summary>A sample takes at least this many milliseconds: some thousand times the clock's own cost, and short against a scheduler's time slice.</summary>
    private const double LeastSampleMilliseconds = 0.1;

    /// <summary>
    /// A turn has at least this many samples, of which the first brings the loop's own data back into the caches, and lasts at least this many milliseconds:
    /// little enough that many turns fit into a second.
    /// </summary>
    private const int LeastSamples = 3;
    private const double TurnMilliseconds = 4;

    /// <summary>Milliseconds after which one sample is enough: reloading the caches is nothing beside it.</summary>
    private const double LongSampleMilliseconds = 40;

    private readonly Func<float> _pass;
    private readonly int _queries;
    private int _repeats = 1;

    /// <param name="queries">How many queries a pass makes.</param>
    /// <param name="pass">Makes them, and returns a sum that the compiler cannot leave out.</param>
    public TimedLoop(int queries, Func<float> pass)
    {
        _queries = queries;
        _pass = pass;
    }

    /// <summary>Nanoseconds per query of the fastest sample.</summary>
    public double Nanoseconds { get; private set; } = double.PositiveInfinity;

    /// <summary>Forgets the samples: they were the warm-up.</summary>
    public void Reset() => Nanoseconds = double.PositiveInfinity;

    /// <summary>Takes samples for a moment.</summary>
    /// <returns>Whether the figure fell by more than the given share.</returns>
    public bool Turn(double share)
    {
        double before = Nanoseconds;
        long start = Stopwatch.GetTimestamp();
        for (int samples = 0; !IsOver(samples, Stopwatch.GetElapsedTime(start).TotalMilliseconds); samples++)
            Nanoseconds = Math.Min(Nanoseconds, Sample());
        return Nanoseconds < before * (1 - share);
    }

    private static bool IsOver(int samples, double milliseconds) =>
        (samples >= LeastSamples && milliseconds >= TurnMilliseconds) || (samples > 0 && milliseconds >= samples * LongSampleMilliseconds);

    private double Sample()
    {
        long start = Stopwatch.GetTimestamp();
        float sum = 0;
        for (int i = 0; i < _repeats; i++) sum += _pass();
        TimeSpan elapsed = Stopwatch.GetElapsedTime(start);
        if (float.IsNaN(sum)) throw new FactorCheckException("A distance was NaN");
        double nanoseconds = elapsed.TotalNanoseconds / ((double)_repeats * _queries);
        if (elapsed.TotalMilliseconds < LeastSampleMilliseconds) _repeats *= 2;
        return nanoseconds;
    }
}
