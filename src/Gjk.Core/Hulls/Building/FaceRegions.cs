namespace Gjk.Core;

/// <summary>Joins the triangles of a hull that lie in one plane, to within rounding, to convex polygons.</summary>
/// <remarks>A region begins with the largest triangle that is left, whose plane is the best known, and grows over edges
/// as long as the corners lie in that plane. Its polygon is the outline of its corners seen along the normal.</remarks>
internal sealed class FaceRegions
{
    /// <summary>Length, as a fraction of the hull's size: how far beside a region's plane a corner may lie. Corners
    /// that a program rounded to float lie within 1e-7; what is joined beyond that is a bump no higher than the contact
    /// points are meant to be exact. Pinned by HullFacesTests.</summary>
    private const double Flatness = 1e-6;

    /// <summary>Cosine: what is tilted by more, some 8 degrees, is another face, however thin the hull is. Pinned by
    /// HullFacesTests.</summary>
    private const double SameSide = 0.99;

    public readonly int[] FaceStart, Corners, VertexStart, VertexFaces;
    public readonly Double3[] Normals;

    /// <summary>Ratio to a coordinate: 2^-23, twice its rounding to float, which far from the local origin is what is
    /// left of flatness. Pinned by HullFacesTests.</summary>
    private const double FloatRounding = 1.0 / (1 << 23);

    private const int None = -1;

    private readonly Vector3[] _points;
    private readonly int[] _triangles, _trianglesAt, _faceOf, _facesSeen;
    private readonly double _flatness;
    private readonly List<int> _corners = [], _start = [0], _region = [], _beyond = [];
    private readonly List<Double3> _normals = [];
    private readonly FaceOutline _outline;

    /// <param name="points">The hull's corners.</param>
    /// <param name="triangles">Three corners each, counter-clockwise seen from outside.</param>
    /// <param name="bounds">The box around the corners.</param>
    public FaceRegions(Vector3[] points, int[] triangles, in Aabb bounds)
    {
        _points = points;
        _triangles = triangles;
        Double3 extent = (Double3)bounds.Max - bounds.Min;
        _flatness = Math.Max(Flatness * extent.LargestMagnitude, Math.Max(Rounding(bounds.Min), Rounding(bounds.Max)));
        _outline = new FaceOutline(points);
        _faceOf = new int[triangles.Length / 3];
        VertexStart = new int[points.Length + 1];
        _trianglesAt = new int[triangles.Length];
        CollectTriangles();
        GrowAll();
        FaceStart = _start.ToArray();
        Corners = _corners.ToArray();
        Normals = _normals.ToArray();
        _facesSeen = new int[Normals.Length];
        VertexFaces = CollectFaces();
    }

    /// <summary>The triangles at each vertex.</summary>
    private void CollectTriangles()
    {
        foreach (int corner in _triangles) VertexStart[corner + 1]++;
        for (int i = 1; i < VertexStart.Length; i++) VertexStart[i] += VertexStart[i - 1];
        int[] filled = new int[_points.Length];
        for (int i = 0; i < _triangles.Length; i++)
        {
            int corner = _triangles[i];
            _trianglesAt[VertexStart[corner] + filled[corner]++] = i / 3;
        }
    }

    private void GrowAll()
    {
        int count = _faceOf.Length;
        var normals = new Double3[count];
        double[] areas = new double[count];
        int[] order = new int[count];
        for (int i = 0; i < count; i++)
        {
            normals[i] = Normal(i);
            areas[i] = normals[i].Length;
            order[i] = i;
            _faceOf[i] = None;
        }

        Array.Sort(order, (i, j) => areas[i] != areas[j] ? areas[j].CompareTo(areas[i]) : i.CompareTo(j));
        foreach (int seed in order)
            if (_faceOf[seed] == None && areas[seed] > 0) Grow(seed, normals, areas);
        foreach (int sliver in order)
            if (_faceOf[sliver] == None) _faceOf[sliver] = FaceBeside(sliver);
    }

    private void Grow(int seed, Double3[] normals, double[] areas)
    {
        int face = _normals.Count;
        Double3 normal = normals[seed] * (1 / areas[seed]), origin = Corner(seed, 0);
        _region.Clear();
        _region.Add(seed);
        _faceOf[seed] = face;
        for (int i = 0; i < _region.Count; i++)
        {
            for (int k = 0; k < 3; k++)
            {
                CollectBeyond(_region[i], k);
                foreach (int next in _beyond)
                {
                    if (_faceOf[next] != None || !LiesIn(next)) continue;
                    _faceOf[next] = face;
                    _region.Add(next);
                }
            }
        }

        _normals.Add(normal);
        _outline.Append(_region, _triangles, normal, _corners);
        _start.Add(_corners.Count);

        bool LiesIn(int triangle)
        {
            for (int k = 0; k < 3; k++)
                if (Math.Abs(Double3.Dot(Corner(triangle, k) - origin, normal)) > _flatness) return false;
            return Double3.Dot(normals[triangle], normal) >= SameSide * areas[triangle];
        }
    }

    /// <summary>The triangles on the other side of an edge, which run along it the other way: one of a solid, of a flat
    /// hull the one beside it and one on its back.</summary>
    private void CollectBeyond(int triangle, int edge)
    {
        _beyond.Clear();
        int from = _triangles[3 * triangle + edge], to = _triangles[3 * triangle + (edge + 1) % 3];
        int few = VertexStart[from + 1] - VertexStart[from] <= VertexStart[to + 1] - VertexStart[to] ? from : to;
        for (int i = VertexStart[few]; i < VertexStart[few + 1]; i++)
        {
            int t = _trianglesAt[i];
            for (int k = 0; k < 3; k++)
                if (_triangles[3 * t + k] == to && _triangles[3 * t + (k + 1) % 3] == from) _beyond.Add(t);
        }
    }

    /// <summary>A triangle whose area is lost to rounding has no plane of its own.</summary>
    private int FaceBeside(int triangle)
    {
        for (int k = 0; k < 3; k++)
        {
            CollectBeyond(triangle, k);
            foreach (int next in _beyond)
                if (_faceOf[next] != None) return _faceOf[next];
        }

        return None;
    }

    /// <summary>The faces at each vertex, each once; the lists take the place of those of the triangles.</summary>
    private int[] CollectFaces()
    {
        var faces = new List<int>(_trianglesAt.Length);
        for (int vertex = 0; vertex < _points.Length; vertex++)
        {
            int from = VertexStart[vertex], to = VertexStart[vertex + 1];
            VertexStart[vertex] = faces.Count;
            for (int i = from; i < to; i++)
            {
                int face = _faceOf[_trianglesAt[i]];
                if (face == None || _facesSeen[face] == vertex + 1) continue;
                _facesSeen[face] = vertex + 1;
                faces.Add(face);
            }
        }

        VertexStart[_points.Length] = faces.Count;
        return faces.ToArray();
    }

    private static double Rounding(in Double3 corner) => FloatRounding * corner.LargestMagnitude;

    private Double3 Corner(int triangle, int k) => _points[_triangles[3 * triangle + k]];

    private Double3 Normal(int triangle)
    {
        Double3 a = Corner(triangle, 0);
        return Double3.Cross(Corner(triangle, 1) - a, Corner(triangle, 2) - a);
    }
}
