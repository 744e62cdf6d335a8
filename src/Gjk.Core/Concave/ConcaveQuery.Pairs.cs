namespace Gjk.Core;

public static partial class ConcaveQuery
{
    /// <summary>All pairs of parts that are no further apart than a distance.</summary>
    /// <param name="a">The first shape.</param>
    /// <param name="poseA">Pose of A in the world.</param>
    /// <param name="b">The second shape.</param>
    /// <param name="poseB">Pose of B in the world.</param>
    /// <param name="distance">World units; less than 0 counts as 0.</param>
    /// <param name="scratch">Memory for the search.</param>
    /// <param name="pairs">Cleared, then what <c>ConvexQuery.Distance</c> says of each pair, by the numbers of the
    /// parts. What lies inside a solid without touching its triangles is no pair.</param>
    /// <returns>False when the input is invalid.</returns>
    public static bool FindPairsWithin(
        in AnyShape a, in RigidPose poseA, in AnyShape b, in RigidPose poseB, float distance, ConcaveScratch scratch,
        List<PairDistance> pairs)
    {
        if (pairs is null) return false;
        pairs.Clear();
        if (float.IsNaN(distance) || !TrySetSides(a, poseA, b, poseB, scratch)) return false;
        PartPairSearch.Collect(scratch, distance, pairs);
        InPlaceSort.Sort(pairs);
        return true;
    }

    /// <summary>How deep the overlapping pairs of parts are in each other.</summary>
    /// <param name="a">The first shape.</param>
    /// <param name="poseA">Pose of A in the world.</param>
    /// <param name="b">The second shape.</param>
    /// <param name="poseB">Pose of B in the world.</param>
    /// <param name="scratch">Memory for the search.</param>
    /// <param name="pairs">Cleared, then what <c>ConvexQuery.SignedDistance</c> says of each pair that overlaps, by the
    /// numbers of the parts. A depth separates its two parts; none of them need separate the shapes.</param>
    /// <returns>False when the input is invalid.</returns>
    public static bool FindDepths(
        in AnyShape a, in RigidPose poseA, in AnyShape b, in RigidPose poseB, ConcaveScratch scratch,
        List<PairDistance> pairs)
    {
        if (!FindPairsWithin(a, poseA, b, poseB, 0, scratch, pairs)) return false;
        int kept = 0;
        for (int i = 0; i < pairs.Count; i++)
        {
            PairDistance pair = pairs[i];
            if (!pair.IsOverlapping) continue;
            pairs[kept++] = new PairDistance(
                PartQuery.SignedDistance(scratch.A, pair.PartA, scratch.B, pair.PartB), pair.PartA, pair.PartB);
        }

        pairs.RemoveRange(kept, pairs.Count - kept);
        return true;
    }
}
