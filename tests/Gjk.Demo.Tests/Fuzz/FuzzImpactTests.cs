using Gjk.Exact.Fuzz;
using Gjk.Exact.Fuzz.Families;
using Gjk.Exact.Fuzz.Promises;

namespace Gjk.Demo.Tests.Fuzz;

/// <summary>Tests that <c>fuzz</c> notices wrong times of impact.</summary>
public sealed class FuzzImpactTests
{
    private static readonly ConvexShape Cube = ConvexShape.Box(new Vector3(0.5f));

    private static readonly RigidMotion Still = new(RigidPose.Identity, default, new Vector3(0, 0, 2));

    [Theory]
    [InlineData("right", null)]
    [InlineData("later", "overlap by")]
    [InlineData("earlier", "apart then")]
    [InlineData("missed", "overlap by")]
    [InlineData("inside", "Distance says")]
    [InlineData("invalid", "InvalidInput")]
    public void WrongImpactsAreNoticed(string lie, string? says)
    {
        RigidMotion moving = From(3);
        var pair = new FuzzPair(Cube, RigidPose.Identity, Cube, moving.Pose);
        CastResult told = lie switch
        {
            "right" => ConvexQuery.TimeOfImpact(Cube, Still, Cube, moving),
            "later" => ConvexQuery.TimeOfImpact(Cube, Still, Cube, From(3.05f)),
            "earlier" => ConvexQuery.TimeOfImpact(Cube, Still, Cube, From(2.9f)),
            "missed" => ConvexQuery.TimeOfImpact(Cube, Still, Cube, From(30)),
            "inside" => ConvexQuery.TimeOfImpact(Cube, Still, Cube, From(0)),
            _ => ConvexQuery.TimeOfImpact(Cube, Still, Cube, default),
        };
        string? problem = ImpactsAreProved.Problem(pair, Still, moving, told);
        if (says is null) Assert.Null(problem);
        else Assert.Contains(says, problem, StringComparison.Ordinal);
    }

    /// <summary>A speed whose square is no float is a speed.</summary>
    [Fact]
    public void BodiesAsFastAsAFloatIsLarge()
    {
        const float two62 = 1L << 62;
        ConvexShape ball = ConvexShape.Sphere(two62);
        var still = new RigidMotion(RigidPose.Identity, default);
        var fast = new RigidMotion(new RigidPose(new Vector3(2 * two62, 0, 0)), new Vector3(-4 * two62, 0, 0));
        CastResult r = ConvexQuery.TimeOfImpact(ball, still, ball, fast);
        Assert.Equal((CastStatus.Hit, 0f), (r.Status, r.Fraction));
        Assert.Null(ImpactsAreProved.Problem(new FuzzPair(ball, still.Pose, ball, fast.Pose), still, fast, r));
    }

    /// <summary>The turns follow from the pair, and both hits and misses are met.</summary>
    [Fact]
    public void EveryKindOfImpactIsMet()
    {
        int hits = 0, misses = 0, turning = 0;
        for (long i = 0; i < 300; i++)
        {
            FuzzPair pair = PairFamilies.Draw(1, i, out _);
            (RigidMotion a, RigidMotion b) = Turning.Of(pair);
            Assert.Equal(a.AngularVelocity, Turning.Of(pair).A.AngularVelocity);
            if (b.AngularVelocity != Vector3.Zero) turning++;
            CastResult r = ConvexQuery.TimeOfImpact(pair.A, a, pair.B, b);
            if (r.Status == CastStatus.Hit) hits++;
            if (r.Status == CastStatus.Miss) misses++;
            Assert.Null(ImpactsAreProved.Broken(pair));
        }

        Assert.True(hits > 20 && misses > 20 && turning > 290, $"{hits} hit, {misses} miss, {turning} turn");
    }

    private static RigidMotion From(float x) =>
        new(new RigidPose(new Vector3(x, 0.25f, 0)), new Vector3(-4, 0, 0), new Vector3(1, 2, 0));
}
