namespace Gjk.Core;

/// <summary>The point of a manifold that is deepest.</summary>
internal static class DeepestPoint
{
    public static int Of(in ContactManifold manifold)
    {
        int deepest = 0;
        for (int i = 1; i < manifold.Count; i++)
            if (manifold[i].Gap < manifold[deepest].Gap) deepest = i;
        return deepest;
    }

    /// <summary>The magnitudes of where a contact is, in the world and in both frames: roundings are ratios to
    /// it.</summary>
    public static double PlaceOf(in DistanceResult at) =>
        ((Double3)at.PointA).SumOfMagnitudes + ((Double3)at.LocalPointA).SumOfMagnitudes
            + ((Double3)at.LocalPointB).SumOfMagnitudes;

    /// <summary>Puts it first.</summary>
    public static void Lead(ref ContactManifold manifold)
    {
        int deepest = Of(manifold);
        if (deepest == 0) return;
        ContactManifold before = manifold;
        manifold = default;
        manifold.Begin(before.Normal);
        manifold.Add(before[deepest]);
        for (int i = 0; i < before.Count; i++)
            if (i != deepest) manifold.Add(before[i]);
    }

    /// <summary>A contact that has other points than the parts' own one; the deepest leads.</summary>
    public static PairContacts Contact(int partA, int partB, ContactManifold manifold, in PairContacts own)
    {
        Lead(ref manifold);
        return new PairContacts(partA, partB, Result(manifold, own.Result), manifold, own.Pair);
    }

    /// <summary>It as the result of a query, whose own result is given.</summary>
    public static DistanceResult Result(in ContactManifold manifold, in DistanceResult own)
    {
        ManifoldPoint point = manifold[Of(manifold)];
        return new DistanceResult(
            point.Gap > 0 ? GjkStatus.Separated : GjkStatus.Overlapping, point.Gap,
            Math.Min(own.LowerBound, point.Gap), point.PointA, point.PointB, manifold.Normal, point.LocalPointA,
            point.LocalPointB, own.Iterations);
    }
}
