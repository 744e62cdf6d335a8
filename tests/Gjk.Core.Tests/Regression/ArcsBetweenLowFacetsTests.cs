namespace Gjk.Core.Tests.Regression;

/// <summary>Across an edge a hull is higher than across the facets on both its sides. A walk along the arc between them
/// ended where that was high, and never came to its other, low end; depths of turned spheres were 5e-4 too
/// large.</summary>
public class ArcsBetweenLowFacetsTests
{
    private static readonly ConvexHull Ball = RoundHulls.Uv(12, 24);

    [Fact]
    public void TheWayThatWasMissed()
    {
        var turned = new RigidPose(Quaternion.Normalize(new Quaternion(0, 1, 1, 2)), default);
        ConvexShape ball = ConvexShape.Mesh(Ball);
        DistanceResult r = ConvexQuery.SignedDistance(ball, RigidPose.Identity, ball, turned);
        Assert.Equal((GjkStatus.Overlapping, 1.9692302f), (r.Status, -r.Distance));
    }

    [Fact]
    public void TheDepthIsThatOfAllFacets()
    {
        for (ulong seed = 0; seed < (ulong)Budget.Count(60); seed++)
        {
            var rng = new Rng(76_000 + seed);
            RigidPose a = Generators.Pose(rng, default);
            RigidPose b = Generators.Pose(rng, rng.UnitVector() * rng.LogFloat(1e-9, 0.1));
            DistanceResult r = ConvexQuery.SignedDistance(ConvexShape.Mesh(Ball), a, ConvexShape.Mesh(Ball), b);
            double truth = FacetDepth.Of(Ball, a, Ball, b);
            Assert.Equal(GjkStatus.Overlapping, r.Status);
            Assert.True(Math.Abs(-r.Distance - truth) <= Accuracy.Band(truth, 2), $"{r}, truly {truth:R}: seed {seed}");
        }
    }
}
