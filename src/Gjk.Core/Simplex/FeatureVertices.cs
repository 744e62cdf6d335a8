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

    /// <summary>No vertices yet. Number by number, so that all of them can live in registers.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Begin(out FeatureVertices vertices)
    {
        vertices.A = new MinkowskiVertex(default, 0);
        vertices.B = new MinkowskiVertex(default, 0);
        vertices.C = new MinkowskiVertex(default, 0);
        vertices.Count = 0;
        vertices.Winding = 1;
    }

    /// <summary>Winds a face the other way, so that it points away from the origin.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void TurnOver()
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
