using System;

namespace Gjk.Core;

/// <summary>
/// A face or an edge seen along a contact normal: its corners in the plane across the normal, and their heights.
/// </summary>
internal unsafe struct FlatFeature
{
    /// <summary>How many corners there are: two are an edge, more a face.</summary>
    public readonly int Count;

    private readonly FlatCorner* _corners;

    /// <summary>The length of an edge that stands alone.</summary>
    private readonly double _length;

    /// <summary>How fast a face rises along the plane's axes.</summary>
    private double _riseU, _riseV;

    /// <param name="memory">The corners; what they know of their edges is filled in.</param>
    /// <param name="count">How many there are; at least 2.</param>
    public FlatFeature(FlatCorner* memory, int count)
    {
        _corners = memory;
        Count = count;
        _length = 0;
        _riseU = 0;
        _riseV = 0;
        double turn = count > 2 ? Tilt() : 1;
        for (int i = 0; i < EdgeCount; i++)
        {
            ref FlatCorner p = ref _corners[i], q = ref After(i);
            double u = q.U - p.U, v = q.V - p.V;
            _length = Math.Sqrt(u * u + v * v);
            p.InwardU = -v * turn / _length;
            p.InwardV = u * turn / _length;
        }

        double rise = count > 2
            ? Math.Sqrt(_riseU * _riseU + _riseV * _riseV)
            : Math.Abs(_corners[1].Height - _corners[0].Height) / _length;
        IsLevel = rise <= FaceTilt.MostRise;
    }

    /// <summary>
    /// Whether it lies level enough for its heights to say something; a shape that is scaled unevenly may show another.
    /// </summary>
    public readonly bool IsLevel;

    /// <summary>A corner.</summary>
    public readonly ref FlatCorner this[int index] => ref _corners[index];

    /// <summary>The corner after another.</summary>
    public readonly ref FlatCorner After(int index) => ref _corners[index + 1 < Count ? index + 1 : 0];

    /// <summary>How many edges there are; each begins at the corner of its number.</summary>
    public readonly int EdgeCount => Count > 2 ? Count : 1;

    /// <summary>Writes how far a place lies on the inner side of each edge.</summary>
    /// <returns>
    /// Whether the place is in the face or on the edge, or beside it by no more than a slack; not for NaN.
    /// </returns>
    public readonly bool Holds(in FlatCorner place, double slack, double* inside)
    {
        bool holds = true;
        for (int i = 0; i < EdgeCount; i++)
        {
            ref FlatCorner p = ref _corners[i];
            inside[i] = p.InwardU * (place.U - p.U) + p.InwardV * (place.V - p.V);
            holds &= inside[i] >= -slack;
        }

        if (Count > 2 || !holds) return holds;
        double along = Along(place);
        return inside[0] <= slack && along >= -slack && along <= _length + slack;
    }

    /// <summary>The height of the face or edge at a place.</summary>
    public readonly double HeightAt(in FlatCorner place)
    {
        ref FlatCorner p = ref _corners[0];
        if (Count > 2) return p.Height + _riseU * (place.U - p.U) + _riseV * (place.V - p.V);
        return p.Height + (_corners[1].Height - p.Height) * Math.Max(0, Math.Min(1, Along(place) / _length));
    }

    /// <summary>How far along an edge a place lies, from its beginning.</summary>
    private readonly double Along(in FlatCorner place)
    {
        ref FlatCorner p = ref _corners[0];
        return p.InwardV * (place.U - p.U) - p.InwardU * (place.V - p.V);
    }

    /// <summary>
    /// Finds the plane through a face's corners, by the areas of its projections (Newell); returns 1 where they run
    /// counter-clockwise, else -1.
    /// </summary>
    private int Tilt()
    {
        double u = 0, v = 0, h = 0;
        ref FlatCorner o = ref _corners[0];
        for (int i = 1; i + 1 < Count; i++)
        {
            ref FlatCorner p = ref _corners[i], q = ref _corners[i + 1];
            double pu = p.U - o.U, pv = p.V - o.V, ph = p.Height - o.Height;
            double qu = q.U - o.U, qv = q.V - o.V, qh = q.Height - o.Height;
            u += pv * qh - ph * qv;
            v += ph * qu - pu * qh;
            h += pu * qv - pv * qu;
        }

        _riseU = -u / h;
        _riseV = -v / h;
        return h < 0 ? -1 : 1;
    }
}

/// <summary>A corner of a flat feature, or a place beside it.</summary>
internal struct FlatCorner
{
    /// <summary>Along the plane's axes, and along the normal.</summary>
    public double U, V, Height;

    /// <summary>Across the edge that begins here, of unit length, to the inner side.</summary>
    public double InwardU, InwardV;

    /// <summary>What tells it from the feature's others.</summary>
    public int Id;
}
