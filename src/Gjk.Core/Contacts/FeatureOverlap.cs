using System;

namespace Gjk.Core;

/// <summary>
/// What a convex face and another face or edge share, seen along the contact normal: a convex polygon whose sides know
/// which edge they lie on.
/// </summary>
/// <remarks>
/// The one is cut by the edges of the other, one after the other (Sutherland and Hodgman 1974), which is what physics
/// engines make contacts by (Gregorius, "Robust contact creation for physics simulation", GDC 2015). An edge is a
/// polygon of two corners. Each cut adds a corner at most, so there is room for all.
/// </remarks>
internal unsafe ref struct FeatureOverlap
{
    /// <summary>Count: the corners of both, and one that a cut may add before it takes others away.</summary>
    public const int Capacity = 2 * FaceCorners.Capacity + 2;

    /// <summary>Added to the numbers of the edges that cut.</summary>
    private const int Cutter = FaceCorners.Capacity;

    private readonly double _slack;
    private readonly OverlapCorner* _found;
    private CutCorner* _corners, _other;

    /// <param name="memory">Room for <see cref="Capacity"/> corners.</param>
    /// <param name="cuts">Room for twice as many.</param>
    /// <param name="slack">Length: what lies beside an edge by less is not cut off.</param>
    public FeatureOverlap(OverlapCorner* memory, CutCorner* cuts, double slack)
    {
        _found = memory;
        _corners = cuts;
        _other = cuts + Capacity;
        _slack = slack;
        Count = 0;
    }

    /// <summary>How many corners there are; an edge has two, and those that cutting it adds twice.</summary>
    public int Count { get; private set; }

    /// <summary>A corner.</summary>
    public readonly ref OverlapCorner this[int index] => ref _found[index];

    /// <summary>Cuts the one feature by the edges of a face.</summary>
    public void Find(ref FlatFeature cut, ref FlatFeature cutter)
    {
        Count = cut.Count;
        for (int i = 0; i < Count; i++) _corners[i] = new CutCorner { U = cut[i].U, V = cut[i].V, Side = i };
        for (int i = 0; i < cutter.Count && Count > 0; i++) CutBy(ref cutter, i);
        int count = 0;
        for (int i = 0; i < Count; i++)
        {
            int before = _corners[i > 0 ? i - 1 : Count - 1].Side, after = _corners[i].Side;
            ref OverlapCorner corner = ref _found[count];
            corner.U = _corners[i].U;
            corner.V = _corners[i].V;
            corner.Cut = before < Cutter && after < Cutter ? after : -1;
            corner.Cutter = before >= Cutter && after >= Cutter ? Between(before, after, cutter.Count) : -1;
            corner.CutEdge = before < Cutter ? before : after < Cutter ? after : -1;
            corner.CutterEdge = after >= Cutter ? after - Cutter : before >= Cutter ? before - Cutter : -1;
            if (corner.Cutter >= 0)
            {
                corner.U = cutter[corner.Cutter].U;
                corner.V = cutter[corner.Cutter].V;
            }

            // Beyond a tip two edges are nearer than the slack to each other, and what they cross there is not shared,
            // but the tip may be.
            bool isCrossing = corner.CutEdge >= 0 && corner.CutterEdge >= 0;
            bool isShared = !isCrossing || cutter.IsBeside(corner.CutterEdge, corner.U, corner.V, _slack);
            if (isShared || TryMoveToTip(ref corner, ref cut, ref cutter)) count++;
        }

        Count = count;
    }

    /// <summary>Moves a corner to the nearer end of the cutter's edge; false where that is not shared.</summary>
    private readonly bool TryMoveToTip(ref OverlapCorner corner, ref FlatFeature cut, ref FlatFeature cutter)
    {
        int from = corner.CutterEdge, to = from + 1 < cutter.Count ? from + 1 : 0;
        double u = corner.U, v = corner.V;
        int tip = cutter[from].SquaredTo(u, v) <= cutter[to].SquaredTo(u, v) ? from : to;
        corner.U = cutter[tip].U;
        corner.V = cutter[tip].V;
        corner.Cutter = tip;
        corner.CutterEdge = tip;
        corner.CutEdge = -1;
        return cut.Holds(corner.U, corner.V, _slack);
    }

    /// <summary>The corner between two edges of the cutter, either way round.</summary>
    private static int Between(int before, int after, int count)
    {
        int i = before - Cutter, k = after - Cutter;
        return (i + 1) % count == k ? k : i;
    }

    private void CutBy(ref FlatFeature cutter, int edge)
    {
        double* inside = stackalloc double[Capacity];
        ref FlatCorner line = ref cutter[edge];
        double lineU = line.U, lineV = line.V, inwardU = line.InwardU, inwardV = line.InwardV, least = 0;
        CutCorner* corner = _corners;
        int count = Count;
        for (int i = 0; i < count; i++, corner++)
        {
            double depth = inwardU * (corner->U - lineU) + inwardV * (corner->V - lineV);
            inside[i] = depth;
            if (depth < least) least = depth;
        }

        if (least >= -_slack) return;
        count = 0;
        for (int i = 0; i < Count && count + 2 <= Capacity; i++)
        {
            int next = i + 1 < Count ? i + 1 : 0;
            bool isIn = inside[i] >= -_slack;
            if (isIn) _other[count++] = _corners[i];
            if (isIn == inside[next] >= -_slack) continue;
            ref CutCorner p = ref _corners[i], q = ref _corners[next], cut = ref _other[count++];
            double part = Math.Max(0, Math.Min(1, inside[i] / (inside[i] - inside[next])));
            cut.U = p.U + (q.U - p.U) * part;
            cut.V = p.V + (q.V - p.V) * part;
            cut.Side = isIn ? Cutter + edge : p.Side;
        }

        CutCorner* before = _corners;
        _corners = _other;
        _other = before;
        Count = count;
    }
}

/// <summary>A corner while one feature is cut by the other.</summary>
internal struct CutCorner
{
    /// <summary>In the plane across the normal.</summary>
    public double U, V;

    /// <summary>The edge that the side beginning here lies on: one of what is cut, or of the cutter.</summary>
    public int Side;
}

/// <summary>A corner of what two features share.</summary>
internal struct OverlapCorner
{
    /// <summary>In the plane across the normal.</summary>
    public double U, V;

    /// <summary>The corner of the one or of the other that this is; -1 where it is none.</summary>
    public int Cut, Cutter;

    /// <summary>The edges on which it lies; -1 at the other's corner.</summary>
    public int CutEdge, CutterEdge;
}
