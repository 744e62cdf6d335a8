namespace Gjk.Bench.Table;

/// <summary>Something that is measured in turns with others.</summary>
internal interface ITurn
{
    /// <summary>Nanoseconds per query, from the fastest sample.</summary>
    double Nanoseconds { get; }

    /// <summary>Takes samples for a short time.</summary>
    /// <returns>True if the figure fell by more than the given share.</returns>
    bool Turn(double share);

    /// <summary>Forgets the samples of the warm-up.</summary>
    void Reset();
}
