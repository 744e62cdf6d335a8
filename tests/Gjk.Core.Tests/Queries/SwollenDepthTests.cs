namespace Gjk.Core.Tests.Queries;

/// <summary>Shapes with a margin that are scaled unevenly and stay bodies of revolution: a capsule that is made
/// thicker. About a common axis the general search has no room for all the ways around it.</summary>
public class SwollenDepthTests
{
    /// <summary>Supports; the general search spends thousands.</summary>
    private const int Few = 400;

    [Fact]
    public void AThickerCapsuleAroundACapsule()
    {
        ConvexShape capsule = ConvexShape.Capsule(0.5f, 1), thicker = capsule.Scaled(new Vector3(1.001f, 1, 1.001f));
        DistanceResult r = ConvexQuery.SignedDistance(
            thicker, RigidPose.Identity, capsule, new RigidPose(new Vector3(0, 0.5f, 0)));
        Assert.Equal(GjkStatus.Overlapping, r.Status);
        Assert.Equal(-(0.5 * 1.001 + 0.5), r.Distance, 1e-6);
    }

    [Fact]
    public void BodiesOfRevolutionAboutOneAxis()
    {
        for (ulong seed = 0; seed < (ulong)Budget.Count(400); seed++)
        {
            var rng = new Rng(79_000 + seed);
            TestShape a = Swollen(rng, (int)(seed % 5)), b = Other(rng);
            Quaternion q = seed % 3 == 0 ? Quaternion.Identity : rng.Rotation();
            Vector3 shift = Vector3.Transform(new Vector3(0, rng.Float(-0.3, 0.3), 0), q);
            var pair = new TestPair($"seed {seed}", a, new RigidPose(q, default), b, new RigidPose(q, shift));
            DistanceResult r = pair.SignedDistance(), swapped = pair.Swapped.SignedDistance();
            Assert.True(r.IsOverlapping && r.Iterations < Few, $"{r} {r.Iterations}: {pair}");
            Assert.True(Math.Abs(r.Distance - swapped.Distance) <= 1e-6 * pair.Scale, $"{r}, {swapped}: {pair}");
            double truth = CheapestWay.Of(pair, r.Normal, seed);
            Assert.True(-r.Distance <= truth + 1e-6 * pair.Scale, $"{r}, but a way costs {truth:R}: {pair}");
        }
    }

    /// <summary>Two factors that differ, or an axis that is not one of the factors': no body of revolution.</summary>
    [Fact]
    public void OthersAreSearched()
    {
        for (ulong seed = 0; seed < (ulong)Budget.Count(60); seed++)
        {
            var rng = new Rng(80_000 + seed);
            Vector3 factors = seed % 2 == 0 ? new Vector3(2, 2, 1) : new Vector3(1, 1.5f, 2);
            TestShape capsule = TestShape.Capsule(0.5f, rng.Float(0.3, 1)).Scaled(factors);
            TestShape rounded = TestShape.Cylinder(0.5f, 0.4f).Decorated(
                s => s.Rounded(0.2f).Scaled(factors), "Rounded(0.2f).Scaled(...)");
            var pair = new TestPair(
                $"seed {seed}", seed % 4 < 2 ? capsule : rounded, RigidPose.Identity, Other(rng),
                new RigidPose(rng.Vector(-0.3, 0.3)));
            DistanceResult r = pair.SignedDistance();
            if (!r.IsOverlapping) continue;
            double truth = CheapestWay.Of(pair, r.Normal, seed);
            Assert.True(-r.Distance <= truth + 1e-6 * pair.Scale, $"{r}, but a way costs {truth:R}: {pair}");
        }
    }

    private static TestShape Swollen(Rng rng, int kind)
    {
        float r = rng.Float(0.3, 1), h = rng.Float(0.3, 1), m = rng.Float(0.05, 0.4), s = rng.Float(1.1, 2);
        var factors = new Vector3(s, 1, -s);
        return kind switch
        {
            0 => TestShape.Capsule(r, h).Scaled(factors),
            1 => TestShape.Cylinder(r, h).Decorated(x => x.Rounded(m).Scaled(factors), "Rounded.Scaled"),
            2 => TestShape.Cone(r, h).Decorated(x => x.Rounded(m).Scaled(factors), "Rounded.Scaled"),
            3 => TestShape.Ellipsoid(new(r, h, r)).Decorated(x => x.Rounded(m).Scaled(factors), "Rounded.Scaled"),
            _ => TestShape.Capsule(r, h).Decorated(
                x => x.Scaled(factors).Rounded(m).Scaled(factors), "Scaled.Rounded.Scaled"),
        };
    }

    private static TestShape Other(Rng rng) => rng.Below(5) switch
    {
        0 => TestShape.Capsule(rng.Float(0.2, 1), rng.Float(0.2, 1)),
        1 => TestShape.Point(),
        2 => TestShape.Segment(new Vector3(0, -0.3f, 0), new Vector3(0, 0.3f, 0)),
        3 => TestShape.Cylinder(rng.Float(0.2, 1), rng.Float(0.2, 1)),
        _ => Swollen(rng, rng.Below(5)),
    };
}
