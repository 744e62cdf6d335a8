namespace Gjk.Core.Tests.Regression;

/// <summary>An apex or a pole on the middle of a disc that leans by 5e-6 to 2e-4: the shortest way out is across the
/// disc, a little beside the axis of the other body. The proof for planes about that axis left out how the leaning one
/// moves in directions near it, and shapes that were apart overlapped by 1e-4.</summary>
public class LeaningAxisTests
{
    [Fact]
    public void ADiscIsLeftAcrossItself()
    {
        for (int i = 0; i < Budget.Count(200); i++)
        {
            var rng = new Rng((ulong)i);
            float lean = rng.LogFloat(2e-6, 2e-4);
            TestShape disc = TestShape.Cylinder(rng.Float(0.3, 2), rng.Float(0.3, 1));
            TestShape other = i % 2 == 0 ? TestShape.Cone(rng.Float(0.3, 2), rng.Float(0.3, 1))
                : TestShape.Ellipsoid(new Vector3(1.3f, rng.Float(0.3, 1), 1.3f));
            var pose = new RigidPose(
                new Quaternion(lean * rng.Float(-1, 1), 0, lean * rng.Float(-1, 1), 1), new(0, rng.Float(0, 0.3), 0));
            var pair = new TestPair($"seed {i}", disc, RigidPose.Identity, other, pose);
            DistanceResult r = pair.SignedDistance();
            double cheapest = CheapestWay.Of(pair, new Double3(0, 1, 0), (ulong)i);
            Assert.True(-r.Distance <= cheapest + 1e-6 * 4, $"{r}, a way costs {cheapest:R}: seed {i}");
        }
    }

    [Fact]
    public void ConesThatAreApartAreApart()
    {
        ConvexShape cone = ConvexShape.Cone(1.7358773946762085f, 1);
        var lower = new RigidPose(
            new Quaternion(4.53313334e-8f, 0, 0, 1), new Vector3(1.04633605f, 0.983215511f, -1.45065415f));
        var upper = new RigidPose(
            new Quaternion(-6.01009879e-6f, -7.80505579e-5f, 4.72356478e-5f, 1),
            new Vector3(1.04633605f, 2.98321557f, -1.45065391f));
        DistanceResult distance = ConvexQuery.Distance(cone, lower, cone, upper);
        DistanceResult signed = ConvexQuery.SignedDistance(cone, lower, cone, upper);
        Assert.Equal((GjkStatus.Separated, distance.Distance), (signed.Status, signed.Distance));
    }
}
