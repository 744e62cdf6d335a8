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
    private OverlapCorner* _corners, _other;

    /// <param name="memory">Room for twice <see cref="Capacity"/> corners.</param>
    /// <param name="slack">Length: what lies beside an edge by less is not cut off.</param>
    public FeatureOverlap(OverlapCorner* memory, double slack)
    {
        _corners = memory;
        _other = memory + Capacity;
        _slack = slack;
        Count = 0;
    }

    /// <summary>How many corners there are; an edge has two, and those that cutting it adds twice.</summary>
    public int Count { get; private set; }

    /// <summary>A corner.</summary>
    public readonly ref OverlapCorner this[int index] => ref _corners[index];

    /// <summary>Cuts the one feature by the edges of a face.</summary>
    public void Find(ref FlatFeature cut, ref FlatFeature cutter)
    {
        Count = cut.Count;
        for (int i = 0; i < Count; i++) _corners[i] = new OverlapCorner { U = cut[i].U, V = cut[i].V, Side = i };
        for (int i = 0; i < cutter.Count && Count > 0; i++) CutBy(ref cutter, i);
        for (int i = 0; i < Count; i++) _other[i].Side = _corners[i > 0 ? i - 1 : Count - 1].Side;
        int count = 0;
        for (int i = 0; i < Count; i++)
        {
            OverlapCorner corner = _corners[i];
            int before = _other[i].Side, after = corner.Side;
            corner.Cut = before < Cutter && after < Cutter ? after : -1;
            corner.Cutter = before >= Cutter && after >= Cutter ? Between(before, after, cutter.Count) : -1;
            corner.CutEdge = before < Cutter ? before : after < Cutter ? after : -1;
            corner.CutterEdge = after >= Cutter ? after - Cutter : before >= Cutter ? before - Cutter : -1;
            if (corner.Cutter >= 0)
            {
                corner.U = cutter[corner.Cutter].U;
                corner.V = cutter[corner.Cutter].V;
            }

            // Beyond a tip two edges are nearer than the slack to each other, and what they cross there is not shared.
            bool isCrossing = corner.CutEdge >= 0 && corner.CutterEdge >= 0;
            if (!isCrossing || cutter.IsBeside(corner.CutterEdge, corner.U, corner.V, _slack))
                _corners[count++] = corner;
        }

        Count = count;
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
        bool isWhole = true;
        for (int i = 0; i < Count; i++)
        {
            inside[i] = cutter.Inside(edge, _corners[i].U, _corners[i].V);
            isWhole &= inside[i] >= -_slack;
        }

        if (isWhole) return;
        int count = 0;
        for (int i = 0; i < Count && count + 2 <= Capacity; i++)
        {
            int next = i + 1 < Count ? i + 1 : 0;
            bool isIn = inside[i] >= -_slack;
            if (isIn) _other[count++] = _corners[i];
            if (isIn == inside[next] >= -_slack) continue;
            ref OverlapCorner p = ref _corners[i], q = ref _corners[next], cut = ref _other[count++];
            double part = Math.Max(0, Math.Min(1, inside[i] / (inside[i] - inside[next])));
            cut.U = p.U + (q.U - p.U) * part;
            cut.V = p.V + (q.V - p.V) * part;
            cut.Side = isIn ? Cutter + edge : p.Side;
        }

        OverlapCorner* before = _corners;
        _corners = _other;
        _other = before;
        Count = count;
    }
}

/// <summary>A corner of what two features share.</summary>
internal struct OverlapCorner
{
    /// <summary>In the plane across the normal.</summary>
    public double U, V;

    /// <summary>The edge that the side beginning here lies on: one of what is cut, or of the cutter.</summary>
    public int Side;

    /// <summary>The corner of the one or of the other that this is; -1 where it is none.</summary>
    public int Cut, Cutter;

    /// <summary>The edges on which it lies; -1 at the other's corner.</summary>
    public int CutEdge, CutterEdge;
}
