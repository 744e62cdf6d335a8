namespace Gjk.Core;

/// <summary>A vertex of A - B, with the support points that it is made from.</summary>
internal struct PolytopeVertex
{
    public Vector3D W, OnA, OnB;

    public int IdA, IdB;
}

/// <summary>A triangle of a polytope, wound so that its normal points outward.</summary>
internal unsafe struct PolytopeFace
{
    /// <summary>The unit normal.</summary>
    public Vector3D Normal;

    /// <summary>The indices of its vertices.</summary>
    public fixed ushort Vertices[3];

    /// <summary>
    /// What lies across the edge from vertex k to the next: the other face's number times 4, plus the number of the
    /// edge there.
    /// </summary>
    public fixed ushort Twins[3];
}
