namespace Gjk.Import;

/// <summary>What is odd about a polygon. Its triangles have its area and winding all the same.</summary>
[Flags]
internal enum PolygonFaults
{
    None = 0,

    /// <summary>Fewer than three corners are left without repetitions: it has no area and no triangles.</summary>
    Thin = 1,

    /// <summary>Its outline crosses itself, so triangles overlap.</summary>
    NotSimple = 2,

    /// <summary>Its corners do not lie in one plane, so there is more than one surface that it may mean.</summary>
    NotFlat = 4,
}

/// <summary>Cuts polygons into triangles: a fan from the first corner where that is right, else ears (Meisters 1975).
/// Holes that a bridge joins to the outline are kept open. Every corner stays a corner, those within a straight edge
/// too, because a neighbour may have its own corner there. The triangles' areas sum up to that of the polygon as
/// vectors, whatever its outline is. Not thread-safe.</summary>
internal sealed class PolygonTriangles
{
    /// <summary>Share of the polygon's longest side that a corner may lie out of its plane. Nobody sees the difference
    /// between two surfaces that are nearer to each other than this; PolygonTests pins it.</summary>
    private const double FlatTolerance = 1e-4;

    /// <summary>Share of the largest coordinate: files have six digits at least, and a half in the last of them is
    /// rounding. PolygonTests pins it.</summary>
    private const double DigitTolerance = 1e-6;

    private readonly PolygonCorners _corners = new();
    private readonly EarClipping _ears = new();
    private readonly OutlineCrossing _crossing = new();

    /// <param name="vertices">All vertices.</param>
    /// <param name="polygon">Indices of the polygon's corners, in order.</param>
    /// <param name="triangles">Receives three indices for each triangle.</param>
    public PolygonFaults Append(IReadOnlyList<Vector3> vertices, ReadOnlySpan<int> polygon, List<int> triangles)
    {
        if (polygon.Length < 3) return PolygonFaults.Thin;
        if (polygon.Length == 3)
        {
            foreach (int corner in polygon) triangles.Add(corner);
            return PolygonFaults.None;
        }

        _corners.Take(vertices, polygon);
        if (_corners.Count < 3) return PolygonFaults.Thin;
        if (_corners.IsLine || IsFan())
        {
            AppendFan(triangles);
            return Flatness();
        }

        bool isClean = _ears.Append(_corners, triangles) && !_crossing.Exists(_corners);
        return (isClean ? PolygonFaults.None : PolygonFaults.NotSimple) | Flatness();
    }

    /// <summary>True if all triangles of the fan turn left, and all its corners lie to the left of its first edge: then
    /// they follow each other around the first corner, once.</summary>
    private bool IsFan()
    {
        for (int i = 2; i < _corners.Count; i++)
        {
            if (_corners.Turn(0, i - 1, i) <= 0 || _corners.Turn(0, 1, i) <= 0) return false;
        }

        return true;
    }

    private void AppendFan(List<int> triangles)
    {
        for (int i = 2; i < _corners.Count; i++)
        {
            triangles.Add(_corners.Vertex(0));
            triangles.Add(_corners.Vertex(i - 1));
            triangles.Add(_corners.Vertex(i));
        }
    }

    private PolygonFaults Flatness()
    {
        double length = _corners.Area.Length;
        if (_corners.Count < 4 || length == 0) return PolygonFaults.None;
        Vector3 min = _corners.Point(0), max = min;
        Double3 sum = default;
        for (int i = 0; i < _corners.Count; i++)
        {
            min = Vector3.Min(min, _corners.Point(i));
            max = Vector3.Max(max, _corners.Point(i));
            sum += _corners.Point(i);
        }

        Double3 normal = _corners.Area * (1 / length), center = sum * (1.0 / _corners.Count), size = (Double3)max - min;
        double most = FlatTolerance * Math.Max(Math.Max(size.X, size.Y), size.Z)
            + DigitTolerance * Math.Max(Largest(min), Largest(max));
        for (int i = 0; i < _corners.Count; i++)
        {
            if (Math.Abs(Double3.Dot(normal, _corners.Point(i) - center)) > most) return PolygonFaults.NotFlat;
        }

        return PolygonFaults.None;
    }

    private static float Largest(Vector3 v) => Math.Max(Math.Max(Math.Abs(v.X), Math.Abs(v.Y)), Math.Abs(v.Z));
}
