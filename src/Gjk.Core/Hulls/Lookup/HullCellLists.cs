namespace Gjk.Core;

/// <summary>Makes the lists of <see cref="HullCells"/>: for each cell of the direction cube the vertices that can be
/// furthest in its directions.</summary>
/// <remarks>
/// <para>The lists are made from the top down. A face of the cube starts with all vertices. All rectangles are cut in
/// two again and again until they are cells. The list of a rectangle is that of the one it was cut from, less the
/// vertices that are beaten everywhere in it.</para>
/// <para>Why no list can lack the vertex that the scan finds: a vertex p is dropped only if in every direction of the
/// rectangle some other vertex q is higher than p by more than a slack, which exceeds the rounding of two dot products.
/// So in every such direction the computed dot product of some q is larger than that of p, and p is not what the scan
/// finds. This does not depend on which q are tried or on what else was dropped. Nothing is assumed about edges or
/// neighbours.</para>
/// <para>"Everywhere" is decided in two ways. The height of q above p is a linear function of u and v. Its least value
/// on a rectangle is that at the centre less what it changes along half of each side. If that exceeds the slack for one
/// q, p goes. In the end, when lists are short, the rectangle is clipped by the half planes in which each q is not
/// higher. If nothing is left, p goes. All is measured in stretched units: the largest component of a direction is 1,
/// and no coordinate exceeds 4.</para>
/// <para>A vertex whose cone of directions is long and thin, as on the rim of a prism, is in many lists. When the lists
/// of a cut would take too much memory, the rectangles stay as they are, and their cells share a list.</para>
/// </remarks>
internal sealed class HullCellLists
{
    /// <summary>Count: a longer list is not stored; searching the tree takes no longer. Measured by the SupportAlone
    /// benchmark.</summary>
    private const int LongestList = 512;

    /// <summary>Count: up to this many candidates are clipped by each other; the cost is quadratic.</summary>
    private const int LongestClipped = 48;

    /// <summary>Count: a list of so many vertices need not become shorter, because a block holds no fewer.</summary>
    private const int ShortList = HullCells.Lanes;

    /// <summary>Count: entries in all lists per vertex.</summary>
    private const int MaxEntriesPerVertex = 24;

    private const int Samples = CellFilter.Samples;

    private readonly int _count;
    private readonly double[] _points;
    private readonly Double3 _stretch;
    private CellGrid _grid;
    private List<CellRect> _rects = [];
    private int[] _lists = [], _samples = [], _listOf = [0];

    /// <param name="hull">Its coordinates are read.</param>
    /// <param name="stretch">What directions are stretched by; along an axis where it is 0 nothing counts.</param>
    public HullCellLists(HullVertices hull, in Double3 stretch)
    {
        _count = hull.Count;
        _stretch = stretch;
        _points = new double[3 * _count];
        for (int i = 0; i < _count; i++)
        {
            if (stretch.X > 0) _points[3 * i] = hull.X[i] / stretch.X;
            if (stretch.Y > 0) _points[3 * i + 1] = hull.Y[i] / stretch.Y;
            if (stretch.Z > 0) _points[3 * i + 2] = hull.Z[i] / stretch.Z;
        }
    }

    /// <summary>How many cells there are. Cells can share a list.</summary>
    public int CellCount => _listOf.Length;

    /// <summary>How many lists there are.</summary>
    public int Count => _rects.Count;

    /// <summary>Whether some list is left empty because it would be long.</summary>
    public bool HasLongLists { get; private set; }

    /// <summary>An entry of a list; entries ascend.</summary>
    public int this[int list, int index] => _lists[_rects[list].From + index];

    /// <summary>The list of a cell.</summary>
    public int ListOf(int cell) => _listOf[cell];

    /// <summary>How many entries a list has; 0 if it would be long.</summary>
    public int Length(int list) => _rects[list].Count;

    /// <summary>A vertex that is furthest in a direction of the list's cells, or near them.</summary>
    public int Champion(int list) => _samples[list * Samples + Samples / 2];

    /// <summary>One list of all vertices.</summary>
    public void CollectAll()
    {
        _lists = new int[_count];
        for (int i = 0; i < _count; i++) _lists[i] = i;
        _rects.Add(new CellRect(0, 0, 1, 0, 1).WithList(0, _count));
    }

    /// <summary>The lists of 6 side² cells.</summary>
    public void CollectCube(int side) => Collect(new CellGrid(side));

    /// <summary>For a flat hull the lists of 4 side cells.</summary>
    public void CollectSquare(int side) => Collect(new CellGrid(side, _stretch.X == 0 ? 0 : _stretch.Y == 0 ? 1 : 2));

    private void Collect(in CellGrid grid)
    {
        _grid = grid;
        var filter = new CellFilter(_points, grid);
        Begin(filter);
        while (TryCut(filter))
        {
        }

        _listOf = new int[grid.Cells];
        for (int i = 0; i < _rects.Count; i++) Finish(filter, i);
    }

    /// <summary>Each face is a rectangle.</summary>
    private void Begin(CellFilter filter)
    {
        int[] all = new int[_count];
        for (int i = 0; i < _count; i++) all[i] = i;
        _lists = new int[_grid.Faces * _count];
        _samples = new int[_grid.Faces * Samples];
        int used = 0;
        for (int face = 0; face < _grid.Faces; face++)
        {
            var rect = new CellRect(face, 0, _grid.Columns, 0, _grid.Rows);
            filter.Aim(rect);
            int at = face * Samples;
            for (int row = 0; row < 3; row++) filter.FindChampions(3 * row, 1, all, 0, _count, _samples, at);
            int kept = filter.Copy(_samples, at, all, 0, _count, _lists, used);
            _rects.Add(rect.WithList(used, kept));
            used += kept;
        }
    }

    /// <summary>Cuts all rectangles in two. False when none can be cut, or when the lists would take too much
    /// memory.</summary>
    private bool TryCut(CellFilter filter)
    {
        int most = MaxEntriesPerVertex * _count, used = 0;
        bool isCut = false;
        var rects = new List<CellRect>(2 * _rects.Count);
        int[] lists = new int[_lists.Length], samples = new int[2 * _samples.Length];
        for (int i = 0; i < _rects.Count; i++)
        {
            CellRect rect = _rects[i];
            if (used + 2 * rect.Count > lists.Length) Array.Resize(ref lists, 2 * (used + 2 * rect.Count));
            if (IsHopeless(rect)) rect = rect.WithList(0, 0);
            if (rect.Cells == 1 || rect.Count <= ShortList)
            {
                Array.Copy(_lists, rect.From, lists, used, rect.Count);
                Array.Copy(_samples, i * Samples, samples, rects.Count * Samples, Samples);
                rects.Add(rect.WithList(used, rect.Count));
                used += rect.Count;
                continue;
            }

            isCut = true;
            for (int half = 0; half < 2; half++)
            {
                CellRect child = half == 0 ? rect.LowerHalf() : rect.UpperHalf();
                filter.Aim(child);
                InheritSamples(filter, rect, i * Samples, half, samples, rects.Count * Samples);
                int kept = filter.Copy(samples, rects.Count * Samples, _lists, rect.From, rect.Count, lists, used);
                rects.Add(child.WithList(used, kept));
                used += kept;
            }

            if (used > most) return false;
        }

        (_rects, _lists, _samples) = (rects, lists, samples);
        return isCut;
    }

    /// <summary>Whether the lists of a rectangle's cells will be too long: if each vertex is in one cell only, and if
    /// each crosses the part in a line. Cutting on would be in vain.</summary>
    private static bool IsHopeless(in CellRect rect) =>
        rect.Count > LongestList / 2 * rect.Cells
        && (double)rect.Count * rect.Count > 4.0 * LongestList * LongestList * rect.Cells;

    /// <summary>The champions at six of a half's nine points are known from the whole; those at the three in the middle
    /// are searched for.</summary>
    private void InheritSamples(CellFilter filter, in CellRect rect, int at, int half, int[] samples, int to)
    {
        bool byColumns = rect.Columns >= rect.Rows;
        int across = byColumns ? 1 : 3, along = byColumns ? 3 : 1;
        for (int k = 0; k < 3; k++)
        {
            samples[to + k * along] = _samples[at + k * along + half * across];
            samples[to + k * along + 2 * across] = _samples[at + k * along + (half + 1) * across];
        }

        filter.FindChampions(across, along, _lists, rect.From, rect.Count, samples, to);
    }

    /// <summary>Shortens a list for the last time, drops it if it is long, and gives it to the cells.</summary>
    private void Finish(CellFilter filter, int list)
    {
        CellRect rect = _rects[list];
        int kept = rect.Count;
        if (kept > ShortList && kept <= LongestClipped)
        {
            filter.Aim(rect);
            kept = filter.Clip(_samples, list * Samples, _lists, rect.From, kept);
        }

        if (kept > LongestList) kept = 0;
        HasLongLists |= kept == 0;
        _rects[list] = rect.WithList(rect.From, kept);
        for (int row = rect.Row; row < rect.EndRow; row++)
        {
            for (int column = rect.Column; column < rect.EndColumn; column++)
                _listOf[_grid.Cell(rect.Face, row, column)] = list;
        }
    }
}
