using System;
using System.Collections.Generic;
using Gjk.Core;

namespace Gjk.Demo.View;

/// <summary>
/// The region that a convex body hides from the eye, including the body itself. A point is in it if the line from the
/// eye to the point meets the body. The region is convex. It is bounded by the faces that the eye sees and by the
/// planes through the eye and the outline. So the visible part of a convex polygon is a few convex polygons, and no
/// sorting is needed.
/// </summary>
internal sealed class Shadow
{
    /// <summary>
    /// How deep inside a point must lie to be hidden, in the units of the picture (a scene is 20 across). It keeps
    /// touching faces in sight.
    /// </summary>
    private const double Slack = 1e-5;

    private readonly (Vector3D Normal, double Value)[] _planes;

    /// <summary>
    /// The plane that cleared the last polygon. It often clears the next one too, because that is a neighbour.
    /// </summary>
    private int _lastClear;

    public Shadow(IEnumerable<(Vector3D Normal, double Value)> planes) => _planes = [.. planes];

    /// <summary>True if no part of a ball is hidden.</summary>
    public bool Misses(in Vector3D center, double radius)
    {
        foreach ((Vector3D normal, double value) in _planes)
        {
            if (Vector3D.Dot(normal, center) - value > radius - Slack) return true;
        }

        return _planes.Length == 0;
    }

    /// <summary>True if a whole ball is hidden.</summary>
    public bool Hides(in Vector3D center, double radius)
    {
        foreach ((Vector3D normal, double value) in _planes)
        {
            if (Vector3D.Dot(normal, center) - value > -radius - Slack) return false;
        }

        return _planes.Length > 0;
    }

    /// <summary>Adds the parts of a convex polygon that are not hidden.</summary>
    public void Cut(Vector3D[] polygon, List<Vector3D[]> visible)
    {
        if (IsClear(polygon))
        {
            visible.Add(polygon);
            return;
        }

        Vector3D[] rest = polygon;
        foreach ((Vector3D normal, double value) in _planes)
        {
            if (!Array.Exists(rest, corner => Vector3D.Dot(normal, corner) - value > -Slack)) continue;
            Split(rest, normal, value - Slack, out Vector3D[] outside, out rest);
            if (outside.Length > 2) visible.Add(outside);
            if (rest.Length < 3) return;
        }
    }

    /// <summary>Adds the parts of a segment that are not hidden, as shares of its length.</summary>
    public void Cut(
        in Vector3D from, in Vector3D to, (double From, double To) part, List<(double From, double To)> visible)
    {
        (double enter, double leave) = part;
        foreach ((Vector3D normal, double value) in _planes)
        {
            double first = Vector3D.Dot(normal, from) - value + Slack, step = Vector3D.Dot(normal, to - from);
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

    private bool IsClear(Vector3D[] polygon)
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

    private bool IsBeyond(Vector3D[] polygon, int plane)
    {
        (Vector3D normal, double value) = _planes[plane];
        foreach (Vector3D corner in polygon)
        {
            if (Vector3D.Dot(normal, corner) - value < -Slack) return false;
        }

        return true;
    }

    private static void Split(
        Vector3D[] polygon, in Vector3D normal, double value, out Vector3D[] outside, out Vector3D[] inside)
    {
        List<Vector3D> beyond = [], behind = [];
        for (int i = 0; i < polygon.Length; i++)
        {
            Vector3D a = polygon[i], b = polygon[(i + 1) % polygon.Length];
            double atA = Vector3D.Dot(normal, a) - value, atB = Vector3D.Dot(normal, b) - value;
            (atA > 0 ? beyond : behind).Add(a);
            if (atA > 0 == atB > 0) continue;
            Vector3D crossing = a + (b - a) * (atA / (atA - atB));
            beyond.Add(crossing);
            behind.Add(crossing);
        }

        outside = beyond.Count > 2 ? [.. beyond] : [];
        inside = behind.Count > 2 ? [.. behind] : [];
    }
}
