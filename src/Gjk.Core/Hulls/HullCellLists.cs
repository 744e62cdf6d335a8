using System;
using System.Collections.Generic;

namespace Gjk.Core;

/// <summary>Builds the lists of <see cref="HullCells"/>: for each cell of the direction cube the corners whose normal cones reach into it.</summary>
internal sealed class HullCellLists
{
    private readonly ConvexHull _hull;
    private readonly Vector3D _stretch;
    private readonly double _widening;
    private readonly double _slack;
    private readonly int[] _seenIn;
    private readonly List<int> _entries = [];
    private readonly List<int> _ends = [];
    private readonly Stack<int> _open = new();
    private double[] _polygon = new double[16], _clipped = new double[16];

    public HullCellLists(ConvexHull hull, in Vector3D stretch, double widening, double slack)
    {
        _hull = hull;
        _stretch = stretch;
        _widening = widening;
        _slack = slack;
        _seenIn = new int[hull.VertexCount];
    }

    public int CellCount => _ends.Count;

    /// <summary>An entry of a cell's list; entries ascend.</summary>
    public int this[int cell, int index] => _entries[(cell == 0 ? 0 : _ends[cell - 1]) + index];

    public int Length(int cell) => _ends[cell] - (cell == 0 ? 0 : _ends[cell - 1]);

    /// <summary>One list of all corners.</summary>
    public void CollectAll()
    {
        _entries.Clear();
        _ends.Clear();
        for (int i = 0; i < _hull.VertexCount; i++) _entries.Add(i);
        _ends.Add(_entries.Count);
    }

    /// <summary>The lists of 6 side² cells; false when they would hold more than the given number of entries.</summary>
    public bool TryCollect(int side, int maxEntries)
    {
        _entries.Clear();
        _ends.Clear();
        Array.Clear(_seenIn, 0, _seenIn.Length);
        int furthest = 0;
        for (int face = 0; face < 6; face++)
        {
            for (int row = 0; row < side; row++)
            {
                for (int column = 0; column < side; column++)
                {
                    double u = (2.0 * column + 1) / side - 1, v = (2.0 * row + 1) / side - 1, half = (1 + _widening) / side;
                    furthest = Climb(Direction(face, u, v), furthest);
                    CollectCell(face, u, v, half, furthest);
                    if (_entries.Count > maxEntries) return false;
                }
            }
        }

        return true;
    }

    /// <summary>Face 2 axis + (0 for +, 1 for -); u and v are the other two coordinates in the order of the axes.</summary>
    private static Vector3D Direction(int face, double u, double v)
    {
        double w = (face & 1) == 0 ? 1 : -1;
        return (face >> 1) switch
        {
            0 => new Vector3D(w, u, v),
            1 => new Vector3D(u, w, v),
            _ => new Vector3D(u, v, w),
        };
    }

    /// <summary>A corner's offset from another in units of the extents, where a flat hull's missing axis is left out.</summary>
    private Vector3D Offset(int from, int to)
    {
        _hull.GetVertex(from, out Vector3D p);
        _hull.GetVertex(to, out Vector3D q);
        return new Vector3D(Ratio(q.X - p.X, _stretch.X), Ratio(q.Y - p.Y, _stretch.Y), Ratio(q.Z - p.Z, _stretch.Z));
    }

    private static double Ratio(double length, double unit) => unit > 0 ? length / unit : 0;

    private int Climb(in Vector3D direction, int from)
    {
        while (true)
        {
            int next = from;
            double best = 0;
            for (int k = _hull.NeighborStart[from]; k < _hull.NeighborStart[from + 1]; k++)
            {
                double rise = Vector3D.Dot(direction, Offset(from, _hull.Neighbors[k]));
                if (!(rise > best)) continue;
                best = rise;
                next = _hull.Neighbors[k];
            }

            // A rise of no more than the slack is rounding; following it could go round in circles, and the cell's walk crosses it anyway.
            if (best <= _slack) return from;
            from = next;
        }
    }

    private void CollectCell(int face, double u, double v, double half, int first)
    {
        int begin = _entries.Count, stamp = _ends.Count + 1;
        _open.Push(first);
        _seenIn[first] = stamp;
        while (_open.Count > 0)
        {
            int corner = _open.Pop();
            if (corner != first && !Reaches(corner, face, u, v, half)) continue;
            _entries.Add(corner);
            for (int k = _hull.NeighborStart[corner]; k < _hull.NeighborStart[corner + 1]; k++)
            {
                int neighbor = _hull.Neighbors[k];
                if (_seenIn[neighbor] == stamp) continue;
                _seenIn[neighbor] = stamp;
                _open.Push(neighbor);
            }
        }

        _entries.Sort(begin, _entries.Count - begin, null);
        _ends.Add(_entries.Count);
    }

    /// <summary>Some direction of the cell has no neighbour of the corner more than the slack above it: the square, clipped by each neighbour's half plane, is not empty.</summary>
    private bool Reaches(int corner, int face, double u, double v, double half)
    {
        int from = _hull.NeighborStart[corner], to = _hull.NeighborStart[corner + 1];
        int room = 2 * (4 + to - from);
        if (_polygon.Length < room) (_polygon, _clipped) = (new double[2 * room], new double[2 * room]);
        _polygon[0] = _polygon[6] = u - half;
        _polygon[2] = _polygon[4] = u + half;
        _polygon[1] = _polygon[3] = v - half;
        _polygon[5] = _polygon[7] = v + half;
        int count = 4;
        for (int k = from; k < to && count > 0; k++)
        {
            Vector3D o = Offset(corner, _hull.Neighbors[k]);
            double w = (face & 1) == 0 ? 1 : -1;
            count = (face >> 1) switch
            {
                0 => Clip(count, o.Y, o.Z, w * o.X),
                1 => Clip(count, o.X, o.Z, w * o.Y),
                _ => Clip(count, o.X, o.Y, w * o.Z),
            };
        }

        return count > 0;
    }

    /// <summary>Keeps the part of the polygon with p u + q v + r &lt;= slack (Sutherland and Hodgman 1974).</summary>
    private int Clip(int count, double p, double q, double r)
    {
        int kept = 0;
        double u0 = _polygon[2 * count - 2], v0 = _polygon[2 * count - 1], d0 = p * u0 + q * v0 + r - _slack;
        for (int i = 0; i < count; i++)
        {
            double u1 = _polygon[2 * i], v1 = _polygon[2 * i + 1], d1 = p * u1 + q * v1 + r - _slack;
            if (d0 <= 0 != d1 <= 0)
            {
                double t = d0 / (d0 - d1);
                _clipped[2 * kept] = u0 + t * (u1 - u0);
                _clipped[2 * kept++ + 1] = v0 + t * (v1 - v0);
            }

            if (d1 <= 0)
            {
                _clipped[2 * kept] = u1;
                _clipped[2 * kept++ + 1] = v1;
            }

            (u0, v0, d0) = (u1, v1, d1);
        }

        (_polygon, _clipped) = (_clipped, _polygon);
        return kept;
    }
}
