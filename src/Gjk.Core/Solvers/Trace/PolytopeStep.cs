namespace Gjk.Core.Diagnostics;

/// <summary>One step of the search for a depth: a closed surface of triangles inside A - B, its lowest face, the
/// support point beyond that face, and what is known of the depth by then.</summary>
/// <remarks>Directions are in A's axes, lengths in world units, both without the margins. Valid during the call that it
/// is handed to; see <see cref="IPolytopeTrace"/>.</remarks>
public readonly ref struct PolytopeStep
{
    private readonly Polytope _polytope;
    private readonly TraceAxes _axes;

    internal PolytopeStep(
        in PairFrame frame, in Polytope polytope, int lowest, PolytopeOutcome outcome, double below, double above)
    {
        _polytope = polytope;
        _axes = new TraceAxes(frame);
        Outcome = outcome;
        LowestFace = lowest;
        Below = below * frame.Unit;
        Above = above * frame.Unit;
        Support = lowest < 0
            ? default
            : new TracedSupport(frame, -polytope.Face(lowest).UnitNormal, polytope.Vertex(polytope.VertexCount - 1));
    }

    /// <summary>What the step led to; all but <see cref="PolytopeOutcome.Grows"/> end a search.</summary>
    public PolytopeOutcome Outcome { get; }

    /// <summary>How many faces the surface has; 0 where there is none to tell, because the search ended before it had
    /// four points or after it ran out of room.</summary>
    public int FaceCount
    {
        get
        {
            int count = 0;
            for (int face = NextFace(-1); face >= 0; face = NextFace(face)) count++;
            return count;
        }
    }

    /// <summary>The number of the face nearest the origin, or -1 without a surface.</summary>
    public int LowestFace { get; }

    /// <summary>How many points of A - B were found. The last one is that of <see cref="Support"/>, which is not on the
    /// surface yet; others may be inside it by now. The numbers stay until a search ends.</summary>
    public int VertexCount => _polytope.VertexCount;

    /// <summary>How many points the search has room for.</summary>
    public int Room => Polytope.Room;

    /// <summary>The support call beyond the lowest face. Its normal is the face's, turned inward. Zeros without a
    /// surface.</summary>
    public TracedSupport Support { get; }

    /// <summary>The depth of the cores is at least this: the lowest face's height, so that a ball of this radius about
    /// the origin is inside the surface. At or below 0, or negative infinity, it proves nothing yet.</summary>
    public double Below { get; }

    /// <summary>The depth of the cores is at most this: the cheapest way out so far. Negative, it is a gap that
    /// separates them.</summary>
    public double Above { get; }

    /// <summary>The number of the next face of the surface, or -1 after the last one.</summary>
    /// <param name="face">A face's number; -1 for the first. A face keeps its number until a point is found beyond it,
    /// or the numbers run out and all that are left are dealt anew.</param>
    public int NextFace(int face)
    {
        if (LowestFace < 0 || face >= _polytope.FaceCount) return -1;
        for (int next = Math.Max(face, -1) + 1; next < _polytope.FaceCount; next++)
            if (_polytope.IsLive(next)) return next;
        return -1;
    }

    /// <summary>A face.</summary>
    /// <param name="face">Its number, as <see cref="NextFace"/> gives it.</param>
    /// <exception cref="ArgumentOutOfRangeException">The surface has no such face.</exception>
    public TracedFace Face(int face) =>
        face >= 0 && LowestFace >= 0 && face < _polytope.FaceCount && _polytope.IsLive(face)
            ? new TracedFace(_polytope.Face(face), _axes)
            : throw new ArgumentOutOfRangeException(nameof(face), face, "There is no such face.");

    /// <summary>A point of A - B, in A's axes.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The index is not below <see cref="VertexCount"/>.</exception>
    public Double3 Vertex(int index) =>
        _axes.Vector(_polytope.Vertex(Guard.Index(index, VertexCount, nameof(index), "vertex")).W);
}

/// <summary>A triangle of the surface that grows inside A - B. Its corners run counterclockwise seen from outside.
/// Immutable.</summary>
public readonly struct TracedFace
{
    internal unsafe TracedFace(in PolytopeFace face, in TraceAxes axes)
    {
        A = face.Vertices[0];
        B = face.Vertices[1];
        C = face.Vertices[2];
        Normal = axes.Direction(face.UnitNormal);
        Height = axes.Length(face.Height);
    }

    /// <summary>The first corner: the number of a vertex.</summary>
    public int A { get; }

    /// <summary>The second corner.</summary>
    public int B { get; }

    /// <summary>The third corner.</summary>
    public int C { get; }

    /// <summary>The outward unit normal, in A's axes; where the triangle is a needle, that of a plane just below
    /// it.</summary>
    public Double3 Normal { get; }

    /// <summary>How far the triangle is from the origin along the normal, in world units: the least of its corners'
    /// offsets, negative where the origin is outside.</summary>
    public double Height { get; }
}
