using System.Collections.Generic;

namespace Gjk.Exact.Fuzz.Promises;

/// <summary>All of them, those first that the others build on.</summary>
internal static class AllPromises
{
    public static IReadOnlyList<IPromise> Make() =>
    [
        new QueriesEndWithAnAnswer(),
        new SupportsReachTheCloud(),
        new DirectionsHaveAnyLength(),
        new TheExactAnswer(),
        new LowerBoundHolds(),
        new NormalSeparates(),
        new PointsLieOnTheShapes(),
        new PointsDifferByTheDistance(),
        new NoPlaneSeparatesAnOverlap(),
        new OverlapsAgrees(),
        new TheSignedDistanceIsTheDistance(),
        new TheWayOutEndsTouching(),
        new NoWayOutIsShorter(),
        new CastsBeginAsTheDepthSays(),
        new TheCastIsTheFirstTouch(),
        new CastsEndAtTheLargestFraction(),
        new CastsMirror(),
        new OnlyTheRelativeMotionCounts(),
        new WarmCastsAreCold(),
        new WhatPassesGetsNoDeeper(),
        new ImpactsAreProved(),
        new TheCheckAgrees(),
        new SwappingMirrors(),
        new WarmStartsChangeNothing(),
        new MaxDistanceEndsEarly(),
        new RepeatsChangeNothing(),
        new SizeChangesNothing(),
        new MotionChangesNothing(),
        new TheSameBitsAgain(),
        new TypedShapesGiveTheSameBits(),
        new UsersShapesAreShapes(),
    ];
}
