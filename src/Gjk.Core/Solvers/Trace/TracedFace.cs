namespace Gjk.Core.Diagnostics;

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
