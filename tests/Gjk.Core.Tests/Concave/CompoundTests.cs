namespace Gjk.Core.Tests.Concave;

/// <summary>A compound is the union of its children's parts, wherever they are and however deep they were
/// nested.</summary>
public class CompoundTests
{
    private const int Trees = 60;

    private static readonly RigidPose s_here = RigidPose.Identity;

    private readonly ConcaveScratch _scratch = new();

    [Fact]
    public void PartsAreThoseOfTheChildrenInTheirOrder()
    {
        int most = 0;
        for (int seed = 0; seed < Trees; seed++)
        {
            List<ConvexShape> parts = [];
            List<(int Child, int Part)> children = [];
            CompoundShape compound = ConcaveShapes.Nested(new Rng((ulong)seed), 3, parts, children);
            Assert.Equal(parts.Count, compound.PartCount);
            Assert.Equal(children[^1].Child + 1, compound.ChildCount);
            for (int i = 0; i < parts.Count; i++)
            {
                Assert.True(compound.GetPart(i) == parts[i], $"seed {seed}, part {i}");
                Assert.Equal(children[i], (compound.GetChild(i, out int part), part));
            }

            most = Math.Max(most, compound.ChildCount);
        }

        Assert.Equal(4, most);
    }

    /// <summary>As floats the coordinates of the inner part would be lost a thousand kilometres away.</summary>
    [Theory]
    [InlineData(1e6f)]
    [InlineData(1e9f)]
    [InlineData(1e30f)]
    public void PosesAreComposedWithoutALoss(float far)
    {
        var turn = new RigidPose(new Quaternion(0.1f, -0.7f, 0.5f, 0.5f), new Vector3(far, -far, far));
        AnyShape[] bodies =
        [
            AnyShape.Of(ConvexShape.Box(new Vector3(0.3f, 0.2f, 0.1f))), AnyShape.Surface(ConcaveShapes.Torus(5, 4)),
        ];
        foreach (AnyShape body in bodies)
        {
            var own = new RigidPose(new Vector3(0.1f, 0.2f, 0.3f));
            AnyShape near = Compound(body, own);
            AnyShape back = Compound(Compound(near, turn), new RigidPose(new Vector3(-far, far, -far)));
            AnyShape expected = Compound(body, new RigidPose(turn.Rotation, turn.TransformDirection(own.Position)));
            var other = AnyShape.Of(ConvexShape.Sphere(0.25f));
            var at = new RigidPose(new Vector3(1, 2, 3));
            double found = ConcaveQuery.Distance(back, s_here, other, at, _scratch).Distance;
            Assert.Equal(ConcaveQuery.Distance(expected, s_here, other, at, _scratch).Distance, found, 1e-6);
        }
    }

    /// <summary>A float's rounding is what a compound of triangles and a surface may differ by: one composes
    /// poses.</summary>
    [Fact]
    public void ASurfaceAsAPartIsTheSurface()
    {
        var field = TriangleMesh.FromHeights([0, 1, 0, 1, 0, 2, 0, 1, 0], 3, new Vector2(0.5f, 0.7f));
        int overlaps = 0;
        for (int seed = 0; seed < Trees; seed++)
        {
            var random = new Rng((ulong)seed);
            TriangleMesh mesh = seed % 3 == 0 ? field : ConcaveShapes.Soup(random, 20, 0.5);
            if (seed % 2 == 0) mesh = mesh.Scaled(random.Factors(0.5, 2));
            RigidPose pose = ConcaveShapes.Pose(random, 1), at = ConcaveShapes.Pose(random, 1);
            AnyShape surface = AnyShape.Surface(mesh), placed = Compound(surface, pose);
            AnyShape other = ConcaveShapes.Any(random);
            PairDistance one = ConcaveQuery.Distance(surface, pose, other, at, _scratch);
            PairDistance same = ConcaveQuery.Distance(placed, s_here, other, at, _scratch);
            Assert.True(one.Status == same.Status, $"seed {seed}: {one}, placed {same}");
            Assert.Equal(one.Distance, same.Distance, 1e-6f);
            Vector3 way = pose.Position - at.Position;
            RayHit ray = ConcaveQuery.RayCast(surface, pose, at.Position, way, _scratch);
            RayHit placedRay = ConcaveQuery.RayCast(placed, s_here, at.Position, way, _scratch);
            Assert.Equal((ray.Status, ray.Part), (placedRay.Status, placedRay.Part));
            if (one.IsOverlapping) overlaps++;
        }

        Assert.InRange(overlaps, Trees / 5, Trees * 4 / 5);
    }

    [Fact]
    public void MovedChildrenAreThoseOfANewCompound()
    {
        for (int seed = 0; seed < Trees; seed++)
        {
            var random = new Rng((ulong)(500 + seed));
            var children = new CompoundPart[1 + random.Below(12)];
            for (int i = 0; i < children.Length; i++)
            {
                AnyShape shape = random.OneIn(2)
                    ? AnyShape.Of(ConcaveShapes.Nested(random, 1, []))
                    : AnyShape.Of(ConvexShape.Capsule(0.1f, 0.2f).Placed(ConcaveShapes.Pose(random, 0.1)));
                children[i] = new CompoundPart(shape, ConcaveShapes.Pose(random, 1));
            }

            Vector3 scale = seed % 3 == 0 ? random.Factors(0.5, 2) : Vector3.One;
            var before = new CompoundShape(children);
            CompoundShape moved = scale == Vector3.One ? before : before.Scaled(scale).Scaled(scale);
            string[] old = Answers(moved, seed);
            CompoundShape first = moved;
            for (int i = 0; i < children.Length; i++)
            {
                RigidPose pose = i == 0 ? s_here : ConcaveShapes.Pose(random, seed % 5 == 0 ? 30 : 1);
                children[i] = new CompoundPart(children[i].Shape, pose);
                if (seed % 2 == 0) moved = moved.WithPose(i, pose);
            }

            if (seed % 2 != 0) moved = moved.WithPoses(Array.ConvertAll(children, child => child.Pose));
            var built = new CompoundShape(children);
            if (scale != Vector3.One) built = built.Scaled(scale).Scaled(scale);
            for (int i = 0; i < built.PartCount; i++)
                Assert.True(built.GetPart(i) == moved.GetPart(i), $"seed {seed}, part {i}");
            for (int i = 0; i < children.Length; i++) Assert.Equal(children[i].Pose, moved.GetPose(i));
            Assert.Equal(Answers(built, seed)[1..], Answers(moved, seed)[1..]);
            Assert.Equal(old, Answers(first, seed));
        }
    }

    /// <summary>What the page says of bytes; the tree's form and what did not move are shared or copied, not
    /// built.</summary>
    [Theory]
    [InlineData(20, 550)]
    [InlineData(1000, 450)]
    public void AMoveTakesAFewHundredBytesAPart(int parts, int bytesEach)
    {
        CompoundShape compound = ConcaveShapes.Compound(new Rng(7), parts);
        var pose = new RigidPose(new Vector3(0.1f, 0.2f, 0.3f));
        Assert.InRange(Allocation.Least(() => compound.WithPose(parts / 2, pose)), 1, parts * bytesEach);
    }

    [Fact]
    public void QueriesOfNestedPartsAllocateNothing()
    {
        AnyShape a = AnyShape.Of(ConcaveShapes.Nested(new Rng(3), 2, []));
        AnyShape b = AnyShape.Of(ConcaveShapes.Nested(new Rng(4), 2, []).WithPose(0, s_here));
        var at = new RigidPose(new Vector3(0.3f, 0.2f, 0.1f));
        var contacts = new List<PairContacts>();
        long bytes = Allocation.Least(() =>
        {
            PairDistance found = ConcaveQuery.Distance(a, s_here, b, at, _scratch);
            a.Compound!.GetChild(Math.Max(found.PartA, 0), out _);
            ConcaveQuery.Cast(a, s_here, Vector3.One, b, at, -Vector3.One, _scratch);
            ConcaveQuery.RayCast(a, s_here, Vector3.One, Vector3.UnitX, _scratch);
            ConcaveQuery.FindContacts(a, s_here, b, at, 0.05f, _scratch, contacts);
        });
        Assert.Equal(0, bytes);
    }

    [Fact]
    public void WhatIsNoPartIsRefused()
    {
        AnyShape ground = AnyShape.Of(ConvexShape.HalfSpace(Vector3.UnitY, 0)), none = default;
        Assert.Contains("no end", Assert.Throws<ArgumentException>(() => new CompoundPart(ground, s_here)).Message);
        Assert.Throws<ArgumentException>(() => new CompoundPart(none, s_here));
        Assert.Throws<ArgumentOutOfRangeException>(() => new CompoundPart(AnyShape.Of(ConvexShape.Point()), default));
    }

    [Fact]
    public void WhatIsNoPlaceIsRefused()
    {
        CompoundShape compound = ConcaveShapes.Compound(new Rng(1), 3);
        foreach (int index in new[] { -1, 3, int.MinValue, int.MaxValue })
        {
            Assert.Throws<ArgumentOutOfRangeException>(() => compound.GetPart(index));
            Assert.Throws<ArgumentOutOfRangeException>(() => compound.GetPose(index));
            Assert.Throws<ArgumentOutOfRangeException>(() => compound.GetChild(index, out _));
            Assert.Throws<ArgumentOutOfRangeException>(() => compound.WithPose(index, s_here));
        }

        Assert.Throws<ArgumentOutOfRangeException>(() => compound.WithPose(0, default));
        Assert.Throws<ArgumentNullException>(() => compound.WithPoses(null!));
        Assert.Throws<ArgumentException>(() => compound.WithPoses([s_here]));
        Assert.Throws<ArgumentOutOfRangeException>(() => compound.WithPoses([s_here, s_here, default]));
    }

    private static AnyShape Compound(in AnyShape shape, in RigidPose pose) =>
        AnyShape.Of(new CompoundShape([new CompoundPart(shape, pose)]));

    private string[] Answers(CompoundShape compound, int seed)
    {
        var random = new Rng((ulong)seed);
        RigidPose pose = ConcaveShapes.Pose(random, 0.5), at = ConcaveShapes.Pose(random, 1.5);
        return ConcaveAnswers.Of(_scratch, AnyShape.Of(compound), pose, ConcaveShapes.Any(random), at);
    }
}
