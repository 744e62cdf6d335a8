namespace Gjk.Core.Tests.Diagnostics;

/// <summary>Wrong answers that are nearly hidden by the rounding of another part of them.</summary>
public class AnswerDetailTests
{
    /// <summary>In the mesh's own frame a float has no digits left for its size, but in the world the point has all of
    /// them.</summary>
    [Fact]
    public void APointOfAMeshFarFromItsOwnOriginIsHeldToTheWorld()
    {
        const float Far = 1 << 20;
        var mesh = TestShape.Mesh([.. TestShape.Corners(Vector3.One).Select(v => v + new Vector3(Far))]);
        var pair = new TestPair(
            "far", mesh, new RigidPose(new Vector3(-Far)), TestShape.Box(Vector3.One),
            new RigidPose(new Vector3(0.25f, 3, 0.5f)));
        DistanceResult r = pair.Distance();
        Assert.Equal(
            CheckStatus.Proved, AnswerCheck.Distance(mesh.Shape, pair.PoseA, pair.B.Shape, pair.PoseB, r).Status);
        foreach (Vector3 off in new[] { new Vector3(0, 0.1f, 0), new Vector3(0.1f, 0, 0), new Vector3(0, -0.1f, 0) })
            AssertRefuted(pair, r.With(pointA: r.PointA + off), false);
    }

    /// <summary>Across both sides of flat shapes that nearly touch, no plane is apart by more than rounding.</summary>
    [Fact]
    public void ANormalOfFlatShapesHasTheirSide()
    {
        TestShape square = TestShape.Box(new Vector3(1, 0, 1));
        var pair = new TestPair(
            "flat", square, RigidPose.Identity, square, new RigidPose(new Vector3(0.25f, 1e-7f, 0)));
        DistanceResult r = pair.Distance();
        Assert.Equal(
            CheckStatus.Proved, AnswerCheck.Distance(square.Shape, pair.PoseA, square.Shape, pair.PoseB, r).Status);
        AssertRefuted(pair, r.With(normal: -r.Normal), false);
        AssertRefuted(pair, r.With(normal: -r.Normal), true);
    }

    /// <summary>Shapes that only touch have a way out, too.</summary>
    [Fact]
    public void ADepthOfZeroHasANormal()
    {
        TestShape box = TestShape.Box(Vector3.One);
        var pair = new TestPair("touching", box, RigidPose.Identity, box, new RigidPose(new Vector3(0, 2, 0)));
        DistanceResult r = pair.SignedDistance();
        Assert.Equal((GjkStatus.Overlapping, 0f), (r.Status, r.Distance));
        AssertRefuted(pair, r.With(normal: Vector3.Zero), true);
    }

    private static void AssertRefuted(TestPair p, in DistanceResult told, bool isSigned)
    {
        CheckedAnswer check = isSigned
            ? AnswerCheck.SignedDistance(p.A.Shape, p.PoseA, p.B.Shape, p.PoseB, told)
            : AnswerCheck.Distance(p.A.Shape, p.PoseA, p.B.Shape, p.PoseB, told);
        Assert.True(check.Status == CheckStatus.Refuted, $"{check}; {told}, normal {told.Normal}, {p}");
    }
}
