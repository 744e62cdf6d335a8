namespace Gjk.Core;

/// <summary>The vertices of the feature nearest the origin, newest first: a vertex (A), an edge (A, B) or a face (A, B,
/// C).</summary>
internal struct FeatureVertices
{
    /// <summary>For each set of slots, two bits: the lowest that is not in it.</summary>
    private const int LowestFree = 0x484C484;

    public MinkowskiVertex A, B, C;

    /// <summary>How many of the three are in use.</summary>
    public int Count;

    /// <summary>Of a face: 1 where (B - A) × (C - A) points away from the origin, else -1.</summary>
    public double Winding;

    /// <summary>Makes an empty feature. Fields are set one by one, so that all of them can live in registers.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Make(out FeatureVertices vertices)
    {
        vertices.A.X = vertices.A.Y = vertices.A.Z = 0;
        vertices.B.X = vertices.B.Y = vertices.B.Z = 0;
        vertices.C.X = vertices.C.Y = vertices.C.Z = 0;
        vertices.A.Slot = vertices.B.Slot = vertices.C.Slot = 0;
        vertices.Count = 0;
        vertices.Winding = 1;
    }

    /// <summary>Winds a face the other way, so that it points away from the origin.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Flip()
    {
        (B, C) = (C, B);
        Winding = -Winding;
    }

    /// <summary>A slot that none of the three holds.</summary>
    public readonly int FreeSlot
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get
        {
            int used = (1 << (int)A.Slot) | (1 << (int)B.Slot) | (1 << (int)C.Slot);
            return (LowestFree >> (2 * used)) & 3;
        }
    }
}

/// <summary>A vertex of A - B, and the slot of the <see cref="Simplex"/> that holds the support points that it was made
/// from.</summary>
[method: MethodImpl(MethodImplOptions.AggressiveInlining)]
internal struct MinkowskiVertex(in Double3 w, int slot)
{
    public double X = w.X, Y = w.Y, Z = w.Z;

    /// <summary>As wide as the coordinates, so that the four fit registers without a gap.</summary>
    public long Slot = slot;

    public readonly Double3 W
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => new(X, Y, Z);
    }

    /// <summary>Copies another vertex field by field: the fields stay in registers, and a copy of the struct would
    /// not.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Set(in MinkowskiVertex other)
    {
        X = other.X;
        Y = other.Y;
        Z = other.Z;
        Slot = other.Slot;
    }
}

/// <summary>The vertex, edge or face of a simplex that is nearest the origin, as the plane through it that is
/// perpendicular to the way there. A feature's distance is Height / |Normal|; nothing is divided or
/// normalised.</summary>
internal struct ClosestFeature
{
    /// <summary>From the origin towards the feature and perpendicular to it, of any length.</summary>
    public Double3 Normal;

    /// <summary>Normal · x for every x of the feature: at least 0.</summary>
    public double Height;

    /// <summary>|Normal|².</summary>
    public double NormalSquared;

    /// <summary>The squared distance of the feature from the origin.</summary>
    public readonly double DistanceSquared
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => Height * Height / NormalSquared;
    }
}

/// <summary>A plane n·x = value that has the whole Minkowski difference on its far side, as a support point proves:
/// value / |n| is a lower bound of the distance of the cores.</summary>
internal struct SupportPlane
{
    /// <summary>From the origin to the plane, of any length.</summary>
    public Double3 Normal;

    /// <summary>|Normal|²; 0 where no plane is known.</summary>
    public double NormalSquared;

    /// <summary>Normal · x on the plane.</summary>
    public double Value;

    /// <summary>The plane across a feature's normal.</summary>
    public void Set(in ClosestFeature feature, double value)
    {
        Value = value;
        Double3.Write(feature.Normal.X, feature.Normal.Y, feature.Normal.Z, out Normal);
        NormalSquared = feature.NormalSquared;
    }

    /// <summary>The plane's distance from the origin, negative where the origin is beyond it.</summary>
    public readonly double Distance => Value / Math.Sqrt(NormalSquared);
}
