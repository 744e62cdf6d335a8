using System;
using System.Collections.Generic;
using System.Runtime.CompilerServices;

namespace Gjk.Core;

/// <summary>
/// Quickhull in three dimensions: a tetrahedron grows by one point at a time until nothing lies outside.
/// </summary>
/// <remarks>
/// Idea. Every face keeps a list of points strictly above it. Take a face with a list and the point of it that is furthest away; the faces strictly below that point
/// are a connected patch, found by a walk over neighbours; the patch is replaced by the cone from its border (the horizon) to the point, and the points listed with the patch are
/// listed with faces of the cone, or dropped where none is below them.
/// Source: C. B. Barber, D. P. Dobkin, H. Huhdanpaa, "The Quickhull Algorithm for Convex Hulls", 1996. Theirs tolerates rounding by merging faces into thick facets; here
/// every sign is exact (HullPredicates), so that nothing needs to be tolerated, and coplanar faces stay until <see cref="HullFacets"/> joins them.
///
/// Why it cannot fail. P is the hull so far, p the point, strictly above at least one face.
/// - The patch is a disk and the horizon a simple cycle: moved towards the inside of P by little enough, p sees the same faces and is in no face's plane, and from such
///   a point the statement is plain.
/// - No new face is degenerate: an edge on the horizon belongs to a face strictly below p, so that p is not on the edge's line.
/// - The new surface bounds the hull of P and p, coplanar faces included: where p is in the plane of a hidden face across a horizon edge, it is on the outer side
///   of that edge, and the new triangle extends the facet. Where p is on the edge's line, both faces are hidden and the edge is no horizon.
/// - No outside point is lost: let q be listed with a face of the patch. The faces that q sees are connected. Either all of them are in the patch; or some
///   horizon edge lies between two of them, and the cone's face there, whose normal is a combination of theirs with no negative weight, is below q too.
/// Why it ends. Each step turns one listed point into a vertex, and no point is listed again once it has been a vertex or dropped.
/// </remarks>
internal sealed class QuickHull
{
    private struct Face
    {
        public HullPlane Plane;

        /// <summary>The largest height seen in the list; which point is taken is a matter of speed, so a rounded one will do.</summary>
        public double FurthestHeight;

        /// <summary>Head of the list of points above, -1 when empty.</summary>
        public int FirstAbove;
        public int Furthest;

        /// <summary>The number of the step in which the face was last looked at; negative when it was found hidden.</summary>
        public int Stamp;
    }

    private const int Dead = -1;

    /// <summary>
    /// Oldest face first while fewer than this are pending, newest first when there are more. Breadth keeps the hull evenly refined: depth alone would finish one rim of
    /// a cylinder before the other, with vertices that neighbour a whole rim, and take quadratic time. Depth keeps to memory that is in the cache: on a sphere of
    /// 10^6 points it halves the time. Any number is correct.
    /// </summary>
    private const int BreadthFirstFaces = 4096;

    private readonly HullPredicates _predicates;
    private readonly int[] _nextAbove;

    /// <summary>By vertex: the face of the cone in the making that starts there.</summary>
    private readonly int[] _coneFaceFrom;
    private readonly List<int> _pending = new();
    private readonly List<int> _visible = new();
    private readonly List<int> _cone = new();
    private readonly List<int> _free = new();

    // Half-edge 3 f + e is edge e of face f, from _origin[3 f + e] to the next origin of the face.
    private Face[] _faces = new Face[64];
    private int[] _origin = new int[3 * 64];
    private int[] _twin = new int[3 * 64];
    private int _faceCount;
    private int _pendingStart;
    private int _step;

    public QuickHull(HullPredicates predicates)
    {
        _predicates = predicates;
        _nextAbove = new int[predicates.Points.Length];
        _coneFaceFrom = new int[predicates.Points.Length];
    }

    /// <summary>Half-edges are numbered from 0 up to this; some belong to no face.</summary>
    public int HalfEdgeLimit => 3 * _faceCount;

    public static int Next(int halfEdge) => halfEdge % 3 == 2 ? halfEdge - 2 : halfEdge + 1;

    public bool IsAlive(int halfEdge) => _origin[halfEdge] != Dead;

    public int Origin(int halfEdge) => _origin[halfEdge];

    public int Twin(int halfEdge) => _twin[halfEdge];

    /// <summary>True when the faces on both sides of the edge lie in one plane.</summary>
    public bool IsFlat(int halfEdge)
    {
        int apex = _origin[Next(Next(_twin[halfEdge]))];
        return _predicates.Side(_faces[halfEdge / 3].Plane, apex, out _) == 0;
    }

    /// <summary>Builds the hull from four points that are not in one plane, d strictly below the plane through a, b, c.</summary>
    public void Run(int a, int b, int c, int d)
    {
        MakeTetrahedron(a, b, c, d);
        for (int i = 0; i < _nextAbove.Length; i++) ListAbove(i);
        AppendPending();
        while (_pending.Count > _pendingStart)
        {
            // A face that has died since, or has been used again and emptied, has nothing above it.
            int face = TakePending();
            if (_faces[face].FirstAbove >= 0) AddVertex(_faces[face].Furthest, face);
        }
    }

    private void MakeTetrahedron(int a, int b, int c, int d)
    {
        _cone.Add(NewFace(a, b, c));
        _cone.Add(NewFace(b, a, d));
        _cone.Add(NewFace(c, b, d));
        _cone.Add(NewFace(a, c, d));
        for (int h = 0; h < 12; h++)
        {
            for (int t = 0; t < h; t++)
            {
                if (_origin[h] == _origin[Next(t)] && _origin[t] == _origin[Next(h)]) Link(h, t);
            }
        }
    }

    private void AddVertex(int point, int face)
    {
        _step++;
        FindVisible(point, face);
        BuildCone(point);
        foreach (int f in _visible)
        {
            int next;
            for (int q = _faces[f].FirstAbove; q >= 0; q = next)
            {
                next = _nextAbove[q];
                if (q != point) ListAbove(q);
            }

            Release(f);
        }

        AppendPending();
    }

    private void FindVisible(int point, int face)
    {
        _visible.Clear();
        _visible.Add(face);
        _faces[face].Stamp = _step;
        for (int i = 0; i < _visible.Count; i++)
        {
            int h = 3 * _visible[i];
            for (int end = h + 3; h < end; h++)
            {
                int neighbor = _twin[h] / 3;
                ref Face candidate = ref _faces[neighbor];
                if (Math.Abs(candidate.Stamp) == _step) continue;
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
                int outer = _twin[h];
                if (_faces[outer / 3].Stamp == _step) continue;
                int start = _origin[h];
                int face = NewFace(start, _origin[Next(h)], point);
                Link(3 * face, outer);
                _coneFaceFrom[start] = face;
                _cone.Add(face);
            }
        }

        foreach (int face in _cone) Link(3 * face + 1, 3 * _coneFaceFrom[_origin[3 * face + 1]] + 2);
    }

    /// <summary>Lists a point with the first new face that is strictly below it, if there is one.</summary>
    private void ListAbove(int point)
    {
        for (int i = 0; i < _cone.Count; i++)
        {
            ref Face face = ref _faces[_cone[i]];
            if (_predicates.Side(face.Plane, point, out double height) <= 0) continue;
            if (face.FirstAbove < 0 || height > face.FurthestHeight)
            {
                face.FurthestHeight = height;
                face.Furthest = point;
            }

            _nextAbove[point] = face.FirstAbove;
            face.FirstAbove = point;
            return;
        }
    }

    private void AppendPending()
    {
        foreach (int face in _cone)
        {
            if (_faces[face].FirstAbove >= 0) _pending.Add(face);
        }
    }

    private int TakePending()
    {
        if (_pending.Count - _pendingStart < BreadthFirstFaces) return _pending[_pendingStart++];
        int face = _pending[_pending.Count - 1];
        _pending.RemoveAt(_pending.Count - 1);
        return face;
    }

    private int NewFace(int a, int b, int c)
    {
        int face;
        if (_free.Count > 0)
        {
            face = _free[_free.Count - 1];
            _free.RemoveAt(_free.Count - 1);
        }
        else
        {
            face = _faceCount++;
            if (face == _faces.Length)
            {
                Array.Resize(ref _faces, 2 * face);
                Array.Resize(ref _origin, 6 * face);
                Array.Resize(ref _twin, 6 * face);
            }
        }

        _faces[face] = new Face { Plane = _predicates.PlaneThrough(a, b, c), FirstAbove = -1 };
        _origin[3 * face] = a;
        _origin[3 * face + 1] = b;
        _origin[3 * face + 2] = c;
        return face;
    }

    private void Release(int face)
    {
        _faces[face].FirstAbove = -1;
        _origin[3 * face] = _origin[3 * face + 1] = _origin[3 * face + 2] = Dead;
        _free.Add(face);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void Link(int halfEdge, int other)
    {
        _twin[halfEdge] = other;
        _twin[other] = halfEdge;
    }
}
