namespace Gjk.Core.Tests.Regression;

/// <summary>Two spheres whose centres lie closer than touching had one common point from Distance and another, a
/// rounding away, from the overload with the simplex: the closed form called their cores apart where the loop calls
/// them one. Found by fuzz.</summary>
public class SphereCentreTests
{
    [Fact]
    public void BothOverloadsGiveTheSameBitsHoweverNearTheCentres()
    {
        for (ulong seed = 0; seed < (ulong)Budget.Count(500); seed++)
        {
            var rng = new Rng(seed);
            ConvexShape a = ConvexShape.Sphere(rng.Float(0.1, 1));
            ConvexShape b = ConvexShape.Sphere(rng.Below(3) == 0 ? 0 : rng.Float(0.1, 1));
            var pose = new RigidPose(rng.UnitVector() * rng.LogFloat(1e-18, 1));
            DistanceResult plain = ConvexQuery.Distance(a, RigidPose.Identity, b, pose);
            DistanceResult whole = ConvexQuery.Distance(a, RigidPose.Identity, b, pose, out FinalSimplex simplex);
            Assert.Equal(ResultBits.Of(whole), ResultBits.Of(plain));
            Assert.Equal(1, simplex.Count);
        }
    }
}
