namespace Gjk.Core;

public sealed partial class TriangleMesh
{
    /// <summary>Count: between more lines of a grid there may be no float.</summary>
    private const int MostLines = 1 << 22;

    /// <summary>A height field: a surface over the cells of a grid, with holes and with a base where they are given.
    /// Without them it keeps the heights alone and no list of triangles.</summary>
    /// <param name="heights">Row by row, all finite: vertex i is at x = (i % columns) · spacing.X, y = heights[i], z =
    /// (i / columns) · spacing.Y, x and z rounded to float. Copied.</param>
    /// <param name="columns">How many heights a row has; at least 2, and there are at least 2 whole rows.</param>
    /// <param name="spacing">Between columns, along x, and between rows, along z; positive.</param>
    /// <param name="isHole">Which cells are left out, or null; row by row, columns - 1 in a row. Copied.</param>
    /// <param name="isZUp">Whether heights are z, and rows go along y.</param>
    /// <param name="baseHeight">Below all heights: the mesh is closed by walls and by a bottom at that height, so that
    /// <see cref="AnyShape.Solid"/> takes it. Null: a surface that is open.</param>
    /// <param name="workers">The threads to use; null for the caller's own. The mesh is the same.</param>
    /// <returns>A mesh with two triangles for each cell that is no hole, row by row, cut from the cell's corner in the
    /// next column to that in the next row; the first is the one at the least column and row. They look up.
    /// <see cref="HeightField"/> tells the cell of a triangle. With a base the bottom has as many, in the same order,
    /// and then come two for each side of a cell that has no neighbour. Its answers are those of the mesh of the same
    /// triangles, to the last bit.</returns>
    /// <exception cref="ArgumentNullException">There are no heights.</exception>
    /// <exception cref="ArgumentException">The heights are no grid, or one of them is NaN or infinite; the holes are
    /// more or fewer than the cells, or all of these are holes.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The spacing is not positive and finite, or the grid leaves the
    /// range of float, or it has more than 4,194,304 columns or rows; the base is not finite, or not below all
    /// heights.</exception>
    /// <exception cref="ObjectDisposedException">The workers were disposed of.</exception>
    public static TriangleMesh FromHeights(
        IReadOnlyList<float> heights, int columns, Vector2 spacing, IReadOnlyList<bool>? isHole = null,
        bool isZUp = false, float? baseHeight = null, Workers? workers = null)
    {
        Workers.Check(workers);
        Guard.NotNull(heights, nameof(heights));
        int rows = columns > 0 ? heights.Count / columns : 0;
        if (columns < 2 || rows < 2 || rows * columns != heights.Count)
        {
            throw new ArgumentException(
                $"{heights.Count} heights are no grid of at least 2 rows of {columns}.", nameof(heights));
        }

        float[] copy = new float[heights.Count];
        for (int i = 0; i < copy.Length; i++)
        {
            copy[i] = heights[i];
            if (!Guard.IsFinite(copy[i]))
                throw new ArgumentException($"Height {i} is NaN or infinite; for holes, see isHole.", nameof(heights));
        }

        if (!IsSpacing(spacing.X, columns) || !IsSpacing(spacing.Y, rows))
            throw new ArgumentOutOfRangeException(nameof(spacing), spacing, "The grid has no such spacing.");
        if (baseHeight is { } lowest && !(Guard.IsFinite(lowest) && Array.TrueForAll(copy, h => h > lowest)))
            throw new ArgumentOutOfRangeException(nameof(baseHeight), lowest, "Must be finite and below all heights.");
        var grid = new HeightGrid(columns, rows, spacing, isZUp, baseHeight);
        var plain = new TriangleList(copy, columns, spacing, isZUp);
        (TriangleList List, MeshTopology Topology) lists;
        if (isHole is null && baseHeight is null)
        {
            lists = (plain, new MeshTopology(columns, rows, isZUp));
        }
        else
        {
            grid.ListTriangles(plain, CopyHoles(isHole, grid.CellCount), out Vector3[] points, out int[] corners);
            lists = ListsOf(points, corners);
        }

        return new TriangleMesh(lists, Vector3.One, grid: grid, workers: workers);
    }

    private static bool IsSpacing(float spacing, int lines) =>
        spacing > 0 && Guard.IsFinite(spacing * lines) && lines <= MostLines;

    private static bool[] CopyHoles(IReadOnlyList<bool>? isHole, int cells)
    {
        bool[] holes = new bool[cells];
        if (isHole is null) return holes;
        if (isHole.Count != cells)
            throw new ArgumentException($"There are {isHole.Count} for {cells} cells.", nameof(isHole));
        for (int i = 0; i < cells; i++) holes[i] = isHole[i];
        if (Array.IndexOf(holes, false) < 0) throw new ArgumentException("All cells are holes.", nameof(isHole));
        return holes;
    }
}
