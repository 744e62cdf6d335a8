namespace Gjk.Import;

/// <summary>Finds out whether two edges of a polygon cross. Edges that only touch do not count: bridges lie upon each
/// other. A sweep along the axis in which the edges are shorter. Not thread-safe.</summary>
internal sealed class OutlineCrossing
{
    /// <summary>Pairs of edges. The sweep ends here, about a second, and takes the outline as simple: what it would
    /// tell is a warning, and the triangles are the same.</summary>
    private const long MostPairs = 1 << 28;

    private readonly List<int> _active = [];
    private PolygonCorners _corners = null!;
    private int[] _order = [];
    private float[] _starts = [];
    private bool _isAlongU;

    public bool Exists(PolygonCorners corners)
    {
        _corners = corners;
        int count = corners.Count;
        if (_order.Length < count) (_order, _starts) = (new int[count], new float[count]);
        _isAlongU = Stretch(true) <= Stretch(false);
        for (int i = 0; i < count; i++) (_order[i], _starts[i]) = (i, Start(i));
        Array.Sort(_starts, _order, 0, count);
        _active.Clear();
        long pairs = 0;
        for (int i = 0; i < count && pairs < MostPairs; i++)
        {
            int edge = _order[i];
            pairs += _active.Count;
            if (CrossesActive(edge, _starts[i])) return true;
            _active.Add(edge);
        }

        return false;
    }

    /// <summary>Forgets the edges that end before the given place.</summary>
    private bool CrossesActive(int edge, float start)
    {
        int kept = 0;
        bool crosses = false;
        for (int k = 0; k < _active.Count; k++)
        {
            int other = _active[k];
            if (Math.Max(Along(other), Along(After(other))) < start) continue;
            _active[kept++] = other;
            crosses |= Cross(edge, other);
        }

        _active.RemoveRange(kept, _active.Count - kept);
        return crosses;
    }

    private bool Cross(int edge, int other)
    {
        int a = edge, b = After(edge), c = other, d = After(other);
        float minA = Math.Min(Across(a), Across(b)), maxA = Math.Max(Across(a), Across(b));
        if (Math.Min(Across(c), Across(d)) > maxA || Math.Max(Across(c), Across(d)) < minA) return false;
        return _corners.Turn(a, b, c) * _corners.Turn(a, b, d) < 0
            && _corners.Turn(c, d, a) * _corners.Turn(c, d, b) < 0;
    }

    /// <summary>The length of all edges along an axis, in lengths of the polygon.</summary>
    private double Stretch(bool isAlongU)
    {
        double sum = 0, min = double.PositiveInfinity, max = double.NegativeInfinity;
        for (int i = 0; i < _corners.Count; i++)
        {
            double here = isAlongU ? _corners.U(i) : _corners.V(i);
            double next = isAlongU ? _corners.U(After(i)) : _corners.V(After(i));
            sum += Math.Abs(next - here);
            (min, max) = (Math.Min(min, here), Math.Max(max, here));
        }

        return sum / (max - min);
    }

    private int After(int corner) => corner + 1 < _corners.Count ? corner + 1 : 0;

    private float Along(int corner) => _isAlongU ? _corners.U(corner) : _corners.V(corner);

    private float Across(int corner) => _isAlongU ? _corners.V(corner) : _corners.U(corner);

    private float Start(int edge) => Math.Min(Along(edge), Along(After(edge)));
}
