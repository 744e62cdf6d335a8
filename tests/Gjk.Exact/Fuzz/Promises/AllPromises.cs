namespace Gjk.Exact.Fuzz.Promises;

/// <summary>One thing that a user of the library relies on, checked for one pair.</summary>
/// <typeparam name="TPair">A pair of convex shapes, or one of any shapes.</typeparam>
/// <param name="Name">The promise in a few words.</param>
/// <param name="Broken">How a pair breaks it, in one line; null when it holds.</param>
internal sealed record Promise<TPair>(string Name, Func<TPair, string?> Broken);

/// <summary>All of them, those first that the others build on.</summary>
internal static class AllPromises
{
    public static IReadOnlyList<Promise<FuzzPair>> Make() =>
    [
        new("every query ends with an answer", QueriesEndWithAnAnswer.Broken),
        new("a support is the furthest point of the cloud", SupportsReachTheCloud.Broken),
        new("a direction may have any length", DirectionsHaveAnyLength.Broken),
        new("the answer is the exact one, rounded", TheExactAnswer.Broken),
        new("the lower bound is below the distance and closes the gap", LowerBoundHolds.Broken),
        new("the planes across the normal stand the distance apart", NormalSeparates.Broken),
        new("the closest points lie on their shapes", PointsLieOnTheShapes.Broken),
        new("the closest points differ by normal times distance", PointsDifferByTheDistance.Broken),
        new("no plane separates shapes that are said to overlap", NoPlaneSeparatesAnOverlap.Broken),
        new("Overlaps says what Distance says", SamePromises.OverlapsAgrees),
        new("the signed distance is the distance of what is apart", TheSignedDistanceIsTheDistance.Broken),
        new("moved out by the depth, overlapping shapes only touch", TheWayOutEndsTouching.Broken),
        new("no way out is shorter than the depth", NoWayOutIsShorter.Broken),
        new("a cast begins as the depth says", CastPromises.BeginAsTheDepthSays),
        new("a cast finds the first touch", CastProof.Broken),
        new("a largest fraction changes nothing before it", CastPromises.EndAtTheLargestFraction),
        new("exchanging A and B mirrors the cast", CastPromises.Mirror),
        new("a motion that both shapes share changes no cast", CastPromises.CountTheRelativeMotion),
        new("a warm start does not change a cast", CastPromises.AreColdWhenWarm),
        new("a ray enters and leaves where the support says", RaysEnterAndLeave.Broken),
        new("the mass is that of the shape", MassIsOfTheShape.Broken),
        new("what passes gets no deeper", WhatPassesGetsNoDeeper.Broken),
        new("a time of impact is proved up to it, and within the tolerance at it", ImpactsAreProved.Broken),
        new("the check refutes nothing, and its bounds hold the truth", TheCheckAgrees.Broken),
        new("exchanging A and B mirrors the answer", SamePromises.SwappingMirrors),
        new("a warm start changes nothing", WarmStartsChangeNothing.Broken),
        new("a maximum distance changes nothing within it and proves what is beyond", MaxDistanceEndsEarly.Broken),
        new("repeated vertices and their order change nothing", SamePromises.RepeatsChangeNothing),
        new("another unit of length changes nothing", SizeChangesNothing.Broken),
        new("moving both shapes alike changes nothing", MotionChangesNothing.Broken),
        new("the same query gives the same bits", SamePromises.TheSameBitsAgain),
        new("a typed shape gives the same bits", TypedShapesGiveTheSameBits.Broken),
        new("a user's shape is solved as well, however generous its radius", UsersShapesAreShapes.Broken),
    ];
}
