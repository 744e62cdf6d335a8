namespace Gjk.Core.Tests.Concave;

/// <summary>What is in the ground is pushed out of it, and nothing holds it down.</summary>
public class HeldTests
{
    private const float Reach = 0.01f;
    private readonly ConcaveScratch _scratch = new();
    private readonly List<PairContacts> _contacts = [];

    [Theory]
    [InlineData(0.02f)]
    [InlineData(0.05f)]
    [InlineData(0.1f)]
    [InlineData(0.2f)]
    public void AWheelInAFieldIsLifted(float depth)
    {
        AnyShape wheel = AnyShape.Of(ConvexShape.Cylinder(0.35f, 0.12f).Placed(
            new RigidPose(Quaternion.CreateFromAxisAngle(Vector3.UnitX, MathF.PI / 2), Vector3.Zero)));
        for (int seed = 0; seed < 400; seed++)
        {
            var random = new Rng((ulong)seed);
            AnyShape field = Field(9, 0.5f, seed % 3 == 0 ? 0 : 0.06f, random);

            // Over lines of the grid and along them, as well as anywhere.
            Quaternion yaw = Quaternion.CreateFromAxisAngle(
                Vector3.UnitY, seed % 2 == 0 ? seed % 8 * MathF.PI / 8 : random.Float(0, 6));
            var start = new Vector3(
                seed % 5 == 0 ? 2 : random.Float(1.7, 2.3), 3, seed % 7 == 0 ? 2 : random.Float(1.7, 2.3));
            RigidPose at = Sunk(field, wheel, new RigidPose(yaw, start), depth);
            ConcaveQuery.FindContacts(field, RigidPose.Identity, wheel, at, Reach, _scratch, _contacts);
            AssertLifted($"{seed}", depth);
        }
    }

    /// <summary>Deeper than half its width it is nearer to the sides that the boxes share than to their tops.</summary>
    [Theory]
    [InlineData(2f, 0.15f)]
    [InlineData(2f, 0.2f)]
    [InlineData(2f, 0.35f)]
    [InlineData(0.5f, 0.2f)]
    public void AWheelOverTheSeamOfBoxesIsLifted(float half, float depth)
    {
        var box = ConvexShape.Box(new Vector3(half, 1, 2));
        var wheel = ConvexShape.Cylinder(0.8f, 0.15f);
        Quaternion lying = Quaternion.CreateFromAxisAngle(Vector3.UnitZ, MathF.PI / 2);
        for (int seed = 0; seed < 100; seed++)
        {
            var random = new Rng((ulong)seed);
            float off = seed % 3 == 0 ? 0 : random.Float(-0.05, 0.05);
            Quaternion yaw = Quaternion.CreateFromAxisAngle(Vector3.UnitY, random.Float(0, 6));
            RigidPose floor = seed % 4 == 0 ? RigidPose.Identity : new RigidPose(yaw, new Vector3(2, 0, 1));
            RigidPose left = Placed(floor, new Vector3(-half, -1, 0), Quaternion.Identity);
            RigidPose right = Placed(floor, new Vector3(half, -1, 0), Quaternion.Identity);
            RigidPose at = Placed(floor, new Vector3(off, 0.8f - depth, random.Float(-0.5, 0.5)), lying);
            AnyShape both = AnyShape.Of(new CompoundShape([new(box, left), new(box, right)]));
            ConcaveQuery.FindContacts(both, RigidPose.Identity, AnyShape.Of(wheel), at, Reach, _scratch, _contacts);
            AssertUp($"compound {seed}", depth, 1);
            var scene = new CollisionScene();
            var still = new ObjectSettings(isStatic: true);
            scene.Add(box, left, still);
            scene.Add(box, right, still);
            scene.FindContacts(wheel, at, Reach, _contacts);
            AssertUp($"scene {seed}", depth, -1);
        }
    }

    [Theory]
    [InlineData("ball", 0f)]
    [InlineData("ball", 0.1f)]
    [InlineData("gear", 0f)]
    [InlineData("rock", 0f)]
    [InlineData("ring", 0f)]
    public void ASolidMeshOnFlatGroundIsPushedUpOnly(string name, float more)
    {
        AnyShape[] grounds =
        [
            AnyShape.Surface(TriangleMesh.FromHeights(new float[121], 11, new Vector2(0.5f))),
            AnyShape.Surface(TriangleMesh.FromHeights(new float[81 * 81], 81, new Vector2(0.0625f))),
            AnyShape.Solid(Solids.Box(new Vector3(0, -2, 0), new Vector3(5, 0, 5))),
            AnyShape.Of(ConvexShape.Box(new Vector3(2.5f, 1, 2.5f)).Placed(new RigidPose(new Vector3(2.5f, -1, 2.5f)))),
        ];
        for (int seed = 0; seed < 40; seed++)
        {
            var random = new Rng((ulong)seed);
            TriangleMesh mesh = Solids.Named(name, seed);
            if (seed % 4 == 3) mesh = mesh.Scaled(new Vector3(-1, 1, 1));
            AnyShape body = AnyShape.Solid(mesh);
            Quaternion turn = random.Rotation();
            float depth = more > 0 ? more : random.Of(1e-4f, 2e-3f, 0.01f);
            var at = new RigidPose(
                turn, new Vector3(random.Float(2, 3), -Solids.Lowest(mesh, turn) - depth, random.Float(2, 3)));
            foreach (AnyShape ground in grounds)
            {
                ConcaveQuery.FindContacts(ground, RigidPose.Identity, body, at, Reach, _scratch, _contacts);
                AssertLifted($"{seed}, {ground.Kind}", depth);
                foreach (PairContacts one in _contacts)
                    Assert.True(one.Manifold.Normal.Y > 0.99f || one.Result.Distance > 0, $"{seed}: {one}");
            }
        }
    }

    [Theory]
    [InlineData(2e-3f)]
    [InlineData(0.02f)]
    public void SolidsComeOutAsTheyCameIn(float depth)
    {
        int found = 0;
        for (int seed = 0; seed < 100; seed++)
        {
            var random = new Rng((ulong)seed);
            AnyShape a = AnyShape.Solid(Solids.Named("rock", seed));
            AnyShape b = AnyShape.Solid(Solids.Named("rock", 999 - seed));
            Vector3 way = Vector3.Normalize(random.Vector(1));
            var start = new RigidPose(random.Rotation(), -3 * way);
            CastHit hit = ConcaveQuery.Cast(a, RigidPose.Identity, default, b, start, 4 * way, _scratch);
            if (!hit.IsHit) continue;
            found++;
            var at = new RigidPose(start.Rotation, start.Position + way * (4 * hit.Fraction + depth));
            ConcaveQuery.FindContacts(a, RigidPose.Identity, b, at, Reach, _scratch, _contacts);
            float back = 0;
            foreach (PairContacts one in _contacts)
            {
                float along = -Vector3.Dot(one.Manifold.Normal, way);
                if (one.Result.Distance >= 0) continue;
                Assert.True(along > -0.2f, $"{seed}: {one} pushes on along {way}");
                if (along > 0.05f) back = Math.Max(back, -one.Result.Distance / along);
            }

            Assert.True(back > 0.3f * depth, $"{seed}: {back} of {depth}");
        }

        Assert.InRange(found, 50, 100);
    }

    /// <summary>Pieces of one mesh: a solid ball, one that is turned inside out, and a hollow one's cavity.</summary>
    [Fact]
    public void EachPieceHasItsOwnOutside()
    {
        TriangleMesh one = Solids.Named("ball", 0), other = Solids.Flipped(one);
        TriangleMesh both = Solids.Joined((one, Vector3.Zero), (other, new Vector3(3, 0, 0)));
        TriangleMesh hollow = Solids.Joined((Solids.Scaled(one, 4), Vector3.Zero), (other, Vector3.Zero));
        foreach (Vector3 scale in new[] { Vector3.One, new Vector3(1, -1, 1) })
        {
            TriangleMesh two = both.Scaled(scale), shell = hollow.Scaled(scale);
            int mirror = Solids.Sign(one) * (scale.Y < 0 ? -1 : 1);
            for (int i = 0; i < two.TriangleCount; i++)
                Assert.Equal(i < one.TriangleCount ? mirror : -mirror, two.OutwardOf(i));
            for (int i = 0; i < shell.TriangleCount; i++) Assert.Equal(mirror, shell.OutwardOf(i));
        }
    }

    private RigidPose Sunk(in AnyShape ground, in AnyShape body, in RigidPose high, float depth)
    {
        CastHit hit = ConcaveQuery.Cast(
            ground, RigidPose.Identity, default, body, high, new Vector3(0, -4, 0), _scratch);
        Assert.True(hit.IsHit);
        return new RigidPose(high.Rotation, high.Position - new Vector3(0, 4 * hit.Fraction + depth, 0));
    }

    /// <summary>A push along a wall that is only touched does not take the body away from it. The box has its middle in
    /// a floor, leaves one fin at its side and one at its middle, and touches a wall with its back.</summary>
    [Fact]
    public void AWallThatIsOnlyTouchedKeepsItsContact()
    {
        var mesh = new TriangleMesh(
            [
                new(0.5f, 0, 0), new(0.5f, 0.25f, 0.3f), new(0.5f, 0, 0.3f),
                new(0.75f, 0, 0), new(0.75f, 0.25f, 0.3f), new(0.75f, 0, 0.3f), new(1, 0, 0), new(1, 0, 0.3f),
                new(0, -0.25f, 0), new(1, -0.25f, 0),
            ],
            [0, 1, 2, 3, 4, 5, 3, 6, 7, 3, 7, 5, 8, 9, 6]);
        var box = AnyShape.Of(ConvexShape.Box(new Vector3(0.25f)));
        var at = new RigidPose(new Quaternion(0, 1, 0, 0), new Vector3(0.75f, 0, 0.25f));
        AnyShape surface = AnyShape.Surface(mesh);
        Assert.True(ConcaveQuery.FindContacts(surface, RigidPose.Identity, box, at, 0, _scratch, _contacts));
        PairContacts wall = Assert.Single(_contacts, one => one.PartA == 4);
        Assert.Equal((Vector3.UnitZ, 0, 4), (wall.Manifold.Normal, wall.Result.Distance, wall.Manifold.Count));
    }

    private static RigidPose Placed(in RigidPose floor, Vector3 at, Quaternion turn) =>
        new(floor.Rotation * turn, floor.Position + Vector3.Transform(at, floor.Rotation));

    private void AssertUp(string where, float depth, float sign)
    {
        Assert.True(_contacts.Count > 0, $"{where}: contact lost");
        foreach (PairContacts one in _contacts)
        {
            Assert.True(sign * one.Manifold.Normal.Y > 0.99999f, $"{where}: {one}");
            Assert.True(MathF.Abs(one.Result.Distance + depth) < 1e-4f, $"{where}: {one}");
        }
    }

    private void AssertLifted(string where, float depth)
    {
        float lift = 0;
        foreach (PairContacts one in _contacts)
            if (one.Manifold.Normal.Y > 0.5f) lift = Math.Max(lift, -one.Result.Distance / one.Manifold.Normal.Y);
        Assert.True(lift > 0.4f * depth - 1e-5f, $"{where}: {lift} of {depth}; {string.Join("; ", _contacts)}");
    }

    private static AnyShape Field(int n, float cell, float rough, Rng random)
    {
        float[] heights = new float[n * n];
        for (int i = 0; i < heights.Length; i++) heights[i] = random.Float(-rough, rough);
        return AnyShape.Surface(TriangleMesh.FromHeights(heights, n, new Vector2(cell)));
    }
}
