namespace Gjk.Core.Tests.Regression;

/// <summary>Curved shapes that a query calls touching although a rounding error lies between them were missed by a
/// scene: its boxes were widened by a part of their small coordinates, not of the shapes.</summary>
public class TouchingInScenesTests
{
    private const string ThinConeOnDisc =
        "gjk1 cone 0.0016867431113496423 1.9785777567449259E-06 0 @ 0 0 0 1 -0 -3.12127406E-14 -0 cylinder 1 "
        + "1.2092952195175144E-09 0 @ 0 0 0 1 0 -1.97998588E-06 0";

    [Theory]
    [InlineData(BroadPhaseKind.SortAndSweep)]
    [InlineData(BroadPhaseKind.DynamicTree)]
    public void ASceneFindsWhatTheQueryCallsTouching(BroadPhaseKind broadPhase)
    {
        QueryRecord q = QueryRecord.Parse(ThinConeOnDisc);
        Assert.True(ConvexQuery.Overlaps(q.A, q.PoseA, q.B, q.PoseB));
        var scene = new CollisionScene(broadPhase);
        scene.Add(q.A, q.PoseA);
        scene.Add(q.B, q.PoseB);
        var pairs = new List<ObjectPair>();
        scene.FindOverlaps(pairs);
        Assert.Single(pairs);
    }
}
