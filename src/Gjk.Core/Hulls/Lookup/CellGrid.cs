namespace Gjk.Core;

/// <summary>How directions are drawn on the faces of a cube, or on the sides of a square for a flat hull.</summary>
/// <remarks>Cube: face 2 axis + (0 for +, 1 for -), and u and v are the other two coordinates in the order of the axes.
/// Square: the same with the two axes that matter, one row, and the third axis as v, along which nothing
/// changes.</remarks>
internal readonly struct CellGrid
{
    /// <summary>Cell side: how far each cell is widened. The look-up finds a direction's cell with an error of 2^-44
    /// sides at most (proofs/cell-widening.g).</summary>
    private const double Widening = 1.0 / (1 << 30);

    public readonly int Faces, Columns, Rows;

    private readonly int _flatAxis;

    public CellGrid(int side, int flatAxis = -1)
    {
        (_flatAxis, Columns) = (flatAxis, side);
        (Faces, Rows) = flatAxis < 0 ? (6, side) : (4, 1);
    }

    public int Cells => Faces * Rows * Columns;

    public int Cell(int face, int row, int column) => (face * Rows + row) * Columns + column;

    /// <summary>The axis whose component is 1 or -1 on a face.</summary>
    public int AxisW(int face) => _flatAxis < 0 ? face >> 1 : face < 2 ? First : Second;

    public int AxisU(int face) => _flatAxis < 0 ? (face < 2 ? 1 : 0) : face < 2 ? Second : First;

    public int AxisV(int face) => _flatAxis < 0 ? (face < 4 ? 2 : 1) : _flatAxis;

    public double SignW(int face) => (face & 1) == 0 ? 1 : -1;

    /// <summary>The centre of a rectangle and half its sides, a little widened. A single row has no height.</summary>
    public void Measure(in CellRect rect, out double u, out double v, out double halfU, out double halfV)
    {
        u = (double)(rect.Column + rect.EndColumn) / Columns - 1;
        v = (double)(rect.Row + rect.EndRow) / Rows - 1;
        halfU = (rect.Columns + 2 * Widening) / Columns;
        halfV = Rows == 1 ? 0 : (rect.Rows + 2 * Widening) / Rows;
    }

    private int First => _flatAxis == 0 ? 1 : 0;

    private int Second => _flatAxis == 2 ? 1 : 2;
}
