using System.Globalization;

namespace Gjk.Demo.Tests.Support;

/// <summary>One row of the demo's CSV.</summary>
public sealed record CsvRow(
    int A, int B, string Status, bool Overlap, float Distance, float LowerBound, Vector3 PointA, Vector3 PointB,
    Vector3 Normal, int Iterations)
{
    public const string Header = "a,b,status,overlap,distance,lower_bound,ax,ay,az,bx,by,bz,nx,ny,nz,iterations";

    /// <summary>Reads a table and checks its form.</summary>
    public static List<CsvRow> Parse(string csv)
    {
        Assert.EndsWith("\n", csv);
        string[] lines = csv.Split('\n')[..^1];
        Assert.Equal(Header, lines[0]);
        return [.. lines.Skip(1).Select(ParseRow)];
    }

    private static CsvRow ParseRow(string line)
    {
        string[] cells = line.Split(',');
        Assert.Equal(16, cells.Length);
        Assert.Contains(cells[3], new[] { "true", "false" });
        float[] floats = [.. cells[4..15].Select(Float)];
        return new CsvRow(
            int.Parse(cells[0], CultureInfo.InvariantCulture), int.Parse(cells[1], CultureInfo.InvariantCulture),
            cells[2], cells[3] == "true",
            floats[0], floats[1], new Vector3(floats[2], floats[3], floats[4]),
            new Vector3(floats[5], floats[6], floats[7]),
            new Vector3(floats[8], floats[9], floats[10]), int.Parse(cells[15], CultureInfo.InvariantCulture));
    }

    /// <summary>Accepts only the shortest text that gives the same float back. An empty cell is unknown.</summary>
    private static float Float(string cell)
    {
        if (cell.Length == 0) return float.NaN;
        float value = float.Parse(cell, NumberStyles.Float, CultureInfo.InvariantCulture);
        Assert.Equal(value.ToString("R", CultureInfo.InvariantCulture), cell);
        return value;
    }
}
