using System.Diagnostics;

namespace Gjk.Demo.Timing;

/// <summary>How long the repetitions of a pass took. Times are nanoseconds as double, because a TimeSpan counts in
/// steps of 100 ns.</summary>
internal sealed class Samples
{
    private readonly List<long> _ticks = [];
    private readonly double _nsPerTick;
    private bool _sorted;

    /// <param name="parts">How many equal parts a sample consists of. The figures are those of one part.</param>
    public Samples(long parts = 1) => _nsPerTick = 1e9 / Stopwatch.Frequency / parts;

    public int Count => _ticks.Count;

    public double MinimumNs => PercentileNs(0);

    public double MedianNs => PercentileNs(0.5);

    /// <summary>Repeats the pass for a time span, at least once.</summary>
    public static Samples Of(Action pass, TimeSpan duration, long parts, CancellationToken cancel)
    {
        var samples = new Samples(parts);
        long start = Stopwatch.GetTimestamp();
        do
        {
            cancel.ThrowIfCancellationRequested();
            long before = Stopwatch.GetTimestamp();
            pass();
            samples.Add(Stopwatch.GetTimestamp() - before);
        }
        while (Stopwatch.GetElapsedTime(start) < duration);
        return samples;
    }

    public void Add(long ticks)
    {
        _ticks.Add(ticks);
        _sorted = false;
    }

    /// <summary>The percentile of the samples: the smallest one that at least the given share of all samples does not
    /// exceed.</summary>
    public double PercentileNs(double share)
    {
        if (!_sorted) _ticks.Sort();
        _sorted = true;
        int rank = Math.Max((int)Math.Ceiling(share * _ticks.Count), 1);
        return _ticks[rank - 1] * _nsPerTick;
    }
}
