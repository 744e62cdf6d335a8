namespace Gjk.Core;

/// <summary>Grows a hull by one point at a time, in any order. Keeps, for every point outside, one face that the point
/// is above.</summary>
/// <remarks>
/// Every face has a list of points strictly above it. The faces strictly below a new point are a connected patch,
/// found by a walk over neighbours. The patch is replaced by the cone from its border (the horizon) to the point. The
/// points in the lists of the patch move to the lists of the cone's faces, or are dropped where no face is below
/// them. Source: C. B. Barber, D. P. Dobkin, H. Huhdanpaa, "The Quickhull Algorithm for Convex Hulls", 1996. They
/// tolerate rounding by merging faces into thick facets. Here every sign is exact (HullPredicates), so nothing needs
/// to be tolerated; coplanar faces stay until <see cref="HullFacets"/> joins them.
///
/// Why it cannot fail. P is the hull so far, p the new point, strictly above at least one face.
/// - The patch is a disk and the horizon a simple cycle: move p towards the inside of P by little enough; it sees the
///   same faces and is in no face's plane, and for such a point the statement is plain.
/// - No new face is degenerate: an edge on the horizon belongs to a face strictly below p, so p is not on its line.
/// - The new surface bounds the hull of P and p, coplanar faces included: where p is in the plane of a hidden face
///   across a horizon edge, it is on the outer side of that edge, and the new triangle extends the facet. Where p is
///   on the edge's line, both faces are hidden and the edge is no horizon.
/// - No outside point is lost. Let q be in the list of the face f of the patch, and let a walk from f visit the faces
///   of the patch that q sees. The normal of a cone's face is a combination of the normals on both sides of its
///   horizon edge, with no negative weight: if q sees both, it sees the cone's face; if it sees the cone's face, it
///   sees one of both. The faces of P that q sees are connected. If one of them is outside the patch, the walk comes
///   to a horizon edge with faces that q sees on both sides. If none is, the walk visits all of them, and so comes to
///   the edge of every face of the cone that q sees.
///
/// Cost. A step takes time in proportion to the faces that it removes and adds, and to the faces that the points of the
/// patch see: a walk visits only faces that its point sees and that are gone after the step. <see cref="QuickHull"/>
/// chooses the order and bounds the sum.
/// Not thread-safe: one per build.
/// </remarks>
internal sealed class HullGrowth
{
    /// <summary>Where a point is listed.</summary>
    private struct Listing
    {
        /// <summary>A face that the point is strictly above, or -1 for a point of the hull.</summary>
        public int Face;

        /// <summary>The next point in the list of that face, or -1.</summary>
        public int Next;
    }

    /// <summary>Faces. A cone of up to this many is searched from end to end, which is faster than a walk. Any number
    /// is correct; it bounds the tests per point and step. Pinned by HullCostTests.</summary>
    private const int ScanLimit = 16;

    /// <summary>In tests that double decides: the time that a determinant and an exact sum take. Measured, to a factor
    /// of two. They only say when the order is changed.</summary>
    private const int DeterminantWork = 8, SumWork = 64;

    private const int None = -1;

    private readonly HullPredicates _predicates;
    private readonly Listing[] _listings;

    /// <summary>By vertex: the face of the cone in the making that starts there.</summary>
    private readonly int[] _coneFaceFrom;
    private readonly List<int> _visible = new();
    private readonly List<int> _cone = new();
    private readonly List<int> _walk = new();
    private readonly HullDeterminant _determinant;
    private readonly long _determinantsBefore, _sumsBefore;
    private long _tests;
    private int _step;
    private int _walks;

    /// <summary>Starts with four points that span space, d strictly below the plane through a, b, c.</summary>
    public HullGrowth(HullPredicates predicates, int a, int b, int c, int d)
    {
        _predicates = predicates;
        _determinant = predicates.Determinant;
        _determinantsBefore = _determinant.Count;
        _sumsBefore = _determinant.SumCount;
        Surface = new HullSurface(predicates);
        int count = predicates.Points.Length;
        _listings = new Listing[count];
        _coneFaceFrom = new int[count];
        MakeTetrahedron(a, b, c, d);
        for (int i = 0; i < count; i++) ListByScan(i);
    }

    public HullSurface Surface { get; }

    /// <summary>The faces that the last step added.</summary>
    public List<int> NewFaces => _cone;

    /// <summary>The work done so far, in tests of a point against a plane. A test counts for more where double could
    /// not tell.</summary>
    public long Work => _tests
        + DeterminantWork * (_determinant.Count - _determinantsBefore)
        + SumWork * (_determinant.SumCount - _sumsBefore);

    /// <summary>True for a point that is neither in the hull nor one of its vertices.</summary>
    public bool IsOutside(int point) => _listings[point].Face != None;

    /// <summary>Makes a vertex of a point that is outside.</summary>
    public void Add(int point)
    {
        _step++;
        FindVisible(point, _listings[point].Face);
        BuildCone(point);
        bool isScanned = _cone.Count <= ScanLimit;
        _listings[point].Face = None;
        foreach (int f in _visible)
        {
            int next;
            for (int q = Surface.Faces[f].FirstAbove; q >= 0; q = next)
            {
                next = _listings[q].Next;
                if (q == point) continue;
                if (isScanned) ListByScan(q);
                else ListByWalk(q, f);
            }
        }

        foreach (int f in _visible) Surface.Remove(f);
    }

    private void MakeTetrahedron(int a, int b, int c, int d)
    {
        _cone.Add(Surface.AddFace(a, b, c));
        _cone.Add(Surface.AddFace(b, a, d));
        _cone.Add(Surface.AddFace(c, b, d));
        _cone.Add(Surface.AddFace(a, c, d));
        for (int h = 0; h < 12; h++)
        {
            for (int t = 0; t < h; t++)
            {
                int endOfH = Surface.Origin(HullSurface.Next(h)), endOfT = Surface.Origin(HullSurface.Next(t));
                if (Surface.Origin(h) == endOfT && Surface.Origin(t) == endOfH) Surface.Link(h, t);
            }
        }
    }

    private void FindVisible(int point, int face)
    {
        HullSurface.Face[] faces = Surface.Faces;
        int[] twins = Surface.Twins;
        _visible.Clear();
        _visible.Add(face);
        faces[face].Stamp = _step;
        for (int i = 0; i < _visible.Count; i++)
        {
            int h = 3 * _visible[i];
            for (int end = h + 3; h < end; h++)
            {
                int neighbor = twins[h] / 3;
                ref HullSurface.Face candidate = ref faces[neighbor];
                if (Math.Abs(candidate.Stamp) == _step) continue;
                _tests++;
                bool isVisible = _predicates.Side(candidate.Plane, point, out _) > 0;
                candidate.Stamp = isVisible ? _step : -_step;
                if (isVisible) _visible.Add(neighbor);
            }
        }
    }

    private void BuildCone(int point)
    {
        _cone.Clear();
        foreach (int f in _visible)
        {
            int h = 3 * f;
            for (int end = h + 3; h < end; h++)
            {
                int outer = Surface.Twin(h);
                if (Surface.Faces[outer / 3].Stamp == _step) continue;
                int start = Surface.Origin(h);
                int face = Surface.AddFace(start, Surface.Origin(HullSurface.Next(h)), point);
                Surface.Link(3 * face, outer);
                _coneFaceFrom[start] = face;
                _cone.Add(face);
            }
        }

        foreach (int face in _cone) Surface.Link(3 * face + 1, 3 * _coneFaceFrom[Surface.Origin(3 * face + 1)] + 2);
    }

    /// <summary>Lists a point with some new face that is strictly below it, if there is one. Walks over the faces of
    /// the patch that the point sees, from one of them to the horizon.</summary>
    private void ListByWalk(int point, int start)
    {
        HullSurface.Face[] faces = Surface.Faces;
        _walks++;
        _walk.Clear();
        _walk.Add(start);
        faces[start].Walk = _walks;
        for (int i = 0; i < _walk.Count; i++)
        {
            int h = 3 * _walk[i];
            for (int end = h + 3; h < end; h++)
            {
                // A half-edge of the patch still has its old twin. The twin of an outer half-edge is the cone's.
                int outer = Surface.Twin(h);
                int face = outer / 3;
                bool isHorizon = faces[face].Stamp != _step;
                if (isHorizon) face = Surface.Twin(outer) / 3;
                if (faces[face].Walk == _walks) continue;
                faces[face].Walk = _walks;
                _tests++;
                if (_predicates.Side(faces[face].Plane, point, out double height) <= 0) continue;
                if (isHorizon)
                {
                    Append(point, face, ref faces[face], height);
                    return;
                }

                _walk.Add(face);
            }
        }

        _listings[point].Face = None;
    }

    /// <summary>Lists a point with the first new face that is strictly below it, if there is one.</summary>
    private void ListByScan(int point)
    {
        HullSurface.Face[] faces = Surface.Faces;
        for (int i = 0; i < _cone.Count; i++)
        {
            int face = _cone[i];
            if (_predicates.Side(faces[face].Plane, point, out double height) <= 0) continue;
            _tests += i + 1;
            Append(point, face, ref faces[face], height);
            return;
        }

        _tests += _cone.Count;
        _listings[point].Face = None;
    }

    private void Append(int point, int index, ref HullSurface.Face face, double height)
    {
        if (face.FirstAbove < 0 || height > face.FurthestHeight)
        {
            face.FurthestHeight = height;
            face.Furthest = point;
        }

        _listings[point] = new Listing { Face = index, Next = face.FirstAbove };
        face.FirstAbove = point;
    }
}
