namespace Gjk.Core.Tests.World;

/// <summary>What begins inside the union of parts or objects slides along the union, over its seams, and is stopped by
/// what stands in the way.</summary>
public class UnionSlideTests
{
    private static readonly CastOptions NoDeeper = CastOptions.OnlyDeeper(1e-3f);

    public static TheoryData<string> Floors => ["one", "tiles", "mesh", "compound", "solid"];

    [Theory]
    [MemberData(nameof(Floors))]
    public void ABodyThatIsDeepSlidesOverSeams(string floor)
    {
        ConvexShape[] bodies = [ConvexShape.Capsule(0.3f, 0.5f), ConvexShape.Box(new Vector3(0.3f, 0.8f, 0.2f))];
        foreach (ConvexShape body in bodies)
        {
            foreach (float deep in new[] { 0.01f, 0.002f, 0.05f })
            {
                var scene = new CollisionScene();
                AddFloor(scene, floor);
                var from = new RigidPose(new Vector3(1.1f, 1.3f - deep, 0.05f));
                bool isHit = scene.TryFindCastHit(
                    body, from, new Vector3(5, 0, 0), out CastHit hit, options: NoDeeper);
                Assert.False(isHit, $"{floor}, {deep}: {hit}");
                int wall = scene.Add(ConvexShape.Box(new Vector3(0.5f, 3, 3)), new RigidPose(new Vector3(5, 0, 0)));
                Assert.True(scene.TryFindCastHit(
                    body, from, new Vector3(5, 0, 0), out hit, options: NoDeeper));
                Assert.Equal(wall, hit.Id);
                Assert.Equal((4.5f - 0.3f - 1.1f) / 5, hit.Fraction, 1e-5f);
                Assert.True(
                    scene.TryFindCastHit(body, from, new Vector3(0, -0.1f, 0), out hit, options: NoDeeper),
                    $"{floor}: down");
            }
        }
    }

    [Theory]
    [InlineData(false, 0, 1e-3f)]
    [InlineData(true, 0, 1e-3f)]
    [InlineData(false, 1000, 0)]
    [InlineData(false, -3000, 0)]
    public void ABodyThatIsDeepInACompoundSlidesAlongIt(bool turns, float height, float allowed)
    {
        var at = new RigidPose(new Vector3(0, height, 0));
        CastOptions options = CastOptions.OnlyDeeper(allowed);
        AnyShape floor = Tiles();
        var scratch = new ConcaveScratch();
        AnyShape body = AnyShape.Of(ConvexShape.Capsule(0.3f, 0.5f));
        var from = new RigidPose(new Vector3(1.1f, height + 1.29f, 0.05f));
        CastHit found = turns
            ? ConcaveQuery.TimeOfImpact(
                floor, new RigidMotion(at, Vector3.Zero), body,
                new RigidMotion(from, new Vector3(5, 0, 0), new Vector3(0, 0.1f, 0)), scratch, options: options)
            : ConcaveQuery.Cast(
                floor, at, Vector3.Zero, body, from, new Vector3(5, 0, 0), scratch, options: options);
        Assert.Equal(CastStatus.Miss, found.Status);
    }

    internal static void AddFloor(CollisionScene scene, string floor)
    {
        var half = ConvexShape.Box(new Vector3(0.5f));
        switch (floor)
        {
            case "one":
                scene.Add(ConvexShape.Box(new Vector3(5, 0.5f, 0.5f)), new RigidPose(new Vector3(4.5f, 0, 0)));
                break;
            case "tiles":
                for (int i = 0; i < 10; i++) scene.Add(half, new RigidPose(new Vector3(i, 0, 0)));
                break;
            case "mesh":
                scene.Add(
                    AnyShape.Surface(TriangleMesh.FromHeights(new float[22], 11, Vector2.One)),
                    new RigidPose(new Vector3(-0.5f, 0.5f, -0.5f)));
                break;
            case "compound":
                scene.Add(Tiles(), RigidPose.Identity);
                break;
            default:
                scene.Add(
                    AnyShape.Solid(Support.ConcaveShapes.Box(new Vector3(5, 0.5f, 0.5f))),
                    new RigidPose(new Vector3(4.5f, 0, 0)));
                break;
        }
    }

    private static AnyShape Tiles()
    {
        var parts = new CompoundPart[10];
        for (int i = 0; i < 10; i++)
            parts[i] = new CompoundPart(ConvexShape.Box(new Vector3(0.5f)), new RigidPose(new Vector3(i, 0, 0)));
        return AnyShape.Of(new CompoundShape(parts));
    }
}
