namespace Gjk.Core;

/// <summary>A corner of a flat feature.</summary>
internal struct FlatCorner
{
    /// <summary>Along the plane's axes, and how far it reaches towards the other shape.</summary>
    public double U, V, Height;

    /// <summary>Across the edge that begins here, of unit length, to the inner side.</summary>
    public double InwardU, InwardV;

    /// <summary>What tells it from the feature's others.</summary>
    public int Id;

    /// <summary>The squared distance of a place, seen along the normal.</summary>
    public readonly double SquaredTo(double u, double v) => (U - u) * (U - u) + (V - v) * (V - v);
}
