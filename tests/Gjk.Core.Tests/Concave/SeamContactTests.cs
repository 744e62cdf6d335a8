namespace Gjk.Core.Tests.Concave;

/// <summary>Bodies that slide over surfaces feel what the surface is, not how it is cut into triangles.</summary>
public class SeamContactTests
{
    /// <summary>Angle: twice <see cref="ContactCone.Slack"/>, across a side and along it, and the rounding of the
    /// normal itself.</summary>
    private const float Straight = 2.2e-6f;

    private const float Reach = 0.02f;
    private readonly ConcaveScratch _scratch = new();
    private readonly List<PairContacts> _contacts = [];

    public static TheoryData<string> Bodies => new("ball", "box", "capsule", "hull");

    [Theory]
    [MemberData(nameof(Bodies))]
    public void AFlatGridPushesStraightUpInEveryFrame(string name)
    {
        int frames = 0, seams = 0;
        foreach (int cut in new[] { 0, 1, 2, 3 })
        {
            for (int seed = 0; seed < 6; seed++)
            {
                var random = new Rng((ulong)(100 * cut + seed));
                AnyShape ground = AnyShape.Surface(SeamBodies.Plate(8, cut, (_, _) => 0));
                Quaternion turn = seed == 0 ? Quaternion.Identity : random.Rotation();
                var at = new RigidPose(turn, seed % 2 == 0 ? Vector3.Zero : new Vector3(1e4f, -7e3f, 3e3f));
                bool isTilted = seed >= 3;
                for (int i = 0; i <= 48; i++)
                {
                    // In halves of cells, so that edges, diagonals and corners are met exactly as well as nearly.
                    float x = i / 8f - 3 + (seed == 2 ? 0.001f : 0), z = seed == 1 ? x : 0.25f * seed;
                    Quaternion own = isTilted ? SeamBodies.Tilt(random, 0.1) : Quaternion.Identity;
                    Frame(name, ground, at, new Vector3(x, 0, z), own, random.Float(-0.015f, 0.01f));
                    frames++;
                    Assert.True(_contacts.Count > 0, $"{name} {cut} {seed} {i}: contact lost");
                    foreach (PairContacts one in _contacts) AssertUp(one, turn, $"{name} {cut} {seed} {i}");
                    if (_contacts.Count > 1) seams++;
                }
            }
        }

        Assert.InRange(seams, frames / 100, frames);
    }

    [Theory]
    [InlineData("box")]
    [InlineData("capsule")]
    public void ABodyAtRestIsHeldAtItsWholeFoot(string name)
    {
        // A tilt such as bodies at rest have: all corners within reach keep their points.
        AnyShape body = SeamBodies.Named(name);
        var random = new Rng(7);
        for (int i = 0; i < 40; i++)
        {
            TriangleMesh fine = SeamBodies.Plate(8, i % 4, (_, _) => 0);
            AnyShape ground = AnyShape.Surface(fine), slab = AnyShape.Of(ConvexShape.Box(new Vector3(4, 1, 4)));
            Quaternion own = SeamBodies.Tilt(random, 2e-3);
            Vector3 at = new(random.Float(-1, 1), 0, random.Float(-1, 1));
            RigidPose pose = SeamBodies.Placed(body, at, own, -0.001f);
            ConcaveQuery.FindContacts(ground, RigidPose.Identity, body, pose, Reach, _scratch, _contacts);
            ConvexQuery.Contacts(
                slab.Convex, new RigidPose(-Vector3.UnitY), body.Convex, pose, Reach, out ContactManifold whole);
            for (int k = 0; k < whole.Count; k++)
            {
                float nearest = float.PositiveInfinity;
                foreach (PairContacts one in _contacts)
                    for (int j = 0; j < one.Manifold.Count; j++)
                        nearest = Math.Min(nearest, (one.Manifold[j].PointB - whole[k].PointB).Length());
                Assert.True(nearest < 0.03f, $"{name} {i}: {whole[k]} is {nearest} from any");
            }
        }
    }

    [Fact]
    public void OverARidgeTheNormalsFanOut()
    {
        TriangleMesh roof = SeamBodies.Plate(8, 1, (x, _) => -0.5f * Math.Abs(x));
        AnyShape ground = AnyShape.Surface(roof), ball = SeamBodies.Named("ball");
        int fanned = 0;
        for (int i = -40; i <= 40; i++)
        {
            float x = i / 100f;
            var at = new RigidPose(new Vector3(x, 0.5f * -Math.Abs(x) + 0.335f, 0.3f));
            float gap = ConcaveQuery.Distance(ground, RigidPose.Identity, ball, at, _scratch).Distance;
            at = new RigidPose(at.Position - new Vector3(0, gap, 0));
            ConcaveQuery.FindContacts(ground, RigidPose.Identity, ball, at, Reach, _scratch, _contacts);
            Assert.NotEmpty(_contacts);
            foreach (PairContacts one in _contacts)
            {
                Vector3 n = one.Manifold.Normal;
                Assert.True(Math.Abs(n.Z) <= Straight && Math.Abs(n.X / n.Y) <= 0.5f + 2 * Straight, $"{i}: {n}");
                if (Math.Abs(n.X / n.Y) < 0.49f) fanned++;
            }
        }

        Assert.InRange(fanned, 10, 200);
        foreach (float side in new[] { 0f, 0.3f })
        {
            Frame("box", ground, RigidPose.Identity, new Vector3(side, 0, 0.2f), Quaternion.Identity, -0.001f);
            Assert.NotEmpty(_contacts);
            foreach (PairContacts one in _contacts) AssertUp(one, Quaternion.Identity, $"{side}");
        }
    }

    [Fact]
    public void InAValleyThereAreTwoNormals()
    {
        AnyShape ground = AnyShape.Surface(SeamBodies.Plate(8, 2, (x, _) => Math.Abs(x)));
        AnyShape ball = SeamBodies.Named("ball");
        float root = (float)Math.Sqrt(0.5);
        Vector3[] both = [new(root, root, 0), new(-root, root, 0)];
        bool[] seen = new bool[2];
        for (int i = -30; i <= 30; i++)
        {
            // Into the valley, along it and out, a little above the walls or in them.
            float x = i / 1000f, height = (Math.Abs(x) * root + 0.3f + (i % 5 - 3) * 0.002f) / root;
            var at = new RigidPose(new Vector3(x, height, i / 20f));
            ConcaveQuery.FindContacts(ground, RigidPose.Identity, ball, at, Reach, _scratch, _contacts);
            Assert.NotEmpty(_contacts);
            foreach (PairContacts one in _contacts)
            {
                Vector3 n = one.Manifold.Normal;
                int wall = n.X > 0 ? 0 : 1;
                Assert.True((n - both[wall]).Length() <= Straight, $"{i}: {n}");
                seen[wall] = true;
            }
        }

        Assert.True(seen[0] && seen[1]);
    }

    [Fact]
    public void ABodyComesOffTheBorderOfAPlate()
    {
        AnyShape plate = AnyShape.Surface(SeamBodies.Plate(4, 0, (_, _) => 0)), ball = SeamBodies.Named("ball");
        int beside = 0;
        for (int i = 0; i <= 30; i++)
        {
            var at = new RigidPose(new Vector3(1.9f + i / 80f, 0.29f, 0.1f));
            ConcaveQuery.FindContacts(plate, RigidPose.Identity, ball, at, Reach, _scratch, _contacts);
            float gap = ConcaveQuery.Distance(plate, RigidPose.Identity, ball, at, _scratch).Distance;
            Assert.Equal(gap <= Reach, _contacts.Count > 0);
            if (_contacts.Count > 0 && _contacts[0].Manifold.Normal.X > 0.1f) beside++;
        }

        Assert.InRange(beside, 3, 25);
    }

    [Fact]
    public void TheBackOfASurfaceBendsTheOtherWay()
    {
        // From below a valley is a ridge.
        AnyShape ground = AnyShape.Surface(SeamBodies.Plate(8, 1, (x, _) => 0.5f * Math.Abs(x)));
        AnyShape ball = SeamBodies.Named("ball");
        var at = new RigidPose(new Vector3(0, -0.305f, 0.1f));
        ConcaveQuery.FindContacts(ground, RigidPose.Identity, ball, at, Reach, _scratch, _contacts);
        Assert.NotEmpty(_contacts);
        foreach (PairContacts one in _contacts)
            Assert.True((one.Manifold.Normal + Vector3.UnitY).Length() < 1e-5f, $"{one}");
    }

    [Fact]
    public void ASurfaceOnASurfaceIsPushedStraightUp()
    {
        AnyShape ground = AnyShape.Surface(SeamBodies.Plate(8, 3, (_, _) => 0));
        var half = new Vector3(0.4f, 0.2f, 0.7f);
        foreach (AnyShape crate in new[]
                 {
                     AnyShape.Solid(ConcaveShapes.Box(half)), AnyShape.Surface(ConcaveShapes.Box(half)),
                 })
        {
            for (int i = 0; i <= 40; i++)
            {
                var at = new RigidPose(
                    Quaternion.CreateFromAxisAngle(Vector3.UnitY, 0.2f * (i % 7)),
                    new Vector3(i / 16f - 1, 0.2f + 0.005f, i / 40f));
                ConcaveQuery.FindContacts(ground, RigidPose.Identity, crate, at, Reach, _scratch, _contacts);
                Assert.NotEmpty(_contacts);
                foreach (PairContacts one in _contacts) AssertUp(one, Quaternion.Identity, $"{i}");
            }
        }
    }

    [Fact]
    public void AFlattenedTriangleAtAnEdgeIsNoBorder()
    {
        // Two halves of a plate, whose common edge has a vertex more on one side, joined by a triangle without area.
        Vector3[] points = [new(-2, 0, -2), new(-2, 0, 2), new(0, 0, 2), new(0, 0, -2), new(2, 0, 0), new(0, 0, 0)];
        var mesh = new TriangleMesh(points, [0, 1, 2, 0, 2, 3, 3, 2, 5, 3, 5, 4, 5, 2, 4]);
        AnyShape ground = AnyShape.Surface(mesh), ball = SeamBodies.Named("ball");
        for (int i = -20; i <= 20; i++)
        {
            var at = new RigidPose(new Vector3(i / 50f, 0.28f, 0.5f));
            ConcaveQuery.FindContacts(ground, RigidPose.Identity, ball, at, Reach, _scratch, _contacts);
            Assert.NotEmpty(_contacts);
            foreach (PairContacts one in _contacts) AssertUp(one, Quaternion.Identity, $"{i}");
        }
    }

    private void Frame(
        string name, in AnyShape ground, in RigidPose at, Vector3 over, Quaternion own, float height)
    {
        AnyShape body = SeamBodies.Named(name);
        RigidPose local = SeamBodies.Placed(body, over, own, height);
        var pose = new RigidPose(
            Quaternion.Normalize(at.Rotation * own), at.Position + Vector3.Transform(local.Position, at.Rotation));
        Assert.True(ConcaveQuery.FindContacts(ground, at, body, pose, Reach, _scratch, _contacts));
    }

    private static void AssertUp(in PairContacts one, Quaternion turn, string where)
    {
        Vector3 up = Vector3.Transform(Vector3.UnitY, turn);
        Assert.True((one.Manifold.Normal - up).Length() <= Straight, $"{where}: {one}, but up is {up}");
        Assert.True((one.Result.Normal - up).Length() <= Straight, $"{where}: {one.Result}");
    }

    /// <summary>Each side is looked at behind each plane: without a bound a ball in a round hall takes the square of
    /// the facets.</summary>
    [Fact]
    public void ABoundedNumberOfPlanesIsAsked()
    {
        var hall = AnyShape.Surface(Solids.Named("ball", 0));
        var scratch = new ConcaveScratch();
        var contacts = new List<PairContacts>();
        Assert.True(ConcaveQuery.FindContacts(
            AnyShape.Of(ConvexShape.Sphere(0.75f)), RigidPose.Identity, hall, RigidPose.Identity, 0.1f, scratch,
            contacts));
        Assert.True(contacts.Count > 200, $"{contacts.Count}");
        Assert.InRange(scratch.Planes.Count, 16, 64);
    }
}
