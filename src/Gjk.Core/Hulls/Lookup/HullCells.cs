namespace Gjk.Core;

/// <summary>Which vertices can be furthest in a direction: a map from directions to short lists of candidates, made
/// once per hull.</summary>
/// <remarks>
/// <para>The sphere of directions is drawn on the faces of a cube. Each face is cut into Side × Side cells. Each cell
/// has a list of the vertices that can be furthest in one of its directions (<see cref="HullCellLists"/> says how it is
/// made and why nothing is missed). A support is one look-up and a few dot products, whatever the hull's size. A cube
/// map of start vertices for hill climbing is known from PhysX; here nothing is left to climb.</para>
/// <para>Directions are first stretched by the hull's extents, so that a needle is treated as a round hull. The lists
/// are stored as blocks of four vertices with coordinates and ids. Ids ascend in a list, and the last block is filled
/// up with copies of the list's first vertex. Where the list would be long, because a flat face has many corners there,
/// the cell has none, and <see cref="Tree"/> is searched. The directions of a flat hull form a circle, which is drawn
/// on the sides of a square. A hull that gains nothing by cells has a single list, of all vertices.</para>
/// </remarks>
internal sealed class HullCells
{
    /// <summary>Vertices per block: the lanes of a 256-bit register of doubles.</summary>
    public const int Lanes = 4;

    /// <summary>Floats per block: x, y, z of four vertices.</summary>
    public const int BlockFloats = 3 * Lanes;

    /// <summary>Count: up to this many vertices a scan of all of them is no slower than finding the cell. Measured by
    /// the SupportAlone benchmark.</summary>
#if NET
    private const int ScanLimit = HullScan.MostVertices;
#else
    private const int ScanLimit = 12;
#endif

    /// <summary>Count: cells along an edge of the cube; 6 · 64² cells hold the lists of 10^5 vertices with some ten
    /// candidates each.</summary>
    private const int MaxSide = 64;

    /// <summary>Count: vertices per cell of a flat hull.</summary>
    private const int FlatVerticesPerCell = 2;

    /// <summary>How a support is found: what the look-up asks first, kept beside the arrays so that a small hull's are
    /// not touched in vain.</summary>
    public readonly LookupKind Kind;

    /// <summary>The blocks of a hull that is scanned as a whole.</summary>
    public readonly int BlockCount;

    /// <summary>Cells along an edge of the cube or square; 0 when there is a single list.</summary>
    public readonly int Side;

    /// <summary>Half of <see cref="Side"/>.</summary>
    public readonly double HalfSide;

    /// <summary>The empty cell of directions that have none.</summary>
    public readonly int NoCell;

    /// <summary>What a direction is stretched by, along each axis: half the hull's extents.</summary>
    public readonly Double3 Stretch;

    /// <summary>The corners that the lists are of.</summary>
    public readonly HullVertices Vertices;

    /// <summary>Prepares directions.</summary>
    public readonly HullDirection Direction;

    /// <summary>The ids of the corners of a hull that is a box; others have none.</summary>
    public readonly BoxCorners Corners;

    /// <summary>The blocks of cell i are those from Runs[2 i] up to, not including, Runs[2 i + 1]. Cells can share
    /// blocks. Where both numbers are the same, the cell has no list, and they are the slot where a search of the tree
    /// starts. The blocks of the tree's leaves come after all others.</summary>
    public readonly int[] Runs;

    /// <summary>Per block x of four vertices, then y, then z, counted from the hull's origin.</summary>
    public readonly float[] Coordinates;

    /// <summary>The same in the hull's own frame: what a support gives out. The same array where the hull's origin is
    /// 0.</summary>
    public readonly float[] Points;

#if NET
    /// <summary>What <see cref="HullScan"/> reads; empty where it is not used.</summary>
    public readonly double[] ScanBlocks;
#endif

    /// <summary>Per block the ids of its four vertices.</summary>
    public readonly int[] Ids;

    /// <summary>A slot with vertex 0, which is furthest where all are level.</summary>
    public readonly int FirstSlot;

    /// <summary>Finds the furthest vertex where a cell has no list; null when all have one.</summary>
    public readonly HullTree? Tree;

    public HullCells(HullVertices hull)
    {
        Vertices = hull;
        Direction = new HullDirection(hull);
        Stretch = Direction.Stretch;
        var lists = new HullCellLists(hull, Direction.Stretch);
        if (hull.Count <= ScanLimit) lists.CollectAll();
        else if (Direction.IsPlanar) lists.CollectSquare(Side = hull.Count / (4 * FlatVerticesPerCell));
        else lists.CollectCube(Side = Math.Min(MaxSide, (int)Math.Ceiling(Math.Sqrt(hull.Count / 6.0))));

        HalfSide = 0.5 * Side;
        NoCell = lists.CellCount;
        Runs = new int[2 * NoCell + 2];
        int[] starts = LayOut(lists);
        int blocks = starts[lists.Count];
        HullTreeBuilder? tree = lists.HasLongLists ? new HullTreeBuilder(hull, Stretch, blocks) : null;
        Ids = new int[(blocks + (tree is null ? 0 : (hull.Count + Lanes - 1) / Lanes)) * Lanes];
        for (int list = 0; list < lists.Count; list++) Fill(lists, list, starts);
        if (tree is not null)
        {
            Tree = new HullTree(tree.Nodes, tree.Inverse);
            AppendTree(lists, tree, blocks * Lanes);
        }

        Coordinates = Gather(hull, default);
        Points = hull.Origin == default ? Coordinates : Gather(hull, hull.Origin);
        FirstSlot = Array.IndexOf(Ids, 0);
        bool isBox = BoxCorners.TryFind(hull, out Corners);
        BlockCount = Runs[1];
        Kind = isBox ? LookupKind.Box
            : !Direction.IsSpatial ? LookupKind.Flat
            : Side > 0 ? LookupKind.Cells : LookupKind.Scan;
#if NET
        ScanBlocks = Kind == LookupKind.Scan ? HullScan.Widen(Coordinates) : [];
#endif
    }

    public enum LookupKind
    {
        /// <summary>All vertices are scanned; a vertex's slot is its id.</summary>
        Scan,

        /// <summary>The signs of the direction name the vertex.</summary>
        Box,

        /// <summary>The vertices of the direction's cell are scanned.</summary>
        Cells,

        /// <summary>As Scan or Cells, but for a hull without extent in some direction: the direction must be prepared
        /// first.</summary>
        Flat,
    }

    /// <summary>Gives each list its blocks and each cell its list; returns the first block of each list and the
    /// end.</summary>
    private int[] LayOut(HullCellLists lists)
    {
        int[] starts = new int[lists.Count + 1];
        for (int i = 0; i < lists.Count; i++) starts[i + 1] = starts[i] + (lists.Length(i) + Lanes - 1) / Lanes;
        for (int cell = 0; cell < NoCell; cell++)
        {
            Runs[2 * cell] = starts[lists.ListOf(cell)];
            Runs[2 * cell + 1] = starts[lists.ListOf(cell) + 1];
        }

        return starts;
    }

    private void Fill(HullCellLists lists, int list, int[] starts)
    {
        int length = lists.Length(list), first = starts[list] * Lanes, padded = starts[list + 1] * Lanes - first;
        for (int k = 0; k < padded; k++) Ids[first + k] = lists[list, k < length ? k : 0];
    }

    /// <summary>Adds the vertices in the order of the tree's leaves. The run of a cell without a list gets the slot
    /// where its searches start.</summary>
    private void AppendTree(HullCellLists lists, HullTreeBuilder tree, int first)
    {
        int count = tree.Order.Length;
        int[] slots = new int[count];
        for (int slot = first; slot < Ids.Length; slot++)
        {
            int place = slot - first;
            Ids[slot] = tree.Order[place < count ? place : place / Lanes * Lanes];
            if (place < count) slots[Ids[slot]] = slot;
        }

        for (int cell = 0; cell < NoCell; cell++)
        {
            int list = lists.ListOf(cell);
            if (lists.Length(list) == 0) Runs[2 * cell] = Runs[2 * cell + 1] = slots[lists.Champion(list)];
        }
    }

    private float[] Gather(HullVertices hull, Vector3 origin)
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
