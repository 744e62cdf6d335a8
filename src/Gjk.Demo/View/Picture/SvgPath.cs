namespace Gjk.Demo.View;

/// <summary>The text of an SVG path. Points are rounded to tenths, and each one is written as the step from the last
/// point. This takes the fewest characters that the format allows.</summary>
internal sealed class SvgPath
{
    private readonly StringBuilder _text = new();
    private int _x, _y;

    public bool IsEmpty => _text.Length == 0;

    /// <summary>Adds a closed outline. Adds nothing if rounding leaves no outline.</summary>
    public void Polygon(IReadOnlyList<(double X, double Y)> points)
    {
        var rounded = new List<(int X, int Y)>(points.Count);
        foreach ((double x, double y) in points)
        {
            (int, int) next = (Tenths(x), Tenths(y));
            if (rounded.Count == 0 || rounded[^1] != next) rounded.Add(next);
        }

        while (rounded.Count > 1 && rounded[^1] == rounded[0]) rounded.RemoveAt(rounded.Count - 1);
        if (rounded.Count < 3) return;
        Draw(rounded);
        _text.Append('z');
        (_x, _y) = rounded[0];
    }

    /// <summary>Adds an open line.</summary>
    public void Line(IReadOnlyList<(double X, double Y)> points)
    {
        var rounded = new List<(int X, int Y)>(points.Count);
        foreach ((double x, double y) in points) rounded.Add((Tenths(x), Tenths(y)));
        Draw(rounded);
    }

    public override string ToString() => _text.ToString();

    private static int Tenths(double x) => (int)Math.Round(Math.Clamp(x, -1e7, 1e7) * 10);

    private void Draw(List<(int X, int Y)> points)
    {
        bool isFirst = _text.Length == 0;
        for (int i = 0; i < points.Count; i++)
        {
            // Pairs that follow a relative move are relative lines and need no letter.
            if (i == 0) _text.Append(isFirst ? 'M' : 'm');
            if (i == 1 && isFirst) _text.Append('l');
            Number(points[i].X - _x, i == 0 || (i == 1 && isFirst));
            Number(points[i].Y - _y, false);
            (_x, _y) = points[i];
        }
    }

    private void Number(int tenths, bool followsLetter)
    {
        if (!followsLetter && tenths >= 0) _text.Append(' ');
        if (tenths < 0) _text.Append('-');
        int size = Math.Abs(tenths);
        if (size >= 10 || size == 0) _text.Append(CultureInfo.InvariantCulture, $"{size / 10}");
        if (size % 10 != 0) _text.Append(CultureInfo.InvariantCulture, $".{size % 10}");
    }
}
