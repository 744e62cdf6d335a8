namespace Gjk.Demo.View;

/// <summary>The region that a convex body hides from the eye, including the body itself. A point is in it if the line
/// from the eye to the point meets the body. The region is convex. It is bounded by the faces that the eye sees and by
/// the planes through the eye and the outline. So the visible part of a convex polygon is a few convex polygons, and no
/// sorting is needed.</summary>
internal sealed class Shadow
{
    /// <summary>How deep inside a point must lie to be hidden, in the units of the picture (a scene is 20 across). It
    /// keeps touching faces in sight.</summary>
    private const double Slack = 1e-5;

    private readonly (Double3 Normal, double Value)[] _planes;

    /// <summary>The plane that cleared the last polygon. It often clears the next one too, because that is a
    /// neighbour.</summary>
    private int _lastClear;

    public Shadow(IEnumerable<(Double3 Normal, double Value)> planes) => _planes = [.. planes];

    /// <summary>True if no part of a ball is hidden.</summary>
    public bool Misses(in Double3 center, double radius)
    {
        foreach ((Double3 normal, double value) in _planes)
        {
            if (Double3.Dot(normal, center) - value > radius - Slack) return true;
        }

        return _planes.Length == 0;
    }

    /// <summary>True if a whole ball is hidden.</summary>
    public bool Hides(in Double3 center, double radius)
    {
        foreach ((Double3 normal, double value) in _planes)
        {
            if (Double3.Dot(normal, center) - value > -radius - Slack) return false;
        }

        return _planes.Length > 0;
    }

    /// <summary>Adds the parts of a convex polygon that are not hidden.</summary>
    public void Cut(Double3[] polygon, List<Double3[]> visible)
    {
        if (IsClear(polygon))
        {
            visible.Add(polygon);
            return;
        }

        Double3[] rest = polygon;
        foreach ((Double3 normal, double value) in _planes)
        {
            if (!Array.Exists(rest, corner => Double3.Dot(normal, corner) - value > -Slack)) continue;
            Split(rest, normal, value - Slack, out Double3[] outside, out rest);
            if (outside.Length > 2) visible.Add(outside);
            if (rest.Length < 3) return;
        }
    }

    /// <summary>Adds the parts of a segment that are not hidden, as shares of its length.</summary>
    public void Cut(
        in Double3 from, in Double3 to, (double From, double To) part, List<(double From, double To)> visible)
    {
        (double enter, double leave) = part;
        foreach ((Double3 normal, double value) in _planes)
        {
            double first = Double3.Dot(normal, from) - value + Slack, step = Double3.Dot(normal, to - from);
            if (step > 0) leave = Math.Min(leave, -first / step);
            else if (step < 0) enter = Math.Max(enter, -first / step);
            else if (first > 0) leave = double.NegativeInfinity;
            if (enter < leave) continue;
            visible.Add(part);
            return;
        }

        if (enter > part.From) visible.Add((part.From, enter));
        if (leave < part.To) visible.Add((leave, part.To));
    }

    private bool IsClear(Double3[] polygon)
    {
        if (_planes.Length == 0 || IsBeyond(polygon, _lastClear)) return true;
        for (int i = 0; i < _planes.Length; i++)
        {
            if (!IsBeyond(polygon, i)) continue;
            _lastClear = i;
            return true;
        }

        return false;
    }

    private bool IsBeyond(Double3[] polygon, int plane)
    {
        (Double3 normal, double value) = _planes[plane];
        foreach (Double3 corner in polygon)
        {
            if (Double3.Dot(normal, corner) - value < -Slack) return false;
        }

        return true;
    }

    private static void Split(
        Double3[] polygon, in Double3 normal, double value, out Double3[] outside, out Double3[] inside)
    {
        List<Double3> beyond = [], behind = [];
        for (int i = 0; i < polygon.Length; i++)
        {
            Double3 a = polygon[i], b = polygon[(i + 1) % polygon.Length];
            double atA = Double3.Dot(normal, a) - value, atB = Double3.Dot(normal, b) - value;
            (atA > 0 ? beyond : behind).Add(a);
            if (atA > 0 == atB > 0) continue;
            Double3 crossing = a + (b - a) * (atA / (atA - atB));
            beyond.Add(crossing);
            behind.Add(crossing);
        }

        outside = beyond.Count > 2 ? [.. beyond] : [];
        inside = behind.Count > 2 ? [.. behind] : [];
    }
}
