namespace Gjk.Core;

/// <summary>The hull of a cloud that spans space. Adds the point furthest above some face next, which suits ordinary
/// clouds. If that takes too long, begins again in a random order, which suits every cloud.</summary>
/// <remarks>
/// Any order gives the same hull (<see cref="HullGrowth"/>). The order decides about the time, and about how coplanar
/// faces are cut before they are joined.
///
/// Furthest first is the quickhull of Barber, Dobkin and Huhdanpaa (1996). It drops inner points soon, but its steps
/// need not be balanced: on a spiral that shrinks geometrically every step moves most of the points to other lists,
/// and the time is quadratic. So its work is counted and limited.
///
/// In a random order the expected time is O(n log n) for every cloud (Clarkson and Shor, "Applications of Random
/// Sampling in Computational Geometry, II", 1989). A face of the hull of the first r points has three corners, so the
/// r-th point made it with a probability of at most 3 / r. That hull has fewer than 2 r faces, so a step makes fewer
/// than six on average, and the mean point outside sees a bounded number of them. The sum over all steps is n log n
/// times a constant; coplanar faces change the constant only. The clouds of HullCostTests need 1 to 5 tests per
/// point and log2 n.
/// <see cref="ShuffledOrder"/> says why no cloud can be made for which its order is a bad one.
/// </remarks>
internal static class QuickHull
{
    /// <summary>Units of <see cref="HullGrowth.Work"/> per point and log2 n, after which the order is changed. Random
    /// points on a sphere need 4, prisms 8, a log spiral of 10^4 points 260. Pinned by HullCostTests.</summary>
    public const int MostWork = 16;

    /// <summary>Faces. Takes the oldest while fewer are pending, the newest when there are more. Breadth keeps the hull
    /// evenly refined: depth alone would finish one rim of a cylinder before the other, with vertices that neighbour a
    /// whole rim. Depth keeps to memory that is in the cache: on a sphere of 10^6 points it halves the time. Any number
    /// is correct.</summary>
    private const int BreadthFirstFaces = 4096;

    /// <summary>Builds the hull from four points that span space, d strictly below the plane through a, b, c.</summary>
    /// <param name="predicates">Of the distinct points.</param>
    /// <param name="a">First corner of the first tetrahedron.</param>
    /// <param name="b">Second corner.</param>
    /// <param name="c">Third corner.</param>
    /// <param name="d">Fourth corner.</param>
    /// <param name="mostWork">Per point and log2 n, with the furthest points first: <see cref="MostWork"/> but in
    /// tests.</param>
    /// <param name="work">The work of both orders, in tests of a point against a plane.</param>
    public static HullSurface Build(HullPredicates predicates, int a, int b, int c, int d, int mostWork, out long work)
    {
        int count = predicates.Points.Length;
        var growth = new HullGrowth(predicates, a, b, c, d);
        bool isDone = AddFurthestFirst(growth, (long)mostWork * count * BitLength(count));
        work = growth.Work;
        if (isDone) return growth.Surface;

        growth = new HullGrowth(predicates, a, b, c, d);
        AddInOrder(growth, ShuffledOrder.Of(predicates.Points));
        work += growth.Work;
        return growth.Surface;
    }

    /// <summary>False when the hull was not complete after that much work.</summary>
    private static bool AddFurthestFirst(HullGrowth growth, long mostWork)
    {
        var pending = new List<int>();
        int start = 0;
        AppendPending(growth, pending);
        while (pending.Count > start)
        {
            if (growth.Work > mostWork) return false;
            int face;
            if (pending.Count - start < BreadthFirstFaces)
            {
                face = pending[start++];
            }
            else
            {
                face = pending[pending.Count - 1];
                pending.RemoveAt(pending.Count - 1);
            }

            // A face that has died since, or has been used again and emptied, has nothing above it.
            ref HullSurface.Face candidate = ref growth.Surface.Faces[face];
            if (candidate.FirstAbove < 0) continue;
            growth.Add(candidate.Furthest);
            AppendPending(growth, pending);
        }

        return true;
    }

    private static void AppendPending(HullGrowth growth, List<int> pending)
    {
        HullSurface.Face[] faces = growth.Surface.Faces;
        foreach (int face in growth.NewFaces)
        {
            if (faces[face].FirstAbove >= 0) pending.Add(face);
        }
    }

    private static void AddInOrder(HullGrowth growth, int[] order)
    {
        foreach (int point in order)
        {
            if (growth.IsOutside(point)) growth.Add(point);
        }
    }

    /// <summary>log2, rounded up.</summary>
    private static int BitLength(int count)
    {
        int bits = 0;
        for (; count > 0; count >>= 1) bits++;
        return bits;
    }
}
