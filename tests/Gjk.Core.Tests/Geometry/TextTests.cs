namespace Gjk.Core.Tests.Geometry;

/// <summary>What people read of results: no minus before a zero, and no digits that rounding left.</summary>
public class TextTests
{
    [Fact]
    public void ATouchIsNoMinusZeroDeep()
    {
        var box = new BoxShape(Vector3.One);
        DistanceResult touch = ConvexQuery.SignedDistance(
            box, RigidPose.Identity, box, new RigidPose(new Vector3(2, 0, 0)));
        Assert.StartsWith("Overlapping by 0, B leaves A along <1, 0, 0>", touch.ToString(), StringComparison.Ordinal);
    }

    [Theory]
    [InlineData(9e-15f, 1, "<0, 1, 0>")]
    [InlineData(-4e-16f, 1, "<0, 1, 0>")]
    [InlineData(4e-14f, 1, "<3.99999993E-14, 1, 0>")]
    [InlineData(4e-16f, 0, "<4.00000007E-16, 0, 0>")]
    public void VectorsOfPeopleHaveNoNoise(float x, float y, string text) =>
        Assert.Contains(text, new Aabb(new Vector3(x, y, -0f), new Vector3(9)).ToString(), StringComparison.Ordinal);
}
