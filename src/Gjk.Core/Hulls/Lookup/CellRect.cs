namespace Gjk.Core;

/// <summary>A rectangle of cells on a face of the direction cube, with the vertices that can be furthest in its
/// directions.</summary>
internal readonly struct CellRect(int face, int column, int endColumn, int row, int endRow, int from = 0, int count = 0)
{
    /// <summary>Which face, and where on it: from a column and row up to, not including, others.</summary>
    public readonly int Face = face, Column = column, EndColumn = endColumn, Row = row, EndRow = endRow;

    /// <summary>Where the list of vertices lies, and how many there are.</summary>
    public readonly int From = from, Count = count;

    public int Columns => EndColumn - Column;

    public int Rows => EndRow - Row;

    public int Cells => Columns * Rows;

    /// <summary>The same rectangle with a list.</summary>
    public CellRect WithList(int from, int count) => new(Face, Column, EndColumn, Row, EndRow, from, count);

    /// <summary>The half with the lower columns, or with the lower rows where these are more.</summary>
    public CellRect LowerHalf() =>
        Columns >= Rows
            ? new CellRect(Face, Column, Column + Columns / 2, Row, EndRow)
            : new CellRect(Face, Column, EndColumn, Row, Row + Rows / 2);

    /// <summary>The other half.</summary>
    public CellRect UpperHalf() =>
        Columns >= Rows
            ? new CellRect(Face, Column + Columns / 2, EndColumn, Row, EndRow)
            : new CellRect(Face, Column, EndColumn, Row + Rows / 2, EndRow);
}
