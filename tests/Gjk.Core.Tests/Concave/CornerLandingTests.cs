namespace Gjk.Core.Tests.Concave;

/// <summary>A tip that falls straight down onto a corner which parts of a flat floor share meets the floor's
/// face.</summary>
public class CornerLandingTests
{
    private static readonly Vector3[] Tip = [new(0, 0, 0), new(1, 1, 0), new(-0.5f, 1, 0.8f), new(-0.5f, 1, -0.8f)];

    [Theory]
    [InlineData("convex", "plate")]
    [InlineData("convex", "two-sided")]
    [InlineData("convex", "doubled")]
    [InlineData("convex", "tiles")]
    [InlineData("solid", "plate")]
    [InlineData("solid", "two-sided")]
    [InlineData("solid", "tiles")]
    [InlineData("pole", "plate")]
    [InlineData("pole", "doubled")]
    [InlineData("pole", "tiles")]
    public void ATipMeetsTheFloorsFace(string body, string name)
    {
        AnyShape floor = Floors.Named(name), falling = Body(body);
        var scratch = new ConcaveScratch();
        float up = body == "pole" ? 1.8f : 1;
        for (int i = 0; i < 100; i++)
        {
            var corner = new Vector3(0.5f * (1 + i % 5), 0, 0.5f * (1 + i / 5 % 5));
            var from = new RigidPose(
                Quaternion.CreateFromAxisAngle(Vector3.UnitY, 0.37f * i), corner + new Vector3(0, up, 0));
            CastHit hit = ConcaveQuery.Cast(
                falling, from, new Vector3(0, -4, 0), floor, RigidPose.Identity, Vector3.Zero, scratch);
            Assert.True(hit.Result.Normal.Y < -0.9999f, $"{i}: {hit}");
            hit = ConcaveQuery.Cast(
                floor, RigidPose.Identity, Vector3.Zero, falling, from, new Vector3(0, -4, 0), scratch);
            Assert.True(hit.Result.Normal.Y > 0.9999f, $"{i}: {hit}, the floor first");
        }
    }

    private static AnyShape Body(string name) => name switch
    {
        "convex" => AnyShape.Of(ConvexShape.Mesh(new ConvexHull(Tip))),
        "solid" => AnyShape.Solid(new TriangleMesh(Tip, [0, 1, 2, 0, 2, 3, 0, 3, 1, 1, 3, 2])),
        _ => AnyShape.Solid(Solids.Named("ball", 0)),
    };
}
