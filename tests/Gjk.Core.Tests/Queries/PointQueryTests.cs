namespace Gjk.Core.Tests.Queries;

/// <summary>Queries of a point say what the pair queries say of a point that is a shape.</summary>
public class PointQueryTests
{
    private static readonly string[] Kinds = [.. Generators.AllKinds, "bigHull", "made"];

    [Fact]
    public void AllAgreeWithThePairQueries()
    {
        int inside = 0, count = Budget.Count(2000);
        for (int i = 0; i < count; i++)
        {
            TestPair p = Generators.Pair((ulong)i, Kinds, 0.7);
            (ConvexShape shape, RigidPose pose, Vector3 point) = (p.A.Shape, p.PoseA, p.PoseB.Position);
            var at = new RigidPose(point);
            DistanceResult pair = ConvexQuery.Distance(shape, pose, new PointShape(), at);
            DistanceResult signed = ConvexQuery.SignedDistance(shape, pose, point);
            Assert.True(ResultBits.AreSame(pair, ConvexQuery.Distance(shape, pose, point)), $"seed {i}");
            Assert.True(
                ResultBits.AreSame(signed, ConvexQuery.SignedDistance(shape, pose, ConvexShape.Point(), at)),
                $"seed {i}");
            bool contains = ConvexQuery.Contains(shape, pose, point);
            Assert.Equal(pair.IsOverlapping, contains);
            Assert.Equal(ConvexQuery.Overlaps(shape, pose, new PointShape(), at), contains);
            Assert.Equal(contains ? point : pair.PointA, ConvexQuery.ClosestPoint(shape, pose, point));
            Assert.True(signed.Status != GjkStatus.Overlapping || signed.Distance <= 0, $"seed {i}: {signed}");
            Double3 error = (Double3)signed.PointA + (Double3)signed.Normal * signed.Distance - signed.PointB;
            Assert.True(error.Length <= 2e-6 * (1 + p.Scale), $"seed {i}: {signed}");
            Assert.True(
                ((Double3)signed.PointB - point).Length <= 3e-6 * (1 + p.Scale), $"seed {i}: {point}, {signed}");
            if (contains) inside++;
        }

        Assert.InRange(inside, 0.1 * count, 0.7 * count);
    }

    [Fact]
    public void ABoxByHand()
    {
        var box = new BoxShape(new Vector3(1, 2, 3));
        Assert.True(ConvexQuery.Contains(box, RigidPose.Identity, new(1, 2, 3)));
        Assert.False(ConvexQuery.Contains(box, RigidPose.Identity, new(1.0000001f, 2, 3)));
        Assert.Equal(new Vector3(1, 0.5f, 3), ConvexQuery.ClosestPoint(box, RigidPose.Identity, new(4, 0.5f, 7)));
        Assert.Equal(new Vector3(0, 1, 0), ConvexQuery.ClosestPoint(box, RigidPose.Identity, new(0, 1, 0)));
        DistanceResult inside = ConvexQuery.SignedDistance(box, RigidPose.Identity, new Vector3(0.75f, 0, 0));
        Assert.Equal(
            (GjkStatus.Overlapping, -0.25f, Vector3.UnitX), (inside.Status, inside.Distance, inside.Normal));
        Assert.Equal((new Vector3(1, 0, 0), new Vector3(0.75f, 0, 0)), (inside.PointA, inside.PointB));
        Assert.Equal(
            GjkStatus.BeyondMaxDistance, ConvexQuery.Distance(box, RigidPose.Identity, new Vector3(9, 0, 0), 1).Status);
    }

    [Fact]
    public void BadInputIsInvalid()
    {
        var box = ConvexShape.Box(Vector3.One);
        var bad = new Vector3(0, float.NaN, 0);
        Assert.False(ConvexQuery.Contains(box, RigidPose.Identity, bad));
        Assert.False(ConvexQuery.Contains(box, default, Vector3.Zero));
        Assert.True(float.IsNaN(ConvexQuery.ClosestPoint(box, RigidPose.Identity, bad).X));
        Assert.True(float.IsNaN(ConvexQuery.ClosestPoint(default(ConvexShape), RigidPose.Identity, default).X));
        Assert.Equal(GjkStatus.InvalidInput, ConvexQuery.Distance(box, RigidPose.Identity, bad).Status);
        Assert.Equal(GjkStatus.InvalidInput, ConvexQuery.SignedDistance(box, RigidPose.Identity, bad).Status);
        Assert.Equal(GjkStatus.InvalidInput, ConvexQuery.SignedDistance(box, default, Vector3.One).Status);
    }
}
