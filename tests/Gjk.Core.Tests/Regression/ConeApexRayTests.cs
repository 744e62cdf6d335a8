namespace Gjk.Core.Tests.Regression;

/// <summary>Rays at a cone's apex had the normal NaN, as those at bodies thinner than rounding; one that came from
/// below had the axis for a normal, and so left the cone where it met it.</summary>
public class ConeApexRayTests
{
    [Theory]
    [InlineData(0, 5, 0, 0, -1, 0)]
    [InlineData(5, 1, 0, -1, 0, 0)]
    [InlineData(3, 4, 0, -1, -1, 0)]
    [InlineData(3, -1, 0, -1, 1, 0)]
    [InlineData(3, 2, 0, -1, 0, 0)]
    public void TheNormalAtTheApexIsOneOfACone(float x, float y, float z, float dx, float dy, float dz)
    {
        var direction = new Vector3(dx, dy, dz);
        RayCastResult r = ConvexQuery.RayCast(
            ConvexShape.Cone(1, 2), RigidPose.Identity, new Vector3(x, y, z), direction);
        Assert.Equal(CastStatus.Hit, r.Status);
        Assert.Equal(1, r.Normal.Length(), 1e-6f);

        // All of the cone lies behind the plane through the apex: as steep as its side, or steeper.
        Assert.True(r.Normal.Y >= 0.4472f * 0.5f && Vector3.Dot(r.Normal, direction) < 0, $"{r.Normal}");
    }

    [Fact]
    public void ABodyThinnerThanRoundingIsMetHeadOn()
    {
        RayCastResult r = ConvexQuery.RayCast(
            ConvexShape.Capsule(1e-20f, 1), RigidPose.Identity, new Vector3(5, 0.3f, 0), -Vector3.UnitX);
        Assert.Equal((CastStatus.Hit, Vector3.UnitX), (r.Status, r.Normal));
    }
}
