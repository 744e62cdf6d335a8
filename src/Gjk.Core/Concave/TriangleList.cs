namespace Gjk.Core;

/// <summary>Vertices and triangles: lists as they were given, or the cells of a grid.</summary>
/// <remarks>A grid has a vertex for each height, row by row: x is the column times the spacing, z (y where z is up) the
/// row times the spacing, both rounded to float. A cell is cut from its corner in the next column to that in the next
/// row. Its triangles are 2 cell, with the corner of the least column and row, and 2 cell + 1; both are
/// counter-clockwise seen from above.</remarks>
internal sealed class TriangleList
{
    private readonly Vector3[] _vertices;
    private readonly int[] _indices;
    private readonly float[]? _heights;
    private readonly int _columns;
    private readonly Vector2 _spacing;
    private readonly bool _isZUp;

    public TriangleList(Vector3[] vertices, int[] indices)
        : this(vertices, indices, indices.Length)
    {
    }

    private TriangleList(Vector3[] vertices, int[] indices, int sides)
    {
        (_vertices, _indices) = (vertices, indices);
        (VertexCount, SideCount) = (vertices.Length, sides);
    }

    /// <summary>The same list with triangles appended that are no parts.</summary>
    public TriangleList WithFill(int[] fill) => new(_vertices, [.. CopyIndices(), .. fill], SideCount);

    public TriangleList(float[] heights, int columns, Vector2 spacing, bool isZUp)
    {
        (_vertices, _indices, _heights, _columns) = ([], [], heights, columns);
        (_spacing, _isZUp) = (spacing, isZUp);
        VertexCount = heights.Length;
        SideCount = 6 * (Rows - 1) * (columns - 1);
    }

    public int VertexCount { get; }

    /// <summary>Three times the number of triangles.</summary>
    public int SideCount { get; }

    /// <summary>Whether it is a grid.</summary>
    public bool IsGrid => _heights is not null;

    private int Rows => VertexCount / _columns;

    public Vector3 Vertex(int index) =>
        _heights is null ? _vertices[index] : Vertex(index, index / _columns, index % _columns);

    /// <summary>The positions of a triangle's corners.</summary>
    /// <param name="side">Three times the triangle.</param>
    /// <param name="a">The first corner.</param>
    /// <param name="b">The second corner.</param>
    /// <param name="c">The third corner.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void GetPositions(int side, out Vector3 a, out Vector3 b, out Vector3 c)
    {
        if (_heights is null)
            (a, b, c) = (_vertices[_indices[side]], _vertices[_indices[side + 1]], _vertices[_indices[side + 2]]);
        else GetGridPositions(side, out a, out b, out c);
    }

    /// <summary>The vertices of a triangle.</summary>
    /// <param name="side">Three times the triangle.</param>
    /// <param name="a">The first vertex.</param>
    /// <param name="b">The second vertex.</param>
    /// <param name="c">The third vertex.</param>
    public void GetVertices(int side, out int a, out int b, out int c)
    {
        if (_heights is null)
        {
            (a, b, c) = (_indices[side], _indices[side + 1], _indices[side + 2]);
            return;
        }

        int cell = side / 6, row = cell / (_columns - 1), at = cell + row;
        (a, b, c) = side == 6 * cell
            ? (at, at + _columns, at + 1)
            : (at + 1, at + _columns, at + _columns + 1);
        if (_isZUp) (b, c) = (c, b);
    }

    /// <summary>The next side of the same triangle: it begins where the side ends.</summary>
    public static int NextSide(int side) => side % 3 == 2 ? side - 2 : side + 1;

    /// <summary>The side of the same triangle that ends where the side begins.</summary>
    public static int PreviousSide(int side) => side % 3 == 0 ? side + 2 : side - 1;

    /// <summary>The vertex at which a side begins.</summary>
    public int VertexOf(int side)
    {
        if (_heights is null) return _indices[side];
        GetVertices(side - side % 3, out int a, out int b, out int c);
        return side % 3 == 0 ? a : side % 3 == 1 ? b : c;
    }

    private void GetGridPositions(int side, out Vector3 a, out Vector3 b, out Vector3 c)
    {
        int cell = side / 6, row = cell / (_columns - 1), at = cell + row, column = at - row * _columns;
        bool isFirst = side == 6 * cell;
        Vector3 right = Vertex(at + 1, row, column + 1), far = Vertex(at + _columns, row + 1, column);
        a = isFirst ? Vertex(at, row, column) : right;
        Vector3 other = isFirst ? right : Vertex(at + _columns + 1, row + 1, column + 1);
        (b, c) = _isZUp ? (other, far) : (far, other);
    }

    private Vector3 Vertex(int index, int row, int column)
    {
        float x = column * _spacing.X, across = row * _spacing.Y, height = _heights![index];
        return _isZUp ? new Vector3(x, across, height) : new Vector3(x, height, across);
    }

    /// <summary>Changes the height of a vertex: along z, or else along y.</summary>
    public void SetHeight(int vertex, float height, bool isZUp)
    {
        if (_heights is not null) _heights[vertex] = height;
        else if (isZUp) _vertices[vertex].Z = height;
        else _vertices[vertex].Y = height;
    }

    /// <summary>A copy with its own vertices.</summary>
    public TriangleList Copy() => _heights is not null
        ? new TriangleList((float[])_heights.Clone(), _columns, _spacing, _isZUp)
        : new TriangleList((Vector3[])_vertices.Clone(), _indices);

    /// <summary>Three vertices of each triangle.</summary>
    public int[] CopyIndices()
    {
        int[] indices = new int[SideCount];
        for (int i = 0; i < SideCount; i += 3)
            GetVertices(i, out indices[i], out indices[i + 1], out indices[i + 2]);
        return indices;
    }

    /// <summary>One of the six sides of a grid that begin at a vertex, or -1 beyond its outline.</summary>
    public int SideInGrid(int vertex, int index)
    {
        // The cell at the vertex, the one before it in the row, and the same two of the row before.
        (int rowsBack, int columnsBack, int side) = index switch
        {
            0 => (0, 0, 0),
            1 => (0, 1, 2),
            2 => (0, 1, 3),
            3 => (1, 0, 1),
            4 => (1, 0, 4),
            _ => (1, 1, 5),
        };
        int row = vertex / _columns, column = vertex - row * _columns - columnsBack, across = _columns - 1;
        row -= rowsBack;
        if (_isZUp && side % 3 != 0) side += side % 3 == 1 ? 1 : -1;
        bool isInside = row >= 0 && row < Rows - 1 && column >= 0 && column < across;
        return isInside ? 6 * (row * across + column) + side : -1;
    }
}

/// <summary>Enumerates the sides of a mesh's triangles that begin at one place.</summary>
internal ref struct CornerRing(TriangleList list, int[] around, int side)
{
    private readonly int _first = list.IsGrid ? list.VertexOf(side) : side;
    private int _step;

    /// <summary>A side: three times its triangle, plus the number of the corner.</summary>
    public int Current { get; private set; } = -1;

    public bool MoveNext()
    {
        if (!list.IsGrid)
        {
            Current = Current < 0 ? _first : around[Current];
            return _step++ == 0 || Current != _first;
        }

        while (_step < 6)
        {
            Current = list.SideInGrid(_first, _step++);
            if (Current >= 0) return true;
        }

        return false;
    }
}
