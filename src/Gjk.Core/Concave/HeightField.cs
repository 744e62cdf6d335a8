namespace Gjk.Core;

/// <summary>The grid of a mesh that <see cref="TriangleMesh.FromHeights"/> has made: its cells, by which a user's
/// material or tag of a part is found, its heights, and how they are changed.</summary>
/// <remarks>Cells are numbered row by row: cell i is at column i % (<see cref="Columns"/> - 1) and row i /
/// (<see cref="Columns"/> - 1), and reaches to the next ones. Lengths and heights are in the mesh's frame, before its
/// scale. Reading is thread-safe; <see cref="SetHeights"/> is not.</remarks>
public sealed class HeightField
{
    private readonly TriangleMesh _mesh;
    private readonly RegionRefit _refit;

    internal HeightField(TriangleMesh mesh, HeightGrid grid)
    {
        (_mesh, Grid) = (mesh, grid);
        _refit = new RegionRefit(mesh, mesh.Tree);
    }

    internal HeightGrid Grid { get; }

    /// <summary>How many heights a row has, at least 2; cells are one fewer.</summary>
    public int Columns => Grid.Columns;

    /// <summary>How many rows of heights there are, at least 2; rows of cells are one fewer.</summary>
    public int Rows => Grid.Rows;

    /// <summary>How many cells there are, holes included.</summary>
    public int CellCount => Grid.CellCount;

    /// <summary>The size of a cell: between columns, and between rows.</summary>
    public Vector2 Spacing => Grid.Spacing;

    /// <summary>Whether heights are z and rows go along y; else heights are y and rows go along z.</summary>
    public bool IsZUp => Grid.IsZUp;

    /// <summary>The height of the bottom; null where there is none.</summary>
    public float? BaseHeight => Grid.BaseHeight;

    /// <summary>The height of a vertex.</summary>
    /// <param name="column">From 0 to <see cref="Columns"/> - 1.</param>
    /// <param name="row">From 0 to <see cref="Rows"/> - 1.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such column or row.</exception>
    public float GetHeight(int column, int row)
    {
        Vector3 vertex = _mesh.GetVertex(VertexAt(column, row));
        return IsZUp ? vertex.Z : vertex.Y;
    }

    /// <summary>The cell of a triangle, such as the part of a hit: on top, at the bottom, or the wall of a
    /// cell.</summary>
    /// <param name="triangle">From 0 to <see cref="TriangleMesh.TriangleCount"/> - 1.</param>
    /// <returns>The cell. Its first triangle has an even number and its second one the next, so that a tag of each
    /// is found by 2 · cell + triangle % 2.</returns>
    /// <exception cref="ArgumentOutOfRangeException">There is no such triangle.</exception>
    public int CellOf(int triangle) =>
        Grid.CellOf(Guard.Index(triangle, _mesh.TriangleCount, nameof(triangle), "triangle"));

    /// <summary>The triangles of a cell, on top.</summary>
    /// <param name="cell">From 0 to <see cref="CellCount"/> - 1.</param>
    /// <returns>The first of two, the one at the least column and row; -1 where the cell is a hole.</returns>
    /// <exception cref="ArgumentOutOfRangeException">There is no such cell.</exception>
    public int TriangleOf(int cell) => Grid.TriangleOf(Guard.Index(cell, CellCount, nameof(cell), "cell"));

    /// <summary>Changes the heights of a rectangle of vertices, in place. The time is in proportion to the rectangle;
    /// the answers are those of a mesh that was built of all heights anew, but that another one of equally near parts
    /// may be named. Nothing is allocated.</summary>
    /// <remarks>The one change that a mesh knows, as a copy of a large field takes longer than most changes: no query
    /// of the mesh may run meanwhile, on any thread. Each shape that holds the mesh is changed with it, but no scaled
    /// one and no compound, which have copies. Tell each scene that holds it by
    /// <see cref="CollisionScene.Refresh"/>.</remarks>
    /// <param name="column">The first column that is changed.</param>
    /// <param name="row">The first row that is changed.</param>
    /// <param name="columns">How many columns are changed; at least 1.</param>
    /// <param name="heights">Row by row, finite, above the base where there is one; at least one row.</param>
    /// <exception cref="ArgumentNullException">There are no heights.</exception>
    /// <exception cref="ArgumentException">The heights are not whole rows, or more than there are, or one of them is
    /// NaN, infinite or not above the base.</exception>
    /// <exception cref="ArgumentOutOfRangeException">There is no such column or row, or columns reach beyond the
    /// grid.</exception>
    public void SetHeights(int column, int row, int columns, IReadOnlyList<float> heights)
    {
        Guard.NotNull(heights, nameof(heights));
        int first = VertexAt(column, row);
        if (columns < 1 || columns > Columns - column)
            throw new ArgumentOutOfRangeException(nameof(columns), columns, "Must be at least 1 and within the grid.");
        int rows = heights.Count / columns;
        if (rows < 1 || rows > Rows - row || rows * columns != heights.Count)
        {
            throw new ArgumentException(
                $"{heights.Count} heights are no 1 to {Rows - row} rows of {columns}.", nameof(heights));
        }

        for (int i = 0; i < heights.Count; i++)
        {
            if (!Guard.IsFinite(heights[i]) || heights[i] <= BaseHeight)
                throw new ArgumentException($"Height {i} is not finite or not above the base.", nameof(heights));
        }

        PartBox moved = PartBox.Nothing;
        for (int i = 0; i < heights.Count; i++)
        {
            int vertex = first + i / columns * Columns + i % columns;
            _mesh.SetHeight(vertex, heights[i], IsZUp);
            moved.Add(_mesh.GetScaledVertex(vertex));
        }

        // A triangle that has moved holds the column of a vertex that has.
        PartBox region = moved, all = PartBox.Everything;
        if (IsZUp) (region.MinZ, region.MaxZ) = (all.MinZ, all.MaxZ);
        else (region.MinY, region.MaxY) = (all.MinY, all.MaxY);
        if (columns == Columns && rows == Rows) _refit.FitAll();
        else _refit.Fit(region, moved);
    }

    private int VertexAt(int column, int row)
    {
        Guard.Index(column, Columns, nameof(column), "column");
        return Guard.Index(row, Rows, nameof(row), "row") * Columns + column;
    }
}
