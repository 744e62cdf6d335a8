namespace Gjk.Core;

/// <summary>The grid of a height field, and the triangles of one that has holes or a base. Immutable once these are
/// listed; scaled copies share it.</summary>
internal sealed class HeightGrid(int columns, int rows, Vector2 spacing, bool isZUp, float? baseHeight)
{
    public readonly int Columns = columns, Rows = rows, CellCount = (columns - 1) * (rows - 1);
    public readonly Vector2 Spacing = spacing;
    public readonly bool IsZUp = isZUp;
    public readonly float? BaseHeight = baseHeight;

    /// <summary>The cell of each pair of triangles, those on top first; null where every cell has one pair, in
    /// order.</summary>
    private int[]? _cells;

    /// <summary>How many pairs are on top.</summary>
    private int _tops;

    public int CellOf(int triangle) => _cells is null ? triangle / 2 : _cells[triangle / 2];

    /// <summary>The first triangle on top of a cell, or -1 in a hole.</summary>
    public int TriangleOf(int cell)
    {
        int pair = _cells is null ? cell : Array.BinarySearch(_cells, 0, _tops, cell);
        return pair < 0 ? -1 : 2 * pair;
    }

    /// <summary>Lists the triangles.</summary>
    /// <param name="plain">The grid without holes and base.</param>
    /// <param name="isHole">Which cells are left out; not all.</param>
    /// <param name="points">The vertices of the grid, then those of the bottom.</param>
    /// <param name="corners">Three for each triangle.</param>
    public void ListTriangles(TriangleList plain, bool[] isHole, out Vector3[] points, out int[] corners)
    {
        List<int> triangles = [], cells = [];
        for (int cell = 0; cell < CellCount; cell++)
        {
            if (isHole[cell]) continue;
            for (int side = 6 * cell; side < 6 * cell + 6; side += 3)
            {
                plain.GetVertices(side, out int a, out int b, out int c);
                triangles.AddRange([a, b, c]);
            }

            cells.Add(cell);
        }

        _tops = cells.Count;
        int count = plain.VertexCount;
        points = new Vector3[BaseHeight is null ? count : 2 * count];
        for (int i = 0; i < count; i++) points[i] = plain.Vertex(i);
        if (BaseHeight is { } height)
        {
            for (int i = 0; i < count; i++)
            {
                Vector3 top = points[i];
                points[count + i] = IsZUp ? new Vector3(top.X, top.Y, height) : new Vector3(top.X, height, top.Z);
            }

            AddBottom(triangles, cells, count);
            AddWalls(triangles, cells, count, isHole);
        }

        corners = triangles.ToArray();
        _cells = cells.ToArray();
    }

    private void AddBottom(List<int> triangles, List<int> cells, int below)
    {
        for (int i = 0; i < 6 * _tops; i += 3)
        {
            triangles.AddRange([triangles[i] + below, triangles[i + 2] + below, triangles[i + 1] + below]);
            if (i % 2 == 0) cells.Add(cells[i / 6]);
        }
    }

    /// <summary>Adds two triangles below each side of the top that has no neighbour. The top is on the left of such a
    /// side.</summary>
    private void AddWalls(List<int> triangles, List<int> cells, int below, bool[] isHole)
    {
        for (int i = 0; i < 6 * _tops; i++)
        {
            int from = triangles[i], to = triangles[TriangleList.NextSide(i)];
            if (!IsBorder(cells[i / 6], from, to, isHole)) continue;
            triangles.AddRange([to, from, from + below, to, from + below, to + below]);
            cells.Add(cells[i / 6]);
        }
    }

    /// <summary>Whether a side of a cell's triangles is one of the cell, with nothing beyond it.</summary>
    private bool IsBorder(int cell, int from, int to, bool[] isHole)
    {
        int row = cell / (Columns - 1), column = cell % (Columns - 1);
        if (from / Columns == to / Columns) row += from / Columns == row ? -1 : 1;
        else if (from % Columns == to % Columns) column += from % Columns == column ? -1 : 1;
        else return false;
        bool isInside = row >= 0 && row < Rows - 1 && column >= 0 && column < Columns - 1;
        return !isInside || isHole[row * (Columns - 1) + column];
    }
}
