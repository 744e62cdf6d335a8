namespace Gjk.Core.Tests.Concave;

/// <summary>Contacts, moves and scenes of compounds with solids among their children.</summary>
public class SolidChildContactTests
{
    private const int Seeds = 250;

    private static readonly RigidPose s_here = RigidPose.Identity;

    private readonly ConcaveScratch _scratch = new();

    /// <summary>A body that is sunk in a solid child's face is pushed out of it however deep it is, as out of the solid
    /// alone.</summary>
    [Theory]
    [InlineData(0.01f)]
    [InlineData(0.1f)]
    [InlineData(0.3f)]
    [InlineData(0.39f)]
    public void ContactsPushOutwardOnly(float deep)
    {
        var own = new RigidPose(Quaternion.Normalize(new Quaternion(0, 0.3f, 0, 0.9f)), new Vector3(1, 2, 3));
        var solid = AnyShape.Solid(ConcaveShapes.Box(new Vector3(1, 0.5f, 1)));
        AnyShape laid = AnyShape.Of(new CompoundShape([
            new(ConvexShape.Sphere(0.5f), new RigidPose(new Vector3(9, 0, 0))), new(solid, own)]));
        AnyShape[] bodies =
        [
            AnyShape.Of(ConvexShape.Box(new Vector3(0.3f, 0.2f, 0.3f))), AnyShape.Of(ConvexShape.Sphere(0.2f)),
            AnyShape.Of(new CompoundShape([
                new(AnyShape.Solid(ConcaveShapes.Box(new Vector3(0.3f, 0.2f, 0.3f))), s_here)])),
        ];
        foreach (AnyShape body in bodies)
        {
            RigidPose at = SolidChildren.Within(own, new RigidPose(new Vector3(0.1f, 0.7f - deep, 0.2f)));
            List<PairContacts> contacts = [], alone = [];
            Assert.True(ConcaveQuery.FindContacts(laid, s_here, body, at, 0.01f, _scratch, contacts));
            Assert.True(ConcaveQuery.FindContacts(solid, own, body, at, 0.01f, _scratch, alone));
            Assert.NotEmpty(contacts);
            Assert.NotEmpty(alone);
            Assert.All(contacts, one => Assert.True(one.Manifold.Normal.Y > 0.999f, $"{body}: {one}"));
            float depth = contacts.Min(one => one.Result.Distance), only = alone.Min(one => one.Result.Distance);
            Assert.True(Math.Abs(depth + deep) < 1e-5f, $"{body}: {depth}, alone {only}");
        }
    }

    /// <summary>Where four solid tiles meet, their walls' triangles have slanting edges; only the floor's own points
    /// count.</summary>
    [Fact]
    public void EveryPointOnSolidTilesIsOnTheirTop()
    {
        var tile = AnyShape.Solid(ConcaveShapes.Box(new Vector3(1, 0.2f, 1)));
        var parts = new CompoundPart[4];
        var scene = new CollisionScene();
        for (int i = 0; i < 4; i++)
        {
            var at = new RigidPose(new Vector3(i % 2 == 0 ? -1 : 1, -0.2f, i < 2 ? -1 : 1));
            parts[i] = new CompoundPart(tile, at);
            scene.Add(tile, at, new ObjectSettings(isStatic: true));
        }

        AnyShape floor = AnyShape.Of(new CompoundShape(parts)), body = AnyShape.Of(ConvexShape.Box(new Vector3(0.5f)));
        List<PairContacts> contacts = [];
        for (int seed = 0; seed < 1000; seed++)
        {
            var random = new Rng((ulong)seed);
            Quaternion yaw = Quaternion.CreateFromAxisAngle(Vector3.UnitY, random.Float(0, 6.3));
            float depth = random.Float(0.001, 0.05);
            var at = new RigidPose(yaw, new Vector3(random.Float(-0.3, 0.3), 0.5f - depth, random.Float(-0.3, 0.3)));
            Assert.True(ConcaveQuery.FindContacts(floor, s_here, body, at, 0.01f, _scratch, contacts));
            AssertAllAre(-depth, contacts, $"compound {seed}");
            scene.FindContacts(body.Convex, at, 0.01f, contacts);
            AssertAllAre(-depth, contacts, $"scene {seed}");
        }
    }

    private static void AssertAllAre(float gap, List<PairContacts> contacts, string where)
    {
        Assert.True(contacts.Count > 0, $"{where}: contact lost");
        foreach (PairContacts one in contacts)
            for (int k = 0; k < one.Manifold.Count; k++)
                Assert.True(Math.Abs(one.Manifold[k].Gap - gap) < 1e-5f, $"{where}: {one}");
    }

    /// <summary>A contact along the other body's face names the triangle at its tip, which may look aside; of a solid
    /// alone 2 % do so here.</summary>
    [Fact]
    public void FewContactsNameATriangleThatLooksAside()
    {
        int all = 0, aside = 0;
        for (int seed = 0; seed < Seeds; seed++)
        {
            (SolidChildren a, RigidPose poseA, AnyShape b, RigidPose poseB, _) = SolidChildren.Setup(seed);
            List<PairContacts> contacts = [];
            Assert.True(ConcaveQuery.FindContacts(a.Shape, poseA, b, poseB, 0.05f, _scratch, contacts));
            var side = new PartSide();
            side.TrySet(a.Shape, poseA);
            foreach (PairContacts one in contacts)
            {
                if (!side.TryGetOutward(one.PartA, out Double3 outward, out _)) continue;
                if (Double3.Dot(outward, one.Manifold.Normal) < -1e-3) aside++;
                all++;
            }
        }

        Assert.InRange(all, Seeds / 2, 100 * Seeds);
        Assert.InRange(aside, 0, all / 10);
    }

    [Fact]
    public void MovedSolidsAreThoseOfANewCompound()
    {
        for (int seed = 0; seed < Seeds / 5; seed++)
        {
            var random = new Rng((ulong)seed);
            var children = new CompoundPart[2 + random.Below(3)];
            for (int i = 0; i < children.Length; i++)
                children[i] = new CompoundPart(SolidChildren.Any(random, 1).Shape, ConcaveShapes.Pose(random, 1));
            Vector3 scale = seed % 3 == 0 ? random.Factors(0.5, 2) : Vector3.One;
            CompoundShape moved = new CompoundShape(children).Scaled(scale);
            for (int i = 0; i < children.Length; i++)
            {
                children[i] = new CompoundPart(children[i].Shape, ConcaveShapes.Pose(random, 1));
                moved = moved.WithPose(i, children[i].Pose);
            }

            AnyShape built = AnyShape.Of(new CompoundShape(children).Scaled(scale)), same = AnyShape.Of(moved);
            RigidPose at = ConcaveShapes.Pose(random, 1);
            AnyShape ball = AnyShape.Of(ConvexShape.Sphere(0.02f));
            string[] expected = ConcaveAnswers.Of(_scratch, built, s_here, ball, at);
            Assert.Equal(expected[1..], ConcaveAnswers.Of(_scratch, same, s_here, ball, at)[1..]);
        }
    }

    /// <summary>Solid ground with a box on it, and a body in each and above them; the ground changes, the compound
    /// does not.</summary>
    [Fact]
    public void GroundThatIsSolidDownToItsBaseIsAChild()
    {
        TriangleMesh ground = TriangleMesh.FromHeights(new float[9], 3, Vector2.One, baseHeight: -2);
        var laid = new CompoundShape([
            new(AnyShape.Solid(ground), s_here), new(ConvexShape.Box(Vector3.One), new RigidPose(Vector3.UnitY))]);
        ground.HeightField!.SetHeights(0, 0, 3, Enumerable.Repeat(-1.5f, 9).ToArray());
        Vector3[] points = [new(1.5f, -1, 1.5f), new(0.5f, 1, 0.5f), new(1.5f, 0.5f, 1.5f), new(1, -2.5f, 1)];
        var scene = new CollisionScene();
        scene.Add(AnyShape.Of(laid), s_here);
        for (int i = 0; i < points.Length; i++)
        {
            Assert.Equal(i < 2, ConcaveQuery.Contains(AnyShape.Of(laid), s_here, points[i], _scratch));
            int ball = scene.Add(ConvexShape.Sphere(0.05f), new RigidPose(points[i]));
            List<ObjectPair> pairs = [];
            scene.FindOverlaps(pairs);
            Assert.Equal(i < 2, pairs.Count > 0);
            scene.Remove(ball);
            bool isIn = scene.TryFindRayHit(new RayQuery(points[i], -Vector3.UnitZ, 0), out RayHit hit);
            Assert.Equal((i < 2, i < 2), (isIn, hit.Status == CastStatus.OverlappingAtStart));
        }

        CastHit way = ConcaveQuery.Cast(
            AnyShape.Of(laid), s_here, default, AnyShape.Of(ConvexShape.Sphere(0.05f)), new RigidPose(points[0]),
            Vector3.UnitX, _scratch);
        Assert.Equal(0.55f, way.Result.Depth, 1e-6f);
    }

    [Fact]
    public void QueriesAllocateNothing()
    {
        (SolidChildren a, RigidPose poseA, _, RigidPose poseB, _) = SolidChildren.Setup(2);
        AnyShape shape = a.Shape, ball = AnyShape.Of(ConvexShape.Sphere(0.1f)), other = SolidChildren.Any(
            new Rng(5), 1).Shape;
        List<PairContacts> contacts = [];
        List<CastHit> hits = [];
        List<RayHit> rays = [];
        RigidPose inside = SolidChildren.Within(poseA, a.Leaves[0].Pose);
        long bytes = Allocation.Least(() =>
        {
            ConcaveQuery.Distance(shape, poseA, ball, inside, _scratch);
            ConcaveQuery.Cast(shape, poseA, default, other, inside, Vector3.One, _scratch);
            ConcaveQuery.CastAll(shape, poseA, default, ball, inside, Vector3.One, _scratch, hits);
            ConcaveQuery.RayCast(shape, poseA, inside.Position, Vector3.One, _scratch);
            ConcaveQuery.RayCrossings(shape, poseA, inside.Position, Vector3.One, _scratch, rays);
            ConcaveQuery.FindContacts(shape, poseA, other, inside, 0.05f, _scratch, contacts);
            ConcaveQuery.Distance(shape, poseA, other, poseB, _scratch);
        });
        Assert.Equal(0, bytes);
    }
}
