namespace Gjk.Core;

/// <summary>
/// A vertex of the Minkowski difference A - B in A's frame, with what it was made from. Coordinates are relative to the shapes' centres.
/// </summary>
internal struct MinkowskiVertex
{
    /// <summary>OnA - OnB.</summary>
    public Vector3D W;

    /// <summary>The support point of A, from A's centre.</summary>
    public Vector3D OnA;

    /// <summary>The ids of the two support points; -1 where there is none.</summary>
    public int IdA, IdB;
}
