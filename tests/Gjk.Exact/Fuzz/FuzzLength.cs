namespace Gjk.Exact.Fuzz;

/// <summary>How long to search: for a time, for a number of pairs, or until the first of both is over.</summary>
internal readonly struct FuzzLength
{
    private readonly TimeSpan? _time;
    private readonly long? _pairs;

    public FuzzLength(TimeSpan? time, long? pairs)
    {
        _time = time;
        _pairs = pairs;
    }

    /// <summary>How much of it is over; from 1 on, all.</summary>
    public double Done(long tried, TimeSpan elapsed) =>
        Math.Max(_time is { } time ? elapsed / time : 0, _pairs is { } pairs ? tried / (double)pairs : 0);
}
