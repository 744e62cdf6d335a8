namespace Gjk.Core;

/// <summary>The deepest point of a manifold.</summary>
internal static class DeepestPoint
{
    public static int IndexIn(in ContactManifold manifold)
    {
        int deepest = 0;
        for (int i = 1; i < manifold.Count; i++)
            if (manifold[i].Gap < manifold[deepest].Gap) deepest = i;
        return deepest;
    }

    /// <summary>The sum of a contact's coordinates, in the world and in both frames. Roundings are ratios to
    /// it.</summary>
    public static double CoordinateSum(in DistanceResult at) =>
        ((Double3)at.PointA).SumOfMagnitudes + ((Double3)at.LocalPointA).SumOfMagnitudes
            + ((Double3)at.LocalPointB).SumOfMagnitudes;

    /// <summary>Moves the deepest point to the front.</summary>
    public static void MoveToFront(ref ContactManifold manifold)
    {
        int deepest = IndexIn(manifold);
        if (deepest == 0) return;
        ContactManifold before = manifold;
        manifold = default;
        manifold.Begin(before.Normal);
        manifold.Add(before[deepest]);
        for (int i = 0; i < before.Count; i++)
            if (i != deepest) manifold.Add(before[i]);
    }

    /// <summary>A contact of two parts with other points than their own; the deepest comes first.</summary>
    public static PairContacts MakeContact(int partA, int partB, ContactManifold manifold, in PairContacts own)
    {
        MoveToFront(ref manifold);
        return new PairContacts(partA, partB, ToResult(manifold, own.Result), manifold, own.Pair);
    }

    /// <summary>The deepest point as the result of a query, given the parts' own result.</summary>
    public static DistanceResult ToResult(in ContactManifold manifold, in DistanceResult own)
    {
        ManifoldPoint point = manifold[IndexIn(manifold)];
        return new DistanceResult(
            point.Gap > 0 ? GjkStatus.Separated : GjkStatus.Overlapping, point.Gap,
            Math.Min(own.LowerBound, point.Gap), point.PointA, point.PointB, manifold.Normal, point.LocalPointA,
            point.LocalPointB, own.Iterations);
    }
}
