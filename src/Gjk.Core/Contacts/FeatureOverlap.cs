namespace Gjk.Core;

/// <summary>What a convex face and another face or edge share, seen along the contact normal: a convex polygon whose
/// sides know which edge they lie on.</summary>
/// <remarks>The one is cut by the edges of the other, one after the other (Sutherland and Hodgman 1974), which is what
/// physics engines make contacts by (Gregorius, "Robust contact creation for physics simulation", GDC 2015). An edge is
/// a polygon of two corners. Each cut adds a corner at most, so there is room for all.</remarks>
internal static unsafe class FeatureOverlap
{
    /// <summary>Count: the corners of both, and one that a cut may add before it takes others away.</summary>
    public const int Capacity = 2 * FaceCorners.Capacity + 2;

    /// <summary>Added to the numbers of the edges that cut.</summary>
    private const int Cutter = FaceCorners.Capacity;

    /// <summary>Cuts the one feature by the edges of a face.</summary>
    /// <param name="cut">What is cut.</param>
    /// <param name="cutter">The face.</param>
    /// <param name="isACut">Whether the one that is cut is A's.</param>
    /// <param name="slack">Length: what lies beside an edge by less is not cut off.</param>
    /// <param name="places">Gets the corners, of which an edge has two, and those that cutting it adds twice; room for
    /// <see cref="Capacity"/>.</param>
    /// <returns>How many there are.</returns>
    public static int Find(ref FlatFeature cut, ref FlatFeature cutter, bool isACut, double slack, ContactPlace* places)
    {
        CutCorner* memory = stackalloc CutCorner[2 * Capacity];
        CutCorner* corners = memory, other = memory + Capacity;
        int sides = cut.Count, cutterSides = cutter.Count, found = 0;
        double middleU = 0.5 * (cut[0].U + cut[sides / 2].U), middleV = 0.5 * (cut[0].V + cut[sides / 2].V);
        double squared = 0;
        for (int i = 0; i < sides; i++)
        {
            corners[i] = new CutCorner { U = cut[i].U, V = cut[i].V, Side = i };
            squared = Math.Max(squared, cut[i].SquaredTo(middleU, middleV));
        }

        // Rounding is far below the slack, so no corner is cut off by an edge that leaves the circle around all alone.
        double radius = Math.Sqrt(squared);
        for (int i = 0; i < cutterSides && sides > 0; i++)
        {
            if (cutter.Inside(i, middleU, middleV) >= radius || !IsCut(cutter[i], corners, sides, slack)) continue;
            sides = CutBy(Cutter + i, corners, other, sides, slack);
            CutCorner* before = corners;
            corners = other;
            other = before;
        }

        for (int i = 0; i < sides; i++)
        {
            int before = corners[i > 0 ? i - 1 : sides - 1].Side;
            if (TryPlace(corners[i], before, ref cut, ref cutter, isACut, slack, ref places[found])) found++;
        }

        return found;
    }

    /// <summary>Says what a corner is a corner of, or on which edges it lies; false where it is not shared.</summary>
    private static bool TryPlace(
        in CutCorner corner, int before, ref FlatFeature cut, ref FlatFeature cutter, bool isACut, double slack,
        ref ContactPlace place)
    {
        int after = corner.Side, ofCut = -1, ofCutter = -1, edge = -1, cutterEdge = -1;
        double u = corner.U, v = corner.V;
        bool isCrossing = before < Cutter != after < Cutter;
        if (isCrossing)
        {
            edge = Math.Min(before, after);
            cutterEdge = Math.Max(before, after) - Cutter;

            // Beyond a tip two edges are nearer than the slack to each other, and what they cross there is not shared,
            // but the tip may be.
            if (!cutter.IsBeside(cutterEdge, u, v, slack))
            {
                ofCutter = cutterEdge = cutter.NearerEnd(cutterEdge, u, v);
                edge = -1;
            }
        }
        else if (after < Cutter)
        {
            ofCut = after;
            edge = before;
        }
        else
        {
            ofCutter = Between(before - Cutter, after - Cutter, cutter.Count);
            cutterEdge = after - Cutter;
        }

        if (ofCutter >= 0) (u, v) = (cutter[ofCutter].U, cutter[ofCutter].V);
        place.U = u;
        place.V = v;
        place.Count = 1;
        place.IsFlat = false;
        (place.CornerA, place.CornerB) = isACut ? (ofCut, ofCutter) : (ofCutter, ofCut);
        (place.EdgeA, place.EdgeB) = isACut ? (edge, cutterEdge) : (cutterEdge, edge);
        return !isCrossing || ofCutter < 0 || cut.Holds(u, v, slack);
    }

    /// <summary>The corner between two edges of the cutter, either way round.</summary>
    private static int Between(int before, int after, int count) => (before + 1) % count == after ? after : before;

    /// <summary>Whether a line cuts anything off; says of each corner how far it is on the inner side.</summary>
    private static bool IsCut(in FlatCorner line, CutCorner* corners, int count, double slack)
    {
        double u = line.U, v = line.V, inwardU = line.InwardU, inwardV = line.InwardV;
        bool isCut = false;
        for (CutCorner* end = corners + count; corners < end; corners++)
        {
            corners->Inside = inwardU * (corners->U - u) + inwardV * (corners->V - v);
            isCut |= corners->Inside < -slack;
        }

        return isCut;
    }

    private static int CutBy(int side, CutCorner* corners, CutCorner* kept, int count, double slack)
    {
        CutCorner* first = kept, last = corners + count - 1, room = kept + Capacity - 2;
        for (CutCorner* p = corners; p <= last && kept <= room; p++)
        {
            CutCorner* q = p < last ? p + 1 : corners;
            bool isIn = p->Inside >= -slack;
            if (isIn) *kept++ = *p;
            if (isIn == q->Inside >= -slack) continue;
            double part = Math.Max(0, Math.Min(1, p->Inside / (p->Inside - q->Inside)));
            kept->U = p->U + (q->U - p->U) * part;
            kept->V = p->V + (q->V - p->V) * part;
            kept->Side = isIn ? side : p->Side;
            kept++;
        }

        return (int)(kept - first);
    }
}

/// <summary>A corner while one feature is cut by the other.</summary>
internal struct CutCorner
{
    /// <summary>In the plane across the normal, and how far it is on the inner side of what cuts.</summary>
    public double U, V, Inside;

    /// <summary>The edge that the side beginning here lies on: one of what is cut, or of the cutter.</summary>
    public int Side;
}
