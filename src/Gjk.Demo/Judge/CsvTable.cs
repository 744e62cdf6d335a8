namespace Gjk.Demo.Judge;

/// <summary>A file of CSV (RFC 4180, without line breaks in fields) with a heading. What is refused is named by file,
/// line and column.</summary>
internal sealed class CsvTable
{
    private readonly string _file;
    private readonly List<string> _columns;
    private readonly List<CsvRow> _rows = [];

    private CsvTable(string file, string text)
    {
        _file = file;
        string[] lines = text.TrimStart('\uFEFF').Split('\n');
        _columns = Cells(lines[0], 1);
        for (int i = 1; i < lines.Length; i++)
        {
            if (lines[i].Length < 2 && lines[i].Trim().Length == 0) continue;
            List<string> cells = Cells(lines[i], i + 1);
            if (cells.Count != _columns.Count)
                throw Refuse(i + 1, $"has {cells.Count} fields, the heading {_columns.Count}");
            _rows.Add(new CsvRow(this, i + 1, cells));
        }
    }

    /// <summary>All but the heading.</summary>
    public IReadOnlyList<CsvRow> Rows => _rows;

    /// <exception cref="RefusedException">The file is not such a table.</exception>
    public static CsvTable Load(string file, CancellationToken cancel) =>
        new(InputFile.NameOf(file), Encoding.UTF8.GetString(InputFile.Read(file, cancel)));

    /// <summary>True if the heading has a column of that name.</summary>
    public bool Has(string column) => _columns.Contains(column);

    /// <exception cref="RefusedException">The heading lacks one of the columns.</exception>
    public void Require(params string[] columns)
    {
        foreach (string column in columns)
            if (!Has(column)) throw Refuse(1, $"there is no column {column}");
    }

    public int IndexOf(string column) => _columns.IndexOf(column);

    public RefusedException Refuse(int line, string reason) => new($"{_file}: line {line}: {reason}");

    private List<string> Cells(string line, int number)
    {
        var cells = new List<string>();
        var cell = new StringBuilder();
        bool isQuoted = false;
        line = line.TrimEnd('\r');
        for (int i = 0; i < line.Length; i++)
        {
            char c = line[i];
            if (c == '"' && isQuoted && i + 1 < line.Length && line[i + 1] == '"') cell.Append(line[++i]);
            else if (c == '"') isQuoted = !isQuoted;
            else if (c != ',' || isQuoted) cell.Append(c);
            else Take();
        }

        if (isQuoted) throw Refuse(number, "a quotation mark is not closed");
        Take();
        return cells;

        void Take()
        {
            cells.Add(cell.ToString().Trim());
            cell.Clear();
        }
    }
}

/// <summary>One line of a <see cref="CsvTable"/>.</summary>
internal sealed class CsvRow(CsvTable table, int line, List<string> cells)
{
    /// <summary>The text of a column, which the table must have.</summary>
    public string this[string column] => cells[table.IndexOf(column)];

    /// <summary>True if there is such a column, and something in it.</summary>
    public bool Has(string column) => table.Has(column) && this[column].Length > 0;

    /// <summary>A whole number, at least 0.</summary>
    public int Index(string column) =>
        int.TryParse(this[column], NumberStyles.None, CultureInfo.InvariantCulture, out int value)
            ? value
            : throw Refuse(column, "must be a whole number, at least 0");

    /// <summary>Any number, NaN and infinity too, as C, Python and .NET write them. NaN where the cell is
    /// empty.</summary>
    public double Number(string column)
    {
        string text = this[column];
        if (text.Length == 0) return double.NaN;
        if (text is "inf" or "+inf") return double.PositiveInfinity;
        if (text == "-inf") return double.NegativeInfinity;
        return double.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out double value)
            ? value
            : throw Refuse(column, "must be a number");
    }

    public bool Flag(string column) => this[column].ToLowerInvariant() switch
    {
        "true" => true,
        "false" => false,
        _ => throw Refuse(column, "must be true or false"),
    };

    /// <summary>Refuses what the column says.</summary>
    public RefusedException Refuse(string column, string reason) =>
        table.Refuse(line, $"column {column}: {reason}, but is \"{this[column]}\"");
}
