namespace Gjk.Core.Diagnostics;

/// <summary>One support call on each of the two shapes, in A's own frame. Immutable.</summary>
public readonly struct TracedSupport
{
    internal TracedSupport(
        in PairFrame frame, in Double3 normal, in Simplex simplex, int slot, bool isExtended)
    {
        var axes = new TraceAxes(frame);
        Normal = axes.Direction(normal);
        PointOnA = axes.Vector(simplex.OnA(slot) + frame.CenterA);
        Vertex = axes.Vector(simplex.W(slot));
        IdA = simplex.IdA(slot);
        IdB = simplex.IdB(slot);
        IsExtended = isExtended;
    }

    internal TracedSupport(in PairFrame frame, in Double3 normal, in PolytopeVertex vertex)
    {
        var axes = new TraceAxes(frame);
        Normal = axes.Direction(normal);
        PointOnA = axes.Vector(vertex.OnA + frame.CenterA);
        Vertex = axes.Vector(vertex.W);
        IdA = vertex.IdA;
        IdB = vertex.IdB;
        IsExtended = false;
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
