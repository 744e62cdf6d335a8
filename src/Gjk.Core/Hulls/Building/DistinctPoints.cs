namespace Gjk.Core;

/// <summary>A cloud without repeats, in the order of first occurrence. Two points are the same when their coordinates
/// are equal; -0 equals 0 and is kept as 0.</summary>
/// <remarks>A hash table finds the repeats. Its hash is public, so points can be made that collide; therefore the steps
/// along the table are counted, and the points are sorted instead when there are too many. The result is the same, and
/// the time is n log n at most.</remarks>
internal sealed class DistinctPoints
{
    /// <summary>Steps along the table per point, on average, after which the points are sorted. A half full table needs
    /// less than one for points that were not made to collide. Pinned by HullCostTests.</summary>
    private const int MostSteps = 16;

    /// <summary>The points, each once.</summary>
    public readonly Vector3[] Points;

    /// <summary>For each point the index of its first occurrence in the cloud; ascending.</summary>
    public readonly int[] Sources;

    /// <summary>How many pairs of points have been compared.</summary>
    public readonly long Comparisons;

    public DistinctPoints(Vector3[] cloud)
    {
        var points = new Vector3[cloud.Length];
        int[] sources = new int[cloud.Length];
        if (!TryCollectByHash(cloud, points, sources, out int count, ref Comparisons))
            count = CollectBySorting(cloud, points, sources, ref Comparisons);
        Array.Resize(ref points, count);
        Array.Resize(ref sources, count);
        Points = points;
        Sources = sources;
    }

    /// <summary>False when the points collide too often.</summary>
    private static bool TryCollectByHash(
        Vector3[] cloud, Vector3[] points, int[] sources, out int count, ref long comparisons)
    {
        // Open addressing, at most half full; a slot holds the index of a distinct point plus one.
        int slots = 16;
        while (slots < 2L * cloud.Length && slots < 1 << 30) slots *= 2;
        int[] table = new int[slots];
        long stepsLeft = (long)MostSteps * cloud.Length;
        count = 0;
        for (int i = 0; i < cloud.Length; i++)
        {
            Vector3 p = WithoutNegativeZeros(cloud[i]);
            int slot = (int)(Hash(p) & (uint)(slots - 1));
            for (; table[slot] != 0 && points[table[slot] - 1] != p; stepsLeft--) slot = slot + 1 & slots - 1;
            if (stepsLeft < 0) break;
            if (table[slot] != 0) continue;
            points[count] = p;
            sources[count] = i;
            table[slot] = ++count;
        }

        comparisons += (long)MostSteps * cloud.Length - stepsLeft + cloud.Length;
        return stepsLeft >= 0;
    }

    private static int CollectBySorting(Vector3[] cloud, Vector3[] points, int[] sources, ref long comparisons)
    {
        int[] order = new int[cloud.Length];
        for (int i = 0; i < cloud.Length; i++)
        {
            points[i] = WithoutNegativeZeros(cloud[i]);
            order[i] = i;
        }

        var byCoordinates = new CoordinateOrder(points);
        Array.Sort(order, byCoordinates);
        bool[] isRepeat = new bool[cloud.Length];
        for (int k = 1; k < order.Length; k++) isRepeat[order[k]] = points[order[k]] == points[order[k - 1]];
        comparisons += byCoordinates.Comparisons + order.Length;

        int count = 0;
        for (int i = 0; i < points.Length; i++)
        {
            if (isRepeat[i]) continue;
            points[count] = points[i];
            sources[count++] = i;
        }

        return count;
    }

    private static Vector3 WithoutNegativeZeros(Vector3 p) =>
        new(p.X == 0 ? 0 : p.X, p.Y == 0 ? 0 : p.Y, p.Z == 0 ? 0 : p.Z);

    /// <summary>Multiplications by odd constants and shifts spread lattices, whose coordinates differ in few high bits,
    /// over the low bits.</summary>
    private static uint Hash(Vector3 p)
    {
        unchecked
        {
            uint h = (uint)p.X.GetHashCode() * 0x9E3779B1u;
            h = (h ^ h >> 15 ^ (uint)p.Y.GetHashCode()) * 0x85EBCA77u;
            h = (h ^ h >> 13 ^ (uint)p.Z.GetHashCode()) * 0xC2B2AE3Du;
            h = (h ^ h >> 16) * 0x27D4EB2Fu;
            return h ^ h >> 15;
        }
    }

    /// <summary>By coordinates, then by index.</summary>
    private sealed class CoordinateOrder(Vector3[] points) : IComparer<int>
    {
        public long Comparisons { get; private set; }

        public int Compare(int i, int j)
        {
            Comparisons++;
            Vector3 p = points[i], q = points[j];
            int order = p.X.CompareTo(q.X);
            if (order == 0) order = p.Y.CompareTo(q.Y);
            if (order == 0) order = p.Z.CompareTo(q.Z);
            return order != 0 ? order : i.CompareTo(j);
        }
    }
}
