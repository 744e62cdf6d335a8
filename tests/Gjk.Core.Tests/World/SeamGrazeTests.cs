using Gjk.Core.Tests.Concave;

namespace Gjk.Core.Tests.World;

/// <summary>Flush tiles, of a compound or of a scene, push what touches them straight up: a ball that as good as
/// touches a seam, and a closed mesh that rocks on them or is deep in a small one.</summary>
public class SeamGrazeTests
{
    private readonly ConcaveScratch _scratch = new();
    private readonly List<PairContacts> _contacts = [];

    /// <summary>A ball's way to the edge of the next tile is longer than its gap by next to nothing.</summary>
    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void ABallOverASeam(bool isScene)
    {
        List<CompoundPart> tiles = Tiles(4, 1, _ => 0.5f);
        var ball = AnyShape.Of(ConvexShape.Sphere(0.5f));
        for (int i = 0; i < 400; i++)
        {
            var random = new Rng((ulong)i);
            float aside = MathF.Pow(10, random.Float(-5, -1.7)), gap = MathF.Pow(10, random.Float(-7, -4));
            var at = new RigidPose(new Vector3(i % 2 == 0 ? aside : -aside, 0.5f + gap, 0.3f));
            Find(tiles, isScene, ball, at);
            AssertUp($"{i}: {at}");
        }
    }

    /// <summary>The tiles differ in thickness, so the far corner of one is a tip of its own.</summary>
    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void AClosedBoxThatRocks(bool isScene)
    {
        for (int i = 0; i < 200; i++)
        {
            var random = new Rng((ulong)i);
            var half = new Vector3(random.Float(0.3, 0.6), random.Float(0.3, 0.6), random.Float(0.3, 0.6));
            List<CompoundPart> tiles = Tiles(8, random.Float(0.3, 0.6), _ => random.Float(0.3, 0.7));
            TriangleMesh box = Solids.Box(-half, half);
            Quaternion tilt = Quaternion.CreateFromAxisAngle(Vector3.UnitX, random.Float(-0.01, 0.01));
            Quaternion turn = Quaternion.CreateFromAxisAngle(Vector3.UnitY, random.Float(0, 6)) * tilt;
            float deep = random.Of(0.01f, 0.03f, 0.07f), y = -Solids.Lowest(box, turn) - deep;
            var at = new RigidPose(turn, new Vector3(random.Float(-0.6, 0.6), y, random.Float(-0.6, 0.6)));
            Find(tiles, isScene, AnyShape.Solid(box), at);
            AssertUp($"{i}: {half}, {at}");
        }
    }

    /// <summary>A side of the box is less deep in the tiles than its bottom, and deeper than the gap: what covers the
    /// tiles' sides beyond it is not near that side.</summary>
    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void AClosedBoxDeepInSmallTiles(bool isScene)
    {
        var half = new Vector3(0.45520177f, 0.526333f, 0.47618622f);
        var turn = new Quaternion(0.00020100438f, 0.71261775f, 0.00020417472f, 0.7015525f);
        var at = new RigidPose(turn, new Vector3(-0.41910288f, 0.5065338f, -0.6539098f));
        Find(Tiles(20, 0.22f, _ => 1), isScene, AnyShape.Solid(Solids.Box(-half, half)), at);
        AssertUp($"{at}");
    }

    /// <summary>Square tiles with their tops at the height 0.</summary>
    private static List<CompoundPart> Tiles(int count, float size, Func<int, float> thickness)
    {
        var tiles = new List<CompoundPart>();
        for (int i = 0; i < count * count; i++)
        {
            float high = thickness(i) / 2;
            float x = (i % count + 0.5f) * size - count * size / 2, z = (i / count + 0.5f) * size - count * size / 2;
            var shape = ConvexShape.Box(new Vector3(size / 2, high, size / 2));
            tiles.Add(new CompoundPart(shape, new RigidPose(new Vector3(x, -high, z))));
        }

        return tiles;
    }

    private void Find(List<CompoundPart> tiles, bool isScene, in AnyShape body, in RigidPose at)
    {
        if (!isScene)
        {
            var floor = AnyShape.Of(new CompoundShape(tiles));
            ConcaveQuery.FindContacts(floor, RigidPose.Identity, body, at, 0.01f, _scratch, _contacts);
            return;
        }

        var scene = new CollisionScene();
        foreach (CompoundPart tile in tiles) scene.Add(tile.Shape, tile.Pose, new ObjectSettings(isStatic: true));
        scene.Add(body, at);
        scene.FindContacts(0.01f, _contacts);
    }

    private void AssertUp(string what)
    {
        Assert.NotEmpty(_contacts);
        foreach (PairContacts one in _contacts)
            Assert.True(MathF.Abs(one.Manifold.Normal.Y) > 1 - 1e-7f, $"{what}: {one}");
    }
}
