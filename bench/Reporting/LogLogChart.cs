namespace Gjk.Bench.Reporting;

/// <summary>A line of a chart.</summary>
/// <param name="Name">The name in the legend.</param>
/// <param name="Colour">The colour in CSS notation.</param>
/// <param name="Points">The points from left to right. All coordinates are above 0.</param>
internal sealed record ChartLine(string Name, string Colour, IReadOnlyList<(double X, double Y)> Points);

/// <summary>Draws lines over two logarithmic axes. The chart has its own background, so that it is readable on a light
/// page and on a dark one.</summary>
internal sealed class LogLogChart
{
    private const int Width = 760, Height = 470;
    private const double Left = 84, Right = 712, Top = 84, Bottom = 404;
    private const string Paper = "#ffffff", Frame = "#d0d7de", Grid = "#e6e9ed";
    private const string Axis = "#8c959f", Ink = "#1f2328", Soft = "#57606a";

    private readonly ChartLine[] _lines;
    private readonly double[] _ticks;
    private readonly double _minX, _maxX;
    private readonly int _minDecade, _maxDecade;

    public LogLogChart(IEnumerable<ChartLine> lines)
    {
        _lines = [.. lines];
        _ticks = [.. _lines.SelectMany(l => l.Points).Select(p => p.X).Distinct().Order()];
        if (_ticks.Length < 2)
            throw new ArgumentException("A chart needs points at two places or more.", nameof(lines));
        (_minX, _maxX) = (_ticks[0], _ticks[^1]);
        double[] values = [.. _lines.SelectMany(l => l.Points).Select(p => p.Y)];
        _minDecade = (int)Math.Floor(Math.Log10(values.Min()));
        _maxDecade = Math.Max(_minDecade + 1, (int)Math.Ceiling(Math.Log10(values.Max())));
    }

    public required string Title { get; init; }

    public required string Subtitle { get; init; }

    public required string AxisX { get; init; }

    public required string AxisY { get; init; }

    /// <summary>Formats a decade of the vertical axis, or a point.</summary>
    public required Func<double, string> Unit { get; init; }

    public string Draw()
    {
        var svg = new SvgWriter(Width, Height, Title);
        svg.Rectangle(0.5, 0.5, Width - 1, Height - 1, 10, Paper, Frame);
        svg.Text(Left, 34, Title, 17, Ink, SvgWriter.Anchor.Start, bold: true);
        svg.Text(Left, 56, Subtitle, 12, Soft, SvgWriter.Anchor.Start);
        DrawAxes(svg);
        foreach (ChartLine line in _lines) DrawLine(svg, line);
        DrawLegend(svg);
        return svg.Finish();
    }

    private void DrawAxes(SvgWriter svg)
    {
        for (int decade = _minDecade; decade <= _maxDecade; decade++)
        {
            double y = PlaceY(Math.Pow(10, decade));
            svg.Line(Left, y, Right, y, decade == _minDecade ? Axis : Grid, 1);
            svg.Text(Left - 8, y + 4, Unit(Math.Pow(10, decade)), 12, Soft, SvgWriter.Anchor.End);
        }

        foreach (double tick in _ticks)
        {
            double x = PlaceX(tick);
            svg.Line(x, Top, x, Bottom, Grid, 1);
            svg.Line(x, Bottom, x, Bottom + 5, Axis, 1);
            string label = tick.ToString("#,0", CultureInfo.InvariantCulture);
            svg.Text(x, Bottom + 20, label, 12, Soft, SvgWriter.Anchor.Middle);
        }

        svg.Text((Left + Right) / 2, Bottom + 46, AxisX, 13, Ink, SvgWriter.Anchor.Middle);
        svg.TextUpwards(24, (Top + Bottom) / 2, AxisY, 13, Ink);
    }

    private void DrawLine(SvgWriter svg, ChartLine line)
    {
        svg.Polyline(line.Points.Select(p => (PlaceX(p.X), PlaceY(p.Y))), line.Colour, 2.4);
        foreach ((double x, double y) in line.Points)
        {
            string tip = string.Create(CultureInfo.InvariantCulture, $"{line.Name}, {x:#,0}: {Unit(y)}");
            svg.Dot(PlaceX(x), PlaceY(y), 3.6, line.Colour, tip);
        }
    }

    /// <summary>Draws the legend in the upper left corner. Growing costs leave that corner free.</summary>
    private void DrawLegend(SvgWriter svg)
    {
        const double RowHeight = 22, LineLength = 26, Padding = 12;
        double x = Left + 14, y = Top + 8, height = RowHeight * _lines.Length + Padding;
        svg.Rectangle(x, y, 276, height, 6, Paper, Grid);
        for (int i = 0; i < _lines.Length; i++)
        {
            double row = y + Padding / 2 + RowHeight * (i + 0.5);
            svg.Line(x + Padding, row, x + Padding + LineLength, row, _lines[i].Colour, 2.4);
            svg.Dot(x + Padding + LineLength / 2, row, 3.6, _lines[i].Colour, _lines[i].Name);
            svg.Text(x + 2 * Padding + LineLength, row + 4, _lines[i].Name, 13, Ink, SvgWriter.Anchor.Start);
        }
    }

    private double PlaceX(double x) => Left + (Right - Left) * Math.Log(x / _minX) / Math.Log(_maxX / _minX);

    private double PlaceY(double y) =>
        Bottom - (Bottom - Top) * (Math.Log10(y) - _minDecade) / (_maxDecade - _minDecade);
}
