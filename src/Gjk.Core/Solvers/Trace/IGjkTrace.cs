namespace Gjk.Core.Diagnostics;

/// <summary>Told what a distance query does, as it does it. Implement it with a struct: the query is compiled for that
/// type, so one whose <see cref="IsOn"/> is the constant false costs nothing, and the ordinary queries have such a
/// one.</summary>
/// <remarks>Everything is in A's own frame and about the cores, without their margins. Each iteration is a support,
/// then, unless that ended the query, a reduction. When double cannot decide, the query begins again in extended
/// precision, which <see cref="TracedSupport.IsExtended"/> tells.</remarks>
public interface IGjkTrace
{
    /// <summary>Whether to call the other methods at all.</summary>
    bool IsOn { get; }

    /// <summary>A vertex of the Minkowski difference was asked for.</summary>
    /// <param name="support">The direction, the two support points and what they prove.</param>
    void OnSupport(in TracedSupport support);

    /// <summary>The vertex has joined the simplex, and the simplex was reduced to its feature nearest the
    /// origin.</summary>
    /// <param name="simplex">That feature.</param>
    void OnReduced(in TracedSimplex simplex);
}

/// <summary>The trace of the queries that are not traced.</summary>
internal struct NoTrace : IGjkTrace
{
    public readonly bool IsOn => false;

    public readonly void OnSupport(in TracedSupport support)
    {
    }

    public readonly void OnReduced(in TracedSimplex simplex)
    {
    }
}
