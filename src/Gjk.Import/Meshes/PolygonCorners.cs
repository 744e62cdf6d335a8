namespace Gjk.Import;

/// <summary>The corners of a polygon as a ring, seen along the coordinate axis in which the polygon is largest, so that
/// they run counter-clockwise. The projected coordinates are the given floats, so that its tests are exact.</summary>
internal sealed class PolygonCorners
{
    private readonly PlanarOrientation _orientation = new();
    private int[] _vertices = [];
    private Vector3[] _points = [];
    private float[] _u = [], _v = [];

    public int Count { get; private set; }

    /// <summary>Twice the area of the outline, as a vector along the polygon's normal.</summary>
    public Double3 Area { get; private set; }

    /// <summary>True if all corners lie on one line, as far as double can tell.</summary>
    public bool IsLine { get; private set; }

    public int Vertex(int corner) => _vertices[corner];

    public Vector3 Point(int corner) => _points[corner];

    public float U(int corner) => _u[corner];

    public float V(int corner) => _v[corner];

    public bool IsSame(int a, int b) => _points[a] == _points[b];

    /// <summary>1 if the corner c lies to the left of the line from a to b, 0 on it, -1 to the right. Exact.</summary>
    public int Turn(int a, int b, int c) => _orientation.Sign(_u[a], _v[a], _u[b], _v[b], _u[c], _v[c]);

    /// <summary>Takes a polygon without its repeated corners, and without spikes, which go out and back on the same
    /// way: neither has an area.</summary>
    public void Take(IReadOnlyList<Vector3> vertices, ReadOnlySpan<int> polygon)
    {
        if (_vertices.Length < polygon.Length)
        {
            _vertices = new int[polygon.Length];
            _points = new Vector3[polygon.Length];
            _u = new float[polygon.Length];
            _v = new float[polygon.Length];
        }

        int start = 0, end = 0;
        foreach (int vertex in polygon)
        {
            _vertices[end] = vertex;
            _points[end] = vertices[vertex];
            end++;
            if (end >= 3 && IsSame(end - 3, end - 1)) end -= 2;
            else if (end >= 2 && IsSame(end - 2, end - 1)) end--;
        }

        // The same where the end meets the beginning.
        while (end - start >= 3)
        {
            if (IsSame(start, end - 1)) end--;
            else if (IsSame(start, end - 2)) end -= 2;
            else if (IsSame(start + 1, end - 1)) start++;
            else break;
        }

        Count = end - start;
        if (start > 0)
        {
            Array.Copy(_vertices, start, _vertices, 0, Count);
            Array.Copy(_points, start, _points, 0, Count);
        }

        Project();
    }

    /// <summary>The sizes of the triangles of a fan tell the axis even where their signs cancel, as in an
    /// eight.</summary>
    private void Project()
    {
        Double3 area = default, size = default;
        Double3 first = _points[0];
        for (int i = 1; i + 1 < Count; i++)
        {
            Double3 cross = Double3.Cross(_points[i] - first, _points[i + 1] - first);
            area += cross;
            size += new Double3(Math.Abs(cross.X), Math.Abs(cross.Y), Math.Abs(cross.Z));
        }

        Area = area;
        int axis = size.X >= size.Y && size.X >= size.Z ? 0 : size.Y >= size.Z ? 1 : 2;
        IsLine = Along(size, axis) == 0;
        int u = (axis + 1) % 3, v = (axis + 2) % 3;
        if (Along(area, axis) < 0) (u, v) = (v, u);
        for (int i = 0; i < Count; i++)
        {
            _u[i] = (float)Along(_points[i], u);
            _v[i] = (float)Along(_points[i], v);
        }
    }

    private static double Along(in Double3 v, int axis) => axis == 0 ? v.X : axis == 1 ? v.Y : v.Z;
}
