using Gjk.Core.Tests.Concave;

namespace Gjk.Core.Tests.World;

/// <summary>Static tiles that are flush but for what float makes of their places, a thousand times their size from the
/// origin: what stands or rolls on them is pushed up.</summary>
public class FarTilesTests
{
    private const int Tiles = 7;

    [Theory]
    [InlineData("ball")]
    [InlineData("box")]
    [InlineData("wheel")]
    public void TheyPushUp(string name)
    {
        var contacts = new List<PairContacts>();
        for (int i = 0; i < 100; i++)
        {
            var random = new Rng((ulong)i);
            float size = random.Float(0.1, 0.3), depth = random.Of(1e-3f, 5e-3f, 2e-2f);
            var far = new Vector3(random.Float(-300, 300), random.Float(-300, 300), random.Float(-300, 300));
            var scene = new CollisionScene();
            var tile = ConvexShape.Box(new Vector3(size / 2, 0.1f, size / 2));
            for (int x = 0; x < Tiles; x++)
            {
                for (int z = 0; z < Tiles; z++)
                {
                    var at = new Vector3((x - 3) * size, -0.1f, (z - 3) * size);
                    scene.Add(tile, new RigidPose(far + at), new ObjectSettings(isStatic: true));
                }
            }

            Quaternion yaw = Quaternion.CreateFromAxisAngle(Vector3.UnitY, random.Float(0, 6));
            Quaternion lying = Quaternion.CreateFromAxisAngle(Vector3.UnitZ, MathF.PI / 2);
            AnyShape body = name == "wheel" ? AnyShape.Of(ConvexShape.Cylinder(0.5f, 0.2f)) : SeamBodies.Named(name);
            Quaternion turn = name == "wheel" ? yaw * lying : yaw;
            var over = new Vector3(i % 3 == 0 ? size / 2 : random.Float(-0.2, 0.2), 0, random.Float(-0.2, 0.2));
            RigidPose near = SeamBodies.Placed(body, over, turn, -depth);
            scene.Add(body, new RigidPose(near.Rotation, near.Position + far));
            scene.FindContacts(0.02f, contacts);
            Assert.Contains(contacts, c => c.Result.Distance < 0);

            // A kerb that float makes is 5e-5 high, and a contact is as long as a tile.
            foreach (PairContacts one in contacts)
                Assert.True(MathF.Abs(one.Manifold.Normal.Y) > 0.9999f, $"{name} {i}: {one}");
        }
    }
}
