namespace Gjk.Core.Tests.World;

/// <summary>A body that lies on flat flush ground, tilted by a little, is held at each of its corners, whichever part
/// of the ground or of the body is there.</summary>
public class SeamCornerTests
{
    private const float Reach = 0.02f;

    private readonly List<PairContacts> _contacts = [];

    [Theory]
    [InlineData("tiles", "box")]
    [InlineData("tiles", "flush boxes")]
    [InlineData("strips", "box")]
    [InlineData("one box", "flush boxes")]
    [InlineData("compound", "box")]
    [InlineData("fields", "box")]
    public void EachCornerOverFlushGroundIsHeld(string ground, string body)
    {
        for (int i = 0; i < 120; i++)
        {
            var random = new Rng((ulong)i);
            float size = random.Of(0.01f, 1, 100), tilt = random.Of(0, 1e-7f, 1e-5f, 1e-4f, 1e-3f);
            var half = size * new Vector3(random.Float(0.3, 0.6), random.Float(0.2, 0.6), random.Float(0.3, 0.6));
            var axis = Vector3.Normalize(new Vector3(random.Float(-1, 1), 0, random.Float(-1, 1)));
            Quaternion turn = Quaternion.CreateFromAxisAngle(axis, tilt)
                * Quaternion.CreateFromAxisAngle(Vector3.UnitY, i % 4 == 0 ? 0 : random.Float(0, 6));
            Vector3[] corners = [.. Enumerable.Range(0, 4).Select(c => Vector3.Transform(
                half * new Vector3(c % 2 == 0 ? 1 : -1, -1, c < 2 ? 1 : -1), turn))];
            float depth = size * random.Of(-2e-3f, 1e-4f, 1e-3f);
            var at = new Vector3(
                size * random.Float(-0.4, 0.4), -depth - corners.Min(c => c.Y), size * random.Float(-0.4, 0.4));
            var scene = new CollisionScene();
            AddGround(scene, ground, size);
            scene.Add(Body(body, half), new RigidPose(turn, at));
            scene.FindContacts(Reach * size, _contacts);
            foreach (PairContacts one in _contacts)
                Assert.True(one.Manifold.Normal.Y > 0.999999f - tilt, $"{i}: {one}");
            foreach (Vector3 corner in corners)
            {
                Vector3 place = corner + at;
                if (place.Y > Reach * size / 2) continue;
                Assert.True(_contacts.Exists(c => IsNear(c.Manifold, place, 0.1f * size)), $"{i}: {place} falls");
            }
        }
    }

    /// <summary>An edge that is nearer to the seam than it is deep is lifted by all of its depth.</summary>
    [Theory]
    [InlineData("tiles")]
    [InlineData("compound")]
    [InlineData("fields")]
    public void AnEdgeBesideASeamIsLifted(string ground)
    {
        foreach (float lean in new[] { 0.1f, 0.4f })
        {
            foreach (float depth in new[] { 1e-5f, 1e-3f, 5e-3f })
            {
                foreach (float beside in new[] { 0.1f, 0.25f, 0.75f, 0.95f })
                {
                    Quaternion turn = Quaternion.CreateFromAxisAngle(Vector3.UnitX, lean);
                    Vector3 edge = Vector3.Transform(new Vector3(0, -0.5f, 0.5f), turn);
                    if (Vector3.Transform(new Vector3(0, -0.5f, -0.5f), turn).Y < edge.Y)
                        edge = Vector3.Transform(new Vector3(0, -0.5f, -0.5f), turn);
                    var scene = new CollisionScene();
                    AddGround(scene, ground, 1);
                    var at = new Vector3(0.1f, -depth - edge.Y, (beside * depth) - edge.Z);
                    scene.Add(ConvexShape.Box(new Vector3(0.5f)), new RigidPose(turn, at));
                    scene.FindContacts(0.01f, _contacts);
                    float lift = 0;
                    foreach (PairContacts one in _contacts)
                    {
                        Assert.True(one.Manifold.Normal.Y > 0.999999f, $"{lean} {depth} {beside}: {one}");
                        lift = MathF.Max(lift, -one.Result.Distance);
                    }

                    Assert.InRange(lift, 0.99f * depth - 1e-6f, 1.01f * depth + 1e-6f);
                }
            }
        }
    }

    private static bool IsNear(in ContactManifold manifold, Vector3 place, float room)
    {
        for (int i = 0; i < manifold.Count; i++)
            if (Vector3.Distance(manifold[i].PointB, place) < room) return true;
        return false;
    }

    private static AnyShape Body(string body, Vector3 half)
    {
        if (body == "box") return AnyShape.Of(ConvexShape.Box(half));
        var part = ConvexShape.Box(half * new Vector3(0.5f, 1, 1));
        return AnyShape.Of(new CompoundShape(
        [
            new CompoundPart(part, new RigidPose(new Vector3(-half.X / 2, 0, 0))),
            new CompoundPart(part, new RigidPose(new Vector3(half.X / 2, 0, 0))),
        ]));
    }

    private static void AddGround(CollisionScene scene, string ground, float size)
    {
        var still = new ObjectSettings(isStatic: true);
        (int countX, int countZ) = ground == "one box" ? (1, 1) : ground == "strips" ? (1, 2) : (2, 2);
        var half = size * new Vector3(2f / countX, 0.5f, 2f / countZ);
        var parts = new List<CompoundPart>();
        for (int x = 0; x < countX; x++)
        {
            for (int z = 0; z < countZ; z++)
            {
                var corner = new Vector3((2 * half.X * x) - (2 * size), 0, (2 * half.Z * z) - (2 * size));
                parts.Add(new CompoundPart(
                    ConvexShape.Box(half), new RigidPose(corner + new Vector3(half.X, -half.Y, half.Z))));
                if (ground == "fields")
                {
                    TriangleMesh field = TriangleMesh.FromHeights(new float[9], 3, new Vector2(half.X, half.Z));
                    scene.Add(AnyShape.Surface(field), new RigidPose(corner), still);
                }
                else if (ground != "compound")
                {
                    scene.Add(parts[^1].Shape, parts[^1].Pose, still);
                }
            }
        }

        if (ground == "compound") scene.Add(AnyShape.Of(new CompoundShape(parts)), RigidPose.Identity, still);
    }
}
