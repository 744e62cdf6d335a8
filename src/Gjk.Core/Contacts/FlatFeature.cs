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

    /// <summary>1 where the corners run counter-clockwise, else -1.</summary>
    private double _turn;

    /// <summary>How fast a face rises along the plane's axes, and its height at the first corner.</summary>
    private double _riseU, _riseV;

    /// <param name="memory">Filled with the corners.</param>
    /// <param name="count">How many there are; at least 2.</param>
    public FlatFeature(FlatCorner* memory, int count)
    {
        _corners = memory;
        Count = count;
        _turn = 1;
        _riseU = 0;
        _riseV = 0;
        if (count > 2) Tilt();
    }

    /// <summary>A corner.</summary>
    public readonly ref FlatCorner this[int index] => ref _corners[index];

    /// <summary>The corner after another.</summary>
    public readonly ref FlatCorner After(int index) => ref _corners[index + 1 < Count ? index + 1 : 0];

    /// <summary>How many edges there are.</summary>
    public readonly int EdgeCount => Count > 2 ? Count : 1;

    /// <summary>How far a place lies on the inner side of an edge, times the edge's length.</summary>
    public readonly double Inside(int edge, in FlatCorner place)
    {
        ref FlatCorner p = ref _corners[edge], q = ref After(edge);
        return _turn * ((q.U - p.U) * (place.V - p.V) - (q.V - p.V) * (place.U - p.U));
    }

    /// <summary>Whether a place lies in the face or on the edge, or beside it by no more than a slack.</summary>
    public readonly bool Holds(in FlatCorner place, double slack)
    {
        for (int i = 0; i < EdgeCount; i++)
        {
            double inside = Inside(i, place), reach = slack * LengthOf(i);
            if (!(inside >= -reach) || (Count == 2 && inside > reach)) return false;
        }

        if (Count > 2) return true;
        double part = PartOf(place), most = slack / LengthOf(0);
        return part >= -most && part <= 1 + most;
    }

    /// <summary>The height of the face or edge at a place.</summary>
    public readonly double HeightAt(in FlatCorner place)
    {
        ref FlatCorner p = ref _corners[0];
        if (Count > 2) return p.Height + _riseU * (place.U - p.U) + _riseV * (place.V - p.V);
        return p.Height + (_corners[1].Height - p.Height) * Math.Max(0, Math.Min(1, PartOf(place)));
    }

    /// <summary>How far along an edge a place lies: 0 at its beginning, 1 at its end.</summary>
    private readonly double PartOf(in FlatCorner place)
    {
        ref FlatCorner p = ref _corners[0], q = ref _corners[1];
        double u = q.U - p.U, v = q.V - p.V;
        return ((place.U - p.U) * u + (place.V - p.V) * v) / (u * u + v * v);
    }

    private readonly double LengthOf(int edge)
    {
        ref FlatCorner p = ref _corners[edge], q = ref After(edge);
        return Math.Sqrt((q.U - p.U) * (q.U - p.U) + (q.V - p.V) * (q.V - p.V));
    }

    /// <summary>The plane through a face's corners, by the areas of its projections (Newell).</summary>
    private void Tilt()
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

        _turn = h < 0 ? -1 : 1;
        _riseU = -u / h;
        _riseV = -v / h;
    }
}

/// <summary>A corner of a flat feature, or a place beside it.</summary>
internal struct FlatCorner
{
    /// <summary>Along the plane's axes, and along the normal.</summary>
    public double U, V, Height;

    /// <summary>What tells it from the feature's others.</summary>
    public int Id;
}
