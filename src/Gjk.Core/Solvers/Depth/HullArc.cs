namespace Gjk.Core;

/// <summary>The directions across an edge of A, from the normal of a facet beside it to that of the facet on its other
/// side, and the ways out along them.</summary>
/// <remarks>In all of them the furthest point of A is an end of the edge. That of B changes where the arc crosses the
/// directions across an edge of B: there the support's neighbours are as far as it, and the next one is the first to
/// be. Between two changes the way out is the product of a fixed point and a direction that turns, least at one of the
/// two. So the arc is proved by its ends and its changes; whichever points the walk holds, they are points of A and of
/// B, and what it calls the cost of a way out is never more than it is. Where that seems to be the least and supports
/// say that it is more, rounding among level corners has missed a change, and the piece is walked again with the corner
/// that the support gives; or it has missed the arc's end, whose way out is that of a facet.</remarks>
internal struct HullArc
{
    /// <summary>Squared ratio: a corner so near the edge's line does not tell the height of the plane through both to
    /// within <see cref="HullFacet.Slack"/>. The arc is walked from both ends then.</summary>
    private const double NearEdge = 1e-10;

    /// <summary>Where the walk is, and in which direction it goes on, of unit length; in A's axes and in B's.</summary>
    private Double3 _normal, _ahead, _normalInB, _aheadInB;

    /// <summary>The edge's end, seen from B's centre, along both.</summary>
    private double _height, _slope;

    /// <summary>B's furthest corner.</summary>
    private int _id;

    /// <summary>An arc that begins at a facet and crosses the edge from its first corner to its second.</summary>
    /// <param name="facet">Of A.</param>
    /// <param name="normal">Its unit normal.</param>
    /// <param name="frame">Where B is, seen from A.</param>
    /// <param name="id">B's furthest corner against the normal.</param>
    public HullArc(in HullFacet facet, in Double3 normal, in PairFrame frame, int id)
    {
        _normal = normal;
        _ahead = Double3.Cross(facet.Q - facet.P, normal);
        _ahead *= 1 / _ahead.Length;
        _normalInB = frame.Rotation.InverseRotate(_normal);
        _aheadInB = frame.Rotation.InverseRotate(_ahead);
        _height = Double3.Dot(facet.P - frame.Translation, _normal);
        _slope = Double3.Dot(facet.P - frame.Translation, _ahead);
        _id = id;
    }

    /// <summary>Walks as far as ways out may be short, if the arc's lower end is this one.</summary>
    /// <returns>False when the probes are spent, or a way out on the arc is not what the walk took it for.</returns>
    public bool TryWalk<TA, TB>(
        in HullFacet facet, ref TA a, ref TB b, in PairFrame frame, in PairForm form, ref FacetSearch search)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        ArcAngle end = FindEnd(facet, ref a, form.A, out bool isCertain);
        double slack = HullFacet.Slack * (Math.Abs(_height) + Math.Abs(_slope));
        if (isCertain && end.DotAt(_height, _slope) < _height - slack) return true;
        b.TryGetVertex(_id, out Double3 onB);
        while (true)
        {
            double atEnd = end.DotAt(_height, _slope)
                - end.DotAt(Double3.Dot(onB, _normalInB), Double3.Dot(onB, _aheadInB));
            if (atEnd >= search.Limit) return true;
            ArcAngle turn = end;
            int next = FindChange(ref b, form.B, onB, ref turn);
            HullArc before = this;
            ArcAngle left = end;
            Go(turn, ref end);
            while (!search.TryProbe(ref a, ref b, frame, _normal, _height - Double3.Dot(onB, _normalInB)))
            {
                if (IsBeyond(ref a, frame, search.Noise)) return true;
                next = b.Support(-_normalInB, out Double3 further);
                this = before;
                end = left;
                if (search.AreSpent || next == _id) return false;

                // Where that corner was the furthest already, the piece is walked with it from its beginning.
                if (!TryShorten(further - onB, ref turn)) break;
                turn.Normalize();
                Go(turn, ref end);
            }

            if (next < 0 || IsHigh(end, search.Limit - search.InnerB)) return true;
            _id = next;
            b.TryGetVertex(_id, out onB);
        }
    }

    /// <summary>Whether the walk has passed the arc's end: a corner of A is further than the edge.</summary>
    private readonly bool IsBeyond<TA>(ref TA a, in PairFrame frame, double noise)
        where TA : struct, ISupportMap
    {
        a.Support(_normal, out Double3 onA);
        return Double3.Dot(_normal, onA - frame.Translation) - _height > noise;
    }

    private readonly bool TryShorten(in Double3 fromB, ref ArcAngle turn) =>
        turn.TryShorten(Double3.Dot(fromB, _normalInB), Double3.Dot(fromB, _aheadInB));

    /// <summary>Whether all that is left of the arc is high: between its ends it is as high as the lower one.</summary>
    private readonly bool IsHigh(in ArcAngle end, double height) =>
        _height > 0 && Math.Min(_height, end.DotAt(_height, _slope)) >= Math.Max(height, 0);

    /// <summary>How far to turn until another corner of A, that is not on the edge's line, is as far.</summary>
    private readonly ArcAngle FindEnd<TA>(in HullFacet facet, ref TA a, in BodyForm form, out bool isCertain)
        where TA : struct, ISupportMap
    {
        int[] starts = form.Hull!.NeighborStart, neighbors = form.Hull.Neighbors;
        ArcAngle end = ArcAngle.Half;
        double squared = 0, onLine = facet.LineSquared;
        bool isClear = true;
        for (int k = starts[facet.IdP]; k < starts[facet.IdP + 1]; k++)
        {
            if (neighbors[k] == facet.IdQ) continue;
            a.TryGetVertex(neighbors[k], out Double3 corner);
            Double3 toEdge = facet.P - corner;
            double here = Double3.Dot(toEdge, _normal), ahead = Double3.Dot(toEdge, _ahead);
            if (here * here + ahead * ahead <= onLine) isClear = false;
            else if (end.TryShorten(here, ahead)) squared = toEdge.LengthSquared;
        }

        isCertain = isClear && end.SizeSquared > NearEdge * squared;
        end.Normalize();
        return end;
    }

    /// <summary>How far to turn until another corner of B is as far as the one that is furthest.</summary>
    private readonly int FindChange<TB>(ref TB b, in BodyForm form, in Double3 onB, ref ArcAngle turn)
        where TB : struct, ISupportMap
    {
        int[] starts = form.Hull!.NeighborStart, neighbors = form.Hull.Neighbors;
        int next = -1;
        for (int k = starts[_id]; k < starts[_id + 1]; k++)
        {
            b.TryGetVertex(neighbors[k], out Double3 corner);
            Double3 fromB = corner - onB;
            if (TryShorten(fromB, ref turn)) next = neighbors[k];
        }

        turn.Normalize();
        return next;
    }

    private void Go(in ArcAngle turn, ref ArcAngle end)
    {
        (_normal, _ahead) = (_normal * turn.Cosine + _ahead * turn.Sine, _ahead * turn.Cosine - _normal * turn.Sine);
        (_normalInB, _aheadInB) = (
            _normalInB * turn.Cosine + _aheadInB * turn.Sine, _aheadInB * turn.Cosine - _normalInB * turn.Sine);
        (_height, _slope) = (turn.DotAt(_height, _slope), _slope * turn.Cosine - _height * turn.Sine);
        end.Subtract(turn);
    }
}

/// <summary>An angle between 0 and half a turn, by its cosine and sine.</summary>
internal struct ArcAngle
{
    /// <summary>Times any length.</summary>
    public double Cosine, Sine;

    /// <summary>Half a turn, less so little that double does not tell it from half a turn.</summary>
    public static ArcAngle Half => new() { Cosine = -1, Sine = 1e-100 };

    /// <summary>The squared length that they are multiplied by.</summary>
    public readonly double SizeSquared => Cosine * Cosine + Sine * Sine;

    /// <summary>Of two products with directions a quarter turn apart, that with the direction between them.</summary>
    public readonly double DotAt(double here, double ahead) => here * Cosine + ahead * Sine;

    /// <summary>Shortens it to where a product falls to 0, that is not below 0 here, if that is sooner.</summary>
    /// <param name="here">The product now; rounding may have made it less than 0.</param>
    /// <param name="ahead">The product a quarter turn ahead.</param>
    public bool TryShorten(double here, double ahead)
    {
        double sine = Math.Max(here, 0);

        // What is 0 here and grows falls to 0 again after half a turn only; what is above 0 falls before that.
        if (!((ahead < 0 || sine > 0) && -ahead * Sine > Cosine * sine)) return false;
        Cosine = -ahead;
        Sine = sine;
        return true;
    }

    /// <summary>Brings cosine and sine to their lengths.</summary>
    public void Normalize()
    {
        double scale = 1 / Math.Sqrt(SizeSquared);
        Cosine *= scale;
        Sine *= scale;
    }

    /// <summary>Takes another angle away that is not larger.</summary>
    public void Subtract(in ArcAngle turn) =>
        (Cosine, Sine) = (Cosine * turn.Cosine + Sine * turn.Sine, Sine * turn.Cosine - Cosine * turn.Sine);
}
