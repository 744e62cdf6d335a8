using System;
using System.Numerics;

namespace Gjk.Core;

/// <summary>
/// Which corners can be furthest in a direction: a map from directions to short lists of candidates, made once per hull.
/// </summary>
/// <remarks>
/// The idea: a corner is furthest for the directions of its normal cone, and the cones tile the sphere of directions. That sphere is drawn on the
/// faces of a cube, each cut into Side × Side cells, and every cell lists the corners whose cones reach into it. A support is then one look-up and a few dot products, whatever
/// the hull's size and whatever was asked before, and it is exact: the list holds every corner that is furthest, or within rounding of it, for
/// some direction of the cell. (A cube map of start vertices for hill climbing is known from PhysX; here nothing is left to climb.)
/// Directions are first stretched by the hull's extents, which maps a needle's cones, crowded around its waist, to those of a round hull.
/// Building walks each cell's corners over the hull's edges from one that is furthest at the cell's centre; cones that share a cell are connected. A cone reaches into a cell when the
/// cell, a square of directions (u, v, 1), is not clipped away by the half planes "not below this neighbour". Lists are stored as blocks of four
/// corners with coordinates and ids, ids ascending, the last block filled up with copies of its first corner: that is what a scan reads. A hull that
/// gains nothing by cells has a single list, of all corners.
/// </remarks>
internal sealed class HullCells
{
    /// <summary>Corners per block: the lanes of a 256-bit register of doubles.</summary>
    public const int Lanes = 4;

    /// <summary>Floats per block: x, y, z of four corners.</summary>
    public const int BlockFloats = 3 * Lanes;

    /// <summary>Count: up to this many corners a scan of all of them is no slower than finding the cell. Measured by the SupportAlone benchmark.</summary>
#if NET
    private const int ScanLimit = 24;
#else
    private const int ScanLimit = 12;
#endif

    /// <summary>Count: cells along an edge of the cube; 6 · 64² cells hold the lists of 10^5 corners with some ten candidates each.</summary>
    private const int MaxSide = 64;

    /// <summary>Count: list entries per corner beyond which the cells are made coarser (a prism's sides cross many cells).</summary>
    private const int MaxEntriesPerCorner = 24;

    /// <summary>Cell side: how far each cell is widened, so that rounding in the look-up (1e-15) cannot miss it.</summary>
    private const double Widening = 1e-6;

    /// <summary>Length in units of the extents: corners that lie this little below the best are candidates too, far more than a rounded dot product can be off.</summary>
    private const double Slack = 1e-9;

    /// <summary>How a support is found: what the look-up asks first, kept beside the arrays so that a small hull's are not touched in vain.</summary>
    public readonly SupportKind Kind;

    /// <summary>The blocks of a hull that is scanned as a whole.</summary>
    public readonly int BlockCount;

    /// <summary>Cells along an edge of the cube; 0 when there is a single list.</summary>
    public readonly int Side;

    /// <summary>What a direction is stretched by, along each axis: half the hull's extents.</summary>
    public readonly Vector3D Stretch;

    /// <summary>
    /// For a hull whose corners are the eight of its bounds, the slot of each by the signs of the direction (bit 0, 1, 2 set where x, y, z is negative);
    /// empty for any other. Boxes are the commonest mesh, and their support needs no dot product.
    /// </summary>
    public readonly byte[] BoxSlots;

    /// <summary>The blocks of cell i are those from Start[i] up to, not including, Start[i + 1].</summary>
    public readonly int[] Start;

    /// <summary>Per block x of four corners, then y, then z.</summary>
    public readonly float[] Coordinates;

    /// <summary>Per block the ids of its four corners.</summary>
    public readonly int[] Ids;

    public HullCells(ConvexHull hull)
    {
        Vector3D min = hull.Bounds.Min, max = hull.Bounds.Max;
        Stretch = (max - min) * 0.5;
        int side = hull.VertexCount <= ScanLimit ? 0 : Math.Min(MaxSide, (int)Math.Ceiling(Math.Sqrt(hull.VertexCount / 6.0)));
        var lists = new HullCellLists(hull, Stretch, Widening, Slack);
        while (side > 0 && !lists.TryCollect(side, MaxEntriesPerCorner * hull.VertexCount)) side /= 2;
        if (side == 0) lists.CollectAll();
        Side = side;
        Start = new int[lists.CellCount + 1];
        for (int i = 0; i < lists.CellCount; i++) Start[i + 1] = Start[i] + (lists.Length(i) + Lanes - 1) / Lanes;
        Coordinates = new float[Start[lists.CellCount] * BlockFloats];
        Ids = new int[Start[lists.CellCount] * Lanes];
        for (int i = 0; i < lists.CellCount; i++) Fill(hull, lists, i);
        BoxSlots = FindBoxSlots(hull);
        BlockCount = Start[1];
        Kind = BoxSlots.Length > 0 ? SupportKind.Box : Side > 0 ? SupportKind.Cells : SupportKind.Scan;
    }

    public enum SupportKind
    {
        /// <summary>All corners are scanned; a corner's slot is its id.</summary>
        Scan,

        /// <summary>The signs of the direction name the corner.</summary>
        Box,

        /// <summary>The corners of the direction's cell are scanned.</summary>
        Cells,
    }

    private static byte[] FindBoxSlots(ConvexHull hull)
    {
        if (hull.VertexCount != 8 || hull.Dimension != 3) return [];
        Vector3 min = hull.Bounds.Min, max = hull.Bounds.Max;
        var slots = new byte[8];
        int found = 0;
        for (int id = 0; id < 8; id++)
        {
            float x = hull.X[id], y = hull.Y[id], z = hull.Z[id];
            if ((x != min.X && x != max.X) || (y != min.Y && y != max.Y) || (z != min.Z && z != max.Z)) return [];
            int signs = (x == min.X ? 1 : 0) | (y == min.Y ? 2 : 0) | (z == min.Z ? 4 : 0);
            slots[signs] = (byte)id;
            found |= 1 << signs;
        }

        return found == 0xFF ? slots : [];
    }

    private void Fill(ConvexHull hull, HullCellLists lists, int cell)
    {
        int first = Start[cell] * Lanes, length = lists.Length(cell), padded = (Start[cell + 1] - Start[cell]) * Lanes;
        for (int k = 0; k < padded; k++)
        {
            int id = lists[cell, k < length ? k : 0];
            int slot = first + k, at = slot / Lanes * BlockFloats + slot % Lanes;
            Ids[slot] = id;
            Coordinates[at] = hull.X[id];
            Coordinates[at + Lanes] = hull.Y[id];
            Coordinates[at + 2 * Lanes] = hull.Z[id];
        }
    }
}
