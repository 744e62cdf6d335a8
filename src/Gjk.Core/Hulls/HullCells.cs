using System;
using System.Collections.Generic;
using System.Numerics;

namespace Gjk.Core;

/// <summary>
/// Which vertices can be furthest in a direction: a map from directions to short lists of candidates, made once per hull.
/// </summary>
/// <remarks>
/// The sphere of directions is drawn on the faces of a cube. Each face is cut into Side × Side cells, and each cell has a
/// list of the vertices that can be furthest in one of its directions (<see cref="HullCellLists"/> says how it is made and
/// why nothing is missed). A support is one look-up and a few dot products, whatever the hull's size. A cube map of start
/// vertices for hill climbing is known from PhysX; here nothing is left to climb.
/// Directions are first stretched by the hull's extents, so that a needle is treated as a round hull.
/// The lists are stored as blocks of four vertices with coordinates and ids. Ids ascend in a list, and the last block is
/// filled up with copies of the list's first vertex. Where the list would be long, because a flat face has many corners
/// there, the cell has none, and <see cref="Tree"/> is searched. The directions of a flat hull form a circle, which is drawn
/// on the sides of a square. A hull that gains nothing by cells has a single list, of all vertices.
/// </remarks>
internal sealed class HullCells
{
    /// <summary>Vertices per block: the lanes of a 256-bit register of doubles.</summary>
    public const int Lanes = 4;

    /// <summary>Floats per block: x, y, z of four vertices.</summary>
    public const int BlockFloats = 3 * Lanes;

    /// <summary>Count: up to this many vertices a scan of all of them is no slower than finding the cell. Measured by the SupportAlone benchmark.</summary>
#if NET
    private const int ScanLimit = 24;
#else
    private const int ScanLimit = 12;
#endif

    /// <summary>Count: cells along an edge of the cube; 6 · 64² cells hold the lists of 10^5 vertices with some ten candidates each.</summary>
    private const int MaxSide = 64;

    /// <summary>Count: vertices per cell of a flat hull.</summary>
    private const int FlatVerticesPerCell = 2;

    /// <summary>
    /// Relative. The dot products of two corners that differ along an axis i differ by 2 |d_i| h_i or more. Each is rounded by less than
    /// 12 u times the sum of all |d_j| h_j: three products of at most 4 |d_j| h_j and two sums, u = 2^-53. So a sign decides where
    /// |d_i| h_i exceeds 12 u times that sum; this is 16 u. Pinned by BoxTieTests.
    /// </summary>
    private const double Tie = 1.0 / (1L << 49);

    /// <summary>How a support is found: what the look-up asks first, kept beside the arrays so that a small hull's are not touched in vain.</summary>
    public readonly SupportKind Kind;

    /// <summary>The blocks of a hull that is scanned as a whole.</summary>
    public readonly int BlockCount;

    /// <summary>Cells along an edge of the cube or square; 0 when there is a single list.</summary>
    public readonly int Side;

    /// <summary>Half of <see cref="Side"/>.</summary>
    public readonly double HalfSide;

    /// <summary>The empty cell of directions that have none.</summary>
    public readonly int NoCell;

    /// <summary>What a direction is stretched by, along each axis: half the hull's extents.</summary>
    public readonly Vector3D Stretch;

    /// <summary>Prepares directions.</summary>
    public readonly HullDirection Direction;

    /// <summary>
    /// For a hull whose vertices are the eight corners of its bounds, the slot of each by the signs of the direction (bit 0, 1, 2 set where x, y, z is negative);
    /// empty for any other. Boxes are the commonest mesh, and their support needs no dot product.
    /// </summary>
    public readonly byte[] BoxSlots;

    /// <summary>
    /// The part of the direction's components, added up, that each of them must exceed, so that its sign decides between a box's corners.
    /// </summary>
    public readonly double BoxTie;

    /// <summary>
    /// The blocks of cell i are those from Runs[2 i] up to, not including, Runs[2 i + 1]. Where there are none the tree is asked, whose blocks come
    /// after all others. Cells can share blocks.
    /// </summary>
    public readonly int[] Runs;

    /// <summary>Per block x of four vertices, then y, then z, counted from the hull's origin.</summary>
    public readonly float[] Coordinates;

    /// <summary>The same in the hull's own frame: what a support gives out. The same array where the hull's origin is 0.</summary>
    public readonly float[] Points;

    /// <summary>Per block the ids of its four vertices.</summary>
    public readonly int[] Ids;

    /// <summary>A slot with vertex 0, which is furthest where all are level.</summary>
    public readonly int FirstSlot;

    /// <summary>Finds the furthest vertex where a cell has no list; null when all have one.</summary>
    public readonly HullTree? Tree;

    public HullCells(ConvexHull hull)
    {
        Direction = new HullDirection(hull);
        Stretch = Direction.Stretch;
        var lists = new HullCellLists(hull, Direction.Stretch);
        if (hull.VertexCount <= ScanLimit) lists.CollectAll();
        else if (Direction.IsPlanar) lists.CollectSquare(Side = hull.VertexCount / (4 * FlatVerticesPerCell));
        else lists.CollectCube(Side = Math.Min(MaxSide, (int)Math.Ceiling(Math.Sqrt(hull.VertexCount / 6.0))));

        HalfSide = 0.5 * Side;
        NoCell = lists.CellCount;
        Runs = new int[2 * NoCell + 2];
        int blocks = SetRuns(lists);
        HullTreeBuilder? tree = lists.HasLongLists ? new HullTreeBuilder(hull, Stretch, blocks) : null;
        Tree = tree is null ? null : new HullTree(tree.Nodes, Stretch);
        Ids = new int[(blocks + (tree is null ? 0 : (hull.VertexCount + Lanes - 1) / Lanes)) * Lanes];
        for (int cell = 0; cell < NoCell; cell++) Fill(lists, cell);
        for (int slot = blocks * Lanes; slot < Ids.Length; slot++)
        {
            int place = slot - blocks * Lanes;
            Ids[slot] = tree!.Order[place < hull.VertexCount ? place : place / Lanes * Lanes];
        }

        Coordinates = Gather(hull, default);
        Points = hull.Origin == default ? Coordinates : Gather(hull, hull.Origin);
        FirstSlot = Array.IndexOf(Ids, 0);
        BoxSlots = FindBoxSlots(hull);
        BoxTie = Tie * Math.Max(Math.Max(Stretch.X, Stretch.Y), Stretch.Z) / Math.Min(Math.Min(Stretch.X, Stretch.Y), Stretch.Z);
        BlockCount = Runs[1];
        Kind = BoxSlots.Length > 0 ? SupportKind.Box
            : !Direction.IsSpatial ? SupportKind.Flat
            : Side > 0 ? SupportKind.Cells : SupportKind.Scan;
    }

    public enum SupportKind
    {
        /// <summary>All vertices are scanned; a vertex's slot is its id.</summary>
        Scan,

        /// <summary>The signs of the direction name the vertex.</summary>
        Box,

        /// <summary>The vertices of the direction's cell are scanned.</summary>
        Cells,

        /// <summary>As Scan or Cells, but for a hull without extent in some direction: the direction must be prepared first.</summary>
        Flat,
    }

    private static byte[] FindBoxSlots(ConvexHull hull)
    {
        if (hull.VertexCount != 8 || hull.Dimension != 3) return [];
        Vector3 min = hull.Bounds.Min, max = hull.Bounds.Max;
        var slots = new byte[8];
        int found = 0;
        for (int id = 0; id < 8; id++)
        {
            Vector3 p = hull.GetVertex(id);
            if ((p.X != min.X && p.X != max.X) || (p.Y != min.Y && p.Y != max.Y) || (p.Z != min.Z && p.Z != max.Z)) return [];
            int signs = (p.X == min.X ? 1 : 0) | (p.Y == min.Y ? 2 : 0) | (p.Z == min.Z ? 4 : 0);
            slots[signs] = (byte)id;
            found |= 1 << signs;
        }

        return found == 0xFF ? slots : [];
    }

    /// <summary>Lays out the lists, each once; gives the number of blocks.</summary>
    private int SetRuns(HullCellLists lists)
    {
        int blocks = 0;
        var first = new Dictionary<int, int>();
        for (int cell = 0; cell < NoCell; cell++)
        {
            int length = (lists.Length(cell) + Lanes - 1) / Lanes;
            if (!first.TryGetValue(lists.Begin(cell), out int start) || length == 0)
            {
                start = blocks;
                blocks += length;
                first[lists.Begin(cell)] = start;
            }

            Runs[2 * cell] = start;
            Runs[2 * cell + 1] = start + length;
        }

        return blocks;
    }

    private void Fill(HullCellLists lists, int cell)
    {
        int first = Runs[2 * cell] * Lanes, length = lists.Length(cell), padded = Runs[2 * cell + 1] * Lanes - first;
        for (int k = 0; k < padded; k++) Ids[first + k] = lists[cell, k < length ? k : 0];
    }

    private float[] Gather(ConvexHull hull, Vector3 origin)
    {
        float[] coordinates = new float[Ids.Length / Lanes * BlockFloats];
        for (int slot = 0; slot < Ids.Length; slot++)
        {
            int id = Ids[slot], at = slot / Lanes * BlockFloats + slot % Lanes;
            coordinates[at] = hull.X[id] + origin.X;
            coordinates[at + Lanes] = hull.Y[id] + origin.Y;
            coordinates[at + 2 * Lanes] = hull.Z[id] + origin.Z;
        }

        return coordinates;
    }
}
