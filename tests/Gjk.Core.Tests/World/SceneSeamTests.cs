using System.Diagnostics;
using Gjk.Core.Tests.Concave;

namespace Gjk.Core.Tests.World;

/// <summary>Static objects that are flush are one floor to what slides over them, unless the scene is told
/// otherwise.</summary>
public class SceneSeamTests
{
    private const float Reach = 0.02f;

    private readonly List<PairContacts> _contacts = [];

    [Theory]
    [InlineData("boxes")]
    [InlineData("boxes, the body first")]
    [InlineData("fields")]
    public void FlushTilesPushStraightUp(string tiles)
    {
        int kicks = 0;
        for (int i = 0; i < 200; i++)
        {
            var random = new Rng((ulong)i);
            var scene = new CollisionScene();
            bool isFirst = tiles.Contains("first");
            AnyShape body = SeamBodies.Named(i % 2 == 0 ? "ball" : "box");
            Quaternion yaw = Quaternion.CreateFromAxisAngle(Vector3.UnitY, i % 4 == 1 ? 0 : random.Float(0, 6));
            var over = new Vector3(i % 3 == 0 ? 1.5f : random.Float(0.9, 2.1), 0, random.Float(0.9, 2.1));
            RigidPose at = SeamBodies.Placed(body, over, yaw, -random.Of(1e-3f, 5e-3f));
            if (isFirst) scene.Add(body, at);
            AddTiles(scene, tiles, isStatic: true);
            if (!isFirst) scene.Add(body, at);
            scene.FindContacts(Reach, _contacts);
            Assert.True(_contacts.Exists(c => c.Result.Distance < 0), $"{i}: contact lost");
            foreach (PairContacts one in _contacts)
                Assert.True(MathF.Abs(one.Manifold.Normal.Y) > 0.9999f, $"{i}: {one}");
            scene.JoinsStatic = false;
            scene.FindContacts(Reach, _contacts);
            if (_contacts.Exists(c => MathF.Abs(c.Manifold.Normal.Y) < 0.9999f)) kicks++;
        }

        Assert.InRange(kicks, 20, 200);
    }

    /// <summary>A body that the floor holds from below is not pushed along a tile's border under it, however deep it
    /// is.</summary>
    [Theory]
    [InlineData("cylinder", 0.3f, "fields")]
    [InlineData("solid box", 0.2f, "fields")]
    [InlineData("solid box", 0.2f, "solids")]
    [InlineData("box", 0.2f, "solids")]
    [InlineData("capsule", 0.3f, "solids")]
    public void DeepBodiesAreNotPushedAside(string name, float half, string tiles)
    {
        var size = new Vector3(0.5f, half, 0.3f);
        AnyShape body = name switch
        {
            "cylinder" => AnyShape.Of(ConvexShape.Cylinder(0.3f, half)),
            "capsule" => AnyShape.Of(ConvexShape.Capsule(half, 0.3f)),
            "box" => AnyShape.Of(ConvexShape.Box(size)),
            _ => AnyShape.Solid(ConcaveShapes.Box(size)),
        };
        Quaternion own = name is "cylinder" or "capsule"
            ? Quaternion.CreateFromAxisAngle(Vector3.UnitZ, MathF.PI / 2)
            : Quaternion.Identity;
        for (int i = 0; i < 200; i++)
        {
            var random = new Rng((ulong)i);
            float depth = random.Of(1e-3f, 0.02f, 0.1f);
            Quaternion turn = Quaternion.CreateFromAxisAngle(Vector3.UnitY, random.Float(0, 6.3)) * own;
            float x = i % 3 == 0 ? 1.5f : random.Float(1.1, 1.9);
            var scene = new CollisionScene();
            AddTiles(scene, tiles, isStatic: true);
            scene.Add(body, new RigidPose(turn, new Vector3(x, half - depth, random.Float(1.1, 1.9))));
            scene.FindContacts(random.Of(0, Reach), _contacts);
            Assert.Contains(_contacts, c => c.Result.Distance < -0.99f * depth);
            foreach (PairContacts one in _contacts)
            {
                Assert.True(one.Manifold.Normal.Y > 0.9999f, $"{name} {i}, {depth} deep: {one}");
                Assert.True(one.Result.Distance > -1.01f * depth, $"{name} {i}, {depth} deep: {one}");
            }
        }
    }

    /// <summary>Objects that are joined keep their answers while they rest, and only so long.</summary>
    [Fact]
    public void AnswersAreKeptWhileTheFloorIsTheSame()
    {
        var scene = new CollisionScene();
        AnyShape tile = AnyShape.Of(ConvexShape.Box(new Vector3(0.5f, 0.1f, 0.5f)));
        var still = new ObjectSettings(isStatic: true);
        int left = scene.Add(tile, new RigidPose(new Vector3(-0.5f, -0.1f, 0)), still);
        int right = scene.Add(tile, new RigidPose(new Vector3(0.5f, -0.1f, 0)), still);
        scene.Add(ConvexShape.Box(new Vector3(0.3f, 0.2f, 0.3f)), new RigidPose(new Vector3(0.25f, 0.1f, 0)));
        for (int i = 0; i < 3; i++)
        {
            scene.JoinsStatic = i != 1;
            for (int k = 0; k < 2; k++)
            {
                scene.FindContacts(Reach, _contacts);
                Assert.Equal(i != 1, _contacts.TrueForAll(c => c.Manifold.Normal.Y > 0.9999f));
                Assert.Equal([left, right], _contacts.ConvertAll(c => c.Pair.A));
            }
        }

        scene.Remove(right);
        scene.FindContacts(Reach, _contacts);
        Assert.Equal([left], _contacts.ConvertAll(c => c.Pair.A));
        ContactManifold alone = default;
        ConvexQuery.Contacts(
            tile.Convex, scene.GetPose(left), ConvexShape.Box(new Vector3(0.3f, 0.2f, 0.3f)),
            new RigidPose(new Vector3(0.25f, 0.1f, 0)), Reach, out alone);
        Assert.Equal(alone, _contacts[0].Manifold);
    }

    [Fact]
    public void ObjectsThatMoveAreNotJoined()
    {
        var scene = new CollisionScene();
        AddTiles(scene, "boxes", isStatic: false);
        AnyShape ball = SeamBodies.Named("ball");
        int id = scene.Add(ball, SeamBodies.Placed(ball, new Vector3(1.48f, 0, 1.2f), Quaternion.Identity, -0.005f));
        scene.FindContacts(Reach, _contacts);
        Assert.Contains(_contacts, c => c.Pair.B == id && c.Manifold.Normal.Y < 0.9999f);
    }

    /// <summary>A wall at the end of a floor, flush with its end and higher, keeps its push.</summary>
    [Fact]
    public void AWallKeepsItsContacts()
    {
        var scene = new CollisionScene();
        var still = new ObjectSettings(isStatic: true);
        scene.Add(ConvexShape.Box(new Vector3(1, 0.5f, 1)), new RigidPose(new Vector3(0, -0.5f, 0)), still);
        scene.Add(ConvexShape.Box(new Vector3(0.5f, 2, 1)), new RigidPose(new Vector3(1.5f, 0, 0)), still);
        scene.Add(ConvexShape.Sphere(0.3f), new RigidPose(new Vector3(0.705f, 0.295f, 0)));
        scene.FindContacts(Reach, _contacts);
        Assert.Contains(_contacts, c => c.Manifold.Normal.Y > 0.999f);
        Assert.Contains(_contacts, c => c.Manifold.Normal.X < -0.999f);
        Assert.Equal(2, _contacts.Count);
    }

    /// <summary>A keel on two flush boxes: a side of it that crosses the seam is not pushed along, as the box that it
    /// begins in goes on.</summary>
    [Fact]
    public void BoxesPushASolidAsACompoundDoes()
    {
        Vector3[] profile = [new(-0.25f, 0, 1), new(0.25f, 0, 1), new(1.25f, 0.5f, 1), new(-1.25f, 0.5f, 1)];
        int[] indices = [0, 1, 2, 0, 2, 3, 4, 6, 5, 4, 7, 6, 0, 4, 5, 0, 5, 1, 1, 5, 6, 1, 6, 2, 2, 6, 7, 2, 7, 3, 3, 7,
            4, 3, 4, 0];
        var keel = new TriangleMesh([.. profile, .. profile.Select(v => v with { Z = -1 })], indices);
        const float Depth = 0.037417915f;
        var scene = new CollisionScene();
        scene.Add(AnyShape.Solid(keel), new RigidPose(new Vector3(-0.2683233f, -Depth, 0.18019593f)));
        foreach (float x in new[] { -2f, 2 })
        {
            scene.Add(
                ConvexShape.Box(new Vector3(2, 1, 4)), new RigidPose(new Vector3(x, -1, 0)),
                new ObjectSettings(isStatic: true));
        }

        scene.FindContacts(0.01f, _contacts);
        Assert.NotEmpty(_contacts);
        foreach (PairContacts one in _contacts)
        {
            Assert.True(one.Manifold.Normal.Y < -0.9999f, $"{one}");
            Assert.InRange(one.Manifold[0].Gap, -Depth - 1e-6f, 0);
        }
    }

    /// <summary>Tiles are asked only where a contact is: to join 576 costs about as much as their contacts, and not a
    /// hundred times that.</summary>
    [Fact]
    public void ManyTilesCostAsMuchAsTheirContacts()
    {
        AnyShape tile = AnyShape.Surface(TriangleMesh.FromHeights(new float[4], 2, new Vector2(0.125f)));
        var scene = new CollisionScene();
        int id = scene.Add(ConvexShape.Box(new Vector3(1, 0.6f, 0.8f)), RigidPose.Identity);
        for (int i = 0; i < 576; i++)
        {
            var at = new Vector3(i / 24 - 12, 0, i % 24 - 12);
            scene.Add(tile, new RigidPose(0.125f * at), new ObjectSettings(isStatic: true));
        }

        double[] least = [double.MaxValue, double.MaxValue];
        for (int i = 0; i < 20; i++)
        {
            scene.JoinsStatic = i % 2 == 1;
            scene.Move(id, new RigidPose(new Vector3(0.05f + 1e-3f * i, 0.599f, 0.03f)));
            long start = Stopwatch.GetTimestamp();
            scene.FindContacts(Reach, _contacts);
            least[i % 2] = Math.Min(least[i % 2], Stopwatch.GetTimestamp() - start);
        }

        Assert.True(_contacts.Count > 400);
        Assert.True(least[1] < 25 * least[0], $"{least[1]} against {least[0]} ticks");
    }

    [Fact]
    public void WarmCallsAllocateNothing()
    {
        var scene = new CollisionScene();
        AddTiles(scene, "boxes", isStatic: true);
        AnyShape ball = SeamBodies.Named("ball");
        scene.Add(ball, SeamBodies.Placed(ball, new Vector3(1.48f, 0, 1.2f), Quaternion.Identity, -0.005f));
        Assert.Equal(0, Allocation.Least(() => scene.FindContacts(Reach, _contacts)));
        Assert.NotEmpty(_contacts);
    }

    private static void AddTiles(CollisionScene scene, string tiles, bool isStatic)
    {
        var settings = new ObjectSettings(isStatic: isStatic, mask: isStatic ? uint.MaxValue : 2 | 1);
        AnyShape field = AnyShape.Surface(TriangleMesh.FromHeights(new float[9], 3, new Vector2(0.25f)));
        AnyShape solid = AnyShape.Solid(ConcaveShapes.Box(new Vector3(0.25f, 0.2f, 0.25f)));
        foreach (CompoundPart tile in Floors.Tiles(0))
        {
            Vector3 low = tile.Pose.Position + new Vector3(-0.25f, 0.2f, -0.25f);
            if (tiles == "solids") scene.Add(solid, tile.Pose, settings);
            else if (tiles == "fields") scene.Add(field, new RigidPose(low), settings);
            else scene.Add(tile.Shape, tile.Pose, settings);
        }
    }
}
