namespace Gjk.Bench.Table;

/// <summary>One measured loop over a list of pairs. Its figure is that of the fastest sample, because a disturbance can
/// only add time.</summary>
internal sealed class TimedLoop : ITurn
{
    /// <summary>The least milliseconds of a sample. This is about a thousand times the cost of reading the clock, and
    /// short compared with a time slice of the scheduler.</summary>
    private const double LeastSampleMilliseconds = 0.1;

    /// <summary>The least number of samples in a turn, and its least milliseconds. The first sample brings the loop's
    /// own data back into the caches. A turn is so short that many turns fit into a second.</summary>
    private const int LeastSamples = 3;
    private const double TurnMilliseconds = 4;

    /// <summary>Milliseconds. For a longer sample one is enough, because reloading the caches takes almost no time in
    /// comparison.</summary>
    private const double LongSampleMilliseconds = 40;

    private readonly Func<float> _pass;
    private readonly int _queries;
    private int _repeats = 1;

    /// <param name="queries">How many queries a pass makes.</param>
    /// <param name="pass">Makes the queries. It returns a sum, so that the compiler cannot remove them.</param>
    public TimedLoop(int queries, Func<float> pass)
    {
        _queries = queries;
        _pass = pass;
    }

    /// <inheritdoc/>
    public double Nanoseconds { get; private set; } = double.PositiveInfinity;

    /// <inheritdoc/>
    public void Reset() => Nanoseconds = double.PositiveInfinity;

    /// <inheritdoc/>
    public bool Turn(double share)
    {
        double before = Nanoseconds;
        long start = Stopwatch.GetTimestamp();
        for (int samples = 0; !IsOver(samples, Milliseconds(start)); samples++)
            Nanoseconds = Math.Min(Nanoseconds, Sample());
        return Nanoseconds < before * (1 - share);
    }

    private static bool IsOver(int samples, double milliseconds) =>
        (samples >= LeastSamples && milliseconds >= TurnMilliseconds)
            || (samples > 0 && milliseconds >= samples * LongSampleMilliseconds);

    private double Sample()
    {
        long start = Stopwatch.GetTimestamp();
        float sum = 0;
        for (int i = 0; i < _repeats; i++) sum += _pass();
        double elapsed = Milliseconds(start);
        if (float.IsNaN(sum)) throw new FactorCheckException("A distance was NaN");
        double nanoseconds = elapsed * 1e6 / ((double)_repeats * _queries);
        if (elapsed < LeastSampleMilliseconds) _repeats *= 2;
        return nanoseconds;
    }

    private static double Milliseconds(long start) => (Stopwatch.GetTimestamp() - start) * 1e3 / Stopwatch.Frequency;
}
