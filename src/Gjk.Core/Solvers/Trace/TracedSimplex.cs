namespace Gjk.Core.Diagnostics;

/// <summary>A simplex reduced to its feature nearest the origin: a vertex, an edge, a triangle, or the tetrahedron that
/// holds the origin. Immutable.</summary>
public readonly struct TracedSimplex
{
    private readonly Simplex _simplex;
    private readonly Weights _weights;
    private readonly TraceAxes _axes;

    internal TracedSimplex(in Simplex simplex, in PairFrame frame, bool isExtended)
    {
        _simplex = simplex;
        _axes = new TraceAxes(frame);
        _weights = ClosestPointWeights.Of(simplex);
        IsExtended = isExtended;
    }

    /// <summary>How many vertices the feature has; 4 when the solver found the origin inside.</summary>
    public int Count => _simplex.Count;

    /// <summary>v, the feature's point nearest the origin; the origin itself, up to rounding, when there are four
    /// vertices.</summary>
    public Double3 Nearest => _weights.PointOf(Vector(0), Vector(1), Vector(2), Vector(3));

    /// <summary>|v|, which the distance of the cores cannot exceed.</summary>
    public double UpperBound => Nearest.Length;

    /// <summary>Whether the solver in extended precision reduced it.</summary>
    public bool IsExtended { get; }

    /// <summary>A vertex of the Minkowski difference, in A's axes.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The index is not below <see cref="Count"/>.</exception>
    public Double3 Vertex(int index) =>
        index >= 0 && index < Count
            ? Vector(index)
            : throw new ArgumentOutOfRangeException(nameof(index), index, "There is no such vertex.");

    /// <summary>The vertex's barycentric weight in <see cref="Nearest"/>: at least 0, with sum 1.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The index is not below <see cref="Count"/>.</exception>
    public double Weight(int index) =>
        index >= 0 && index < Count
            ? _weights[index]
            : throw new ArgumentOutOfRangeException(nameof(index), index, "There is no such vertex.");

    private Double3 Vector(int index) => index < Count ? _axes.Vector(_simplex.W(_simplex[index])) : default;
}
