namespace Gjk.Core.Diagnostics;

/// <summary>One support call on each of the two shapes, in A's own frame. Immutable.</summary>
public readonly struct TracedSupport
{
    internal TracedSupport(
        in PairFrame frame, in Double3 normal, in DifferenceVertex vertex, bool isExtended = false)
    {
        var axes = new TraceAxes(frame);
        Normal = axes.Direction(normal);
        PointOnA = axes.Vector(vertex.OnA + frame.CenterA);
        Vertex = axes.Vector(vertex.W);
        IdA = vertex.IdA;
        IdB = vertex.IdB;
        IsExtended = isExtended;
    }

    /// <summary>The nearest feature's normal, of any length: from the origin to the feature. A was asked for its
    /// furthest point against it, B for its furthest along it.</summary>
    public Double3 Normal { get; }

    /// <summary>A's support point.</summary>
    public Double3 PointOnA { get; }

    /// <summary>B's support point.</summary>
    public Double3 PointOnB => PointOnA - Vertex;

    /// <summary>Their difference, a vertex of the Minkowski difference A - B: of all its points, the one furthest
    /// against the normal.</summary>
    public Double3 Vertex { get; }

    /// <summary>The id of A's support point, or -1 where A has no vertices.</summary>
    public int IdA { get; }

    /// <summary>The id of B's support point, or -1 where B has no vertices.</summary>
    public int IdB { get; }

    /// <summary>What this proves: the plane through the vertex, perpendicular to the normal, keeps the cores at least
    /// so far apart; at or below 0 it proves nothing.</summary>
    public double LowerBound => Double3.Dot(Normal, Vertex) / Normal.Length;

    /// <summary>Whether the solver in extended precision asked.</summary>
    public bool IsExtended { get; }
}

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
    public Double3 Vertex(int index) => Vector(Guard.Index(index, Count, nameof(index), "vertex"));

    /// <summary>The vertex's barycentric weight in <see cref="Nearest"/>: at least 0, with sum 1.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The index is not below <see cref="Count"/>.</exception>
    public double Weight(int index) => _weights[Guard.Index(index, Count, nameof(index), "vertex")];

    private Double3 Vector(int index) => index < Count ? _axes.Vector(_simplex.W(_simplex[index])) : default;
}

/// <summary>Takes what a solver sees out of its units and out of the axes of A's core, to A's frame.</summary>
internal readonly struct TraceAxes(in PairFrame frame)
{
    private readonly QuaternionD? _turn = frame.TurnOfA;
    private readonly double _unit = frame.Unit;

    public double Length(double length) => length * _unit;

    public Double3 Direction(in Double3 direction) => _turn is null ? direction : _turn.Value.Rotate(direction);

    public Double3 Vector(in Double3 v) => Direction(v * _unit);
}
