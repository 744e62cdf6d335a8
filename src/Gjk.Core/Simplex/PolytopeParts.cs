namespace Gjk.Core;

/// <summary>A triangle of a polytope, wound so that its normal points outward: a line of the cache.</summary>
internal unsafe struct PolytopeFace
{
    /// <summary>The normal, of any length.</summary>
    public Double3 Normal;

    /// <summary>A point is above the face when its product with the normal is more.</summary>
    public double Limit;

    /// <summary>The least of its vertices' products with the normal.</summary>
    public double Offset;

    /// <summary>The squared length of the normal.</summary>
    public double NormalSquared;

    /// <summary>The indices of its vertices.</summary>
    public fixed ushort Vertices[4];

    /// <summary>What lies across the edge from vertex k to the next: the other face's number times 4, plus the number
    /// of the edge there.</summary>
    public fixed ushort Twins[4];

    /// <summary>How far it is from the origin along its normal: the least of its vertices' heights, negative when the
    /// origin is outside.</summary>
    public readonly double Height
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => Offset * (1 / Math.Sqrt(NormalSquared));
    }

    /// <summary>The normal, of unit length.</summary>
    public readonly Double3 UnitNormal => Normal * (1 / Math.Sqrt(NormalSquared));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void SetVertices(int a, int b, int c)
    {
        Vertices[0] = (ushort)a;
        Vertices[1] = (ushort)b;
        Vertices[2] = (ushort)c;
    }
}
