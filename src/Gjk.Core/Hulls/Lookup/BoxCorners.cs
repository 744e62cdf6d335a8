namespace Gjk.Core;

/// <summary>The ids of a box's corners by their signs (bit 0, 1, 2 set where x, y, z is at its negative end), and the
/// other way round. Boxes are the commonest mesh, and their support needs no dot product: the signs of the direction
/// name the corner.</summary>
/// <remarks>Eight numbers of four bits each, so that a look-up is a shift and touches no memory. Signs decide exactly,
/// where a comparison of rounded dot products would not.</remarks>
[method: MethodImpl(MethodImplOptions.AggressiveInlining)]
internal readonly struct BoxCorners(uint ids, uint signs)
{
    /// <summary>Of a box whose ids are the signs.</summary>
    public static BoxCorners Plain
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => new(0x76543210, 0x76543210);
    }

    private const int Corners = 8, BitsEach = 4, Mask = 7;

    private readonly uint _ids = ids, _signs = signs;

    /// <summary>The id of the corner with these signs.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public int Id(int signs) => (int)(_ids >> (BitsEach * signs)) & Mask;

    /// <summary>The signs of the corner with this id, from 0 to 7.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public int Signs(int id) => (int)(_signs >> (BitsEach * id)) & Mask;

#if NET
    /// <summary>Both tables, for a lane.</summary>
    public ulong Packed => (ulong)_signs << 32 | _ids;

    /// <summary>As <see cref="Id(int)"/>, for lanes of <see cref="Packed"/>.</summary>
    public static Vector256<long> Ids(Vector256<ulong> corners, Vector256<long> signs) =>
        Avx2.ShiftRightLogicalVariable(corners, (signs * BitsEach).AsUInt64()).AsInt64() & Vector256.Create((long)Mask);

    /// <summary>As <see cref="Signs(int)"/>, for lanes of <see cref="Packed"/>; nothing for what is no id.</summary>
    public static Vector256<long> Signs(Vector256<ulong> corners, Vector256<long> ids) =>
        Ids(Vector256.ShiftRightLogical(corners, 32), ids);
#endif

    /// <summary>False when the hull's vertices are not the eight corners of its bounds.</summary>
    public static bool TryFind(HullVertices hull, out BoxCorners corners)
    {
        corners = default;
        if (hull.Count != Corners || hull.Dimension != 3) return false;
        Vector3 min = hull.Bounds.Min, max = hull.Bounds.Max;
        uint ids = 0, signsOf = 0, found = 0;
        for (int id = 0; id < Corners; id++)
        {
            Vector3 p = hull.GetVertex(id);
            bool isCorner = (p.X == min.X || p.X == max.X) && (p.Y == min.Y || p.Y == max.Y)
                && (p.Z == min.Z || p.Z == max.Z);
            if (!isCorner) return false;
            int signs = (p.X == min.X ? 1 : 0) | (p.Y == min.Y ? 2 : 0) | (p.Z == min.Z ? 4 : 0);
            ids |= (uint)id << (BitsEach * signs);
            signsOf |= (uint)signs << (BitsEach * id);
            found |= 1u << signs;
        }

        corners = new BoxCorners(ids, signsOf);
        return found == (1u << Corners) - 1;
    }
}
