namespace Gjk.Core.Tests;

/// <summary>Shapes that are scaled, rounded and placed, typed and as <see cref="ConvexShape"/>.</summary>
public class PlacedTests
{
    private static readonly Vector3[] Corners =
        [new(0.1f, 0.2f, -0.3f), new(1.1f, -0.7f, 0.3f), new(-0.4f, 0.9f, 0.6f), new(0.3f, 0.3f, 2), new(-1, -1, -1)];

    private static readonly RigidPose Beside = new(
        Quaternion.Normalize(new Quaternion(1, -2, 3, 4)), new Vector3(3, -5, 7));

    private static readonly RigidPose Far =
        new(Quaternion.Normalize(new Quaternion(-3, 1, 2, 5)), new Vector3(1e6f, -2e6f, 3e5f));

    public static TheoryData<string> Families => ["everyday", "align", "touch", "parallel", "uneven"];

    [Fact]
    public void AlongZIsATurnThatRoundsNothing()
    {
        ConvexShape cone = ConvexShape.Cone(0.7f, 1.3f), alongZ = cone.AlongZ();
        Assert.Equal(cone.Placed(new RigidPose(new Quaternion(0.5f, 0.5f, 0.5f, 0.5f), default)), alongZ);
        alongZ.Support(new Double3(0, 0, 1), out Double3 tip);
        Assert.Equal(new Double3(0, 0, 1.3f), tip);
        ConvexShape box = ConvexShape.Box(new Vector3(1, 2, 3)), turned = box.AlongZ();
        turned.Support(new Double3(1, 1, 1), out Double3 corner);
        Assert.Equal(new Double3(3, 1, 2), corner);

        // The same pair with y for z, z for x and x for y.
        var at = new RigidPose(new Vector3(2.1f, 0.3f, 1.7f));
        var upright = new RigidPose(new Vector3(0.3f, 1.7f, 2.1f));
        DistanceResult one = ConvexQuery.Distance(alongZ, RigidPose.Identity, ConvexShape.Sphere(0.4f), at);
        DistanceResult other = ConvexQuery.Distance(cone, RigidPose.Identity, ConvexShape.Sphere(0.4f), upright);
        Assert.Equal(GjkStatus.Separated, one.Status);
        Assert.Equal(other.Distance, one.Distance);
        Assert.Throws<InvalidOperationException>(() => default(ConvexShape).AlongZ());
    }

    [Fact]
    public void FactorsMultiplyWhateverTheKind()
    {
        Vector3 first = new(2, 0.5f, -4), second = new(0.25f, -3, 0.5f), both = first * second;
        ConvexShape[] shapes =
        [
            ConvexShape.Point(), ConvexShape.Segment(Corners[0], Corners[1]), ConvexShape.Sphere(0.5f),
            ConvexShape.Triangle(Corners[0], Corners[1], Corners[2]), ConvexShape.Capsule(0.5f, 2),
            ConvexShape.Box(new Vector3(1, 2, 3)), ConvexShape.Cylinder(0.5f, 2), ConvexShape.Cone(0.5f, 2),
            ConvexShape.Ellipsoid(new Vector3(1, 2, 3)), ConvexShape.Mesh(Corners),
        ];
        foreach (ConvexShape shape in shapes)
        {
            Assert.Equal(shape.Scaled(both), shape.Scaled(first).Scaled(second));
            ShapeKind kind = shape.Kind == ShapeKind.Sphere ? ShapeKind.Ellipsoid : shape.Kind;
            ConvexShape back = shape.Scaled(first).Scaled(Vector3.One / first);
            Assert.Equal((kind, Vector3.One, shape.BoundingRadius), (back.Kind, back.Scale, back.BoundingRadius));
        }
    }

    [Fact]
    public void ConvexShapeIsTheDecoratorBitForBit()
    {
        var hull = new ConvexHull(Corners);
        var mesh = new ConvexMesh(hull);
        Vector3 uneven = new(0.7f, -1.3f, 2.1f);
        Same(new Placed<ConvexMesh>(mesh, Beside), ConvexShape.Mesh(hull).Placed(Beside));
        Same(
            new Placed<Placed<BoxShape>>(new(new BoxShape(Vector3.One), Beside), Far),
            ConvexShape.Box(Vector3.One).Placed(Beside).Placed(Far));
        Same(new Rounded<ConvexMesh>(mesh, 0.3f), ConvexShape.Mesh(hull).Rounded(0.3f));
        Same(new Rounded<BoxShape>(new BoxShape(Vector3.One), 0.3f), ConvexShape.Box(Vector3.One).Rounded(0.3f));
        Same(
            new Placed<CapsuleShape>(new CapsuleShape(0.3f, 0.7f), Beside),
            ConvexShape.Capsule(0.3f, 0.7f).Placed(Beside));
        Same(new Rounded<SphereShape>(new SphereShape(0.3f), 0.7f), ConvexShape.Sphere(0.3f).Rounded(0.7f));
        Same(
            new Scaled<Rounded<ConvexMesh>>(new Rounded<ConvexMesh>(mesh, 0.3f), uneven),
            ConvexShape.Mesh(hull).Rounded(0.3f).Scaled(uneven));
        Same(
            new Rounded<Placed<Scaled<ConvexMesh>>>(new(new(mesh, uneven), Beside), 0.3f),
            ConvexShape.Mesh(hull).Scaled(uneven).Placed(Beside).Rounded(0.3f));
    }

    /// <summary>The poses of the cases go into the shapes, and both objects stand at one pose, near or far, which
    /// changes no distance. So the proved answers must come out. Supports in the frame's own coordinates would lose ten
    /// digits.</summary>
    [Theory]
    [MemberData(nameof(Families))]
    public void APlacedShapeIsAsExactAsTheShape(string family)
    {
        int count = 0;
        foreach (HardCase c in CaseFamily.Load(family).Cases)
        {
            TestPair p = c.Pair;
            ConvexShape a = p.A.Shape.Placed(p.PoseA), b = p.B.Shape.Placed(p.PoseB);
            foreach (RigidPose pose in new[] { RigidPose.Identity, Beside, Far })
            {
                DistanceResult r = ConvexQuery.Distance(a, pose, b, pose);
                double most = Math.Max(c.Distance, c.Depth), error = Math.Abs(r.Distance - c.Distance);
                Assert.True(r.IsOverlapping == c.Overlap || most <= Accuracy.FlagScale * p.Scale, $"{p.Name}: {r}");
                Assert.True(error <= Accuracy.Band(c.Distance, p.Scale), $"{p.Name}: {r}, truly {c.Distance:R}");
                Assert.True(r.LowerBound <= c.Distance, $"{p.Name}: bound {r.LowerBound:R}, truly {c.Distance:R}");
                count++;
            }
        }

        Assert.True(count >= 100);
    }

    /// <summary>Their places differ by 2^-43 at 10^6 from the origin, where doubles are 2^-33 apart.</summary>
    [Fact]
    public void PointsThatArePlacedTwiceKeepWhatADoubleLoses()
    {
        var quarter = Quaternion.Normalize(new Quaternion(0, 0, 1, 1));
        var far = new RigidPose(quarter, new Vector3(0, 1e6f, 0));
        const float near = 1f / (1 << 20), beside = near + 1f / (1L << 43);
        ConvexShape a = ConvexShape.Point().Placed(new RigidPose(new Vector3(near, 0, 0))).Placed(far);
        ConvexShape b = ConvexShape.Point().Placed(new RigidPose(new Vector3(beside, 0, 0))).Placed(far);
        DistanceResult r = ConvexQuery.Distance(a, RigidPose.Identity, b, RigidPose.Identity);
        Assert.Equal(1f / (1L << 43), r.Distance);
    }

    /// <summary>What is placed is answered as what is not, at the composed pose: by the same solvers, after as many
    /// supports.</summary>
    [Fact]
    public void PlacedShapesAreAskedInTheAxesOfTheirCores()
    {
        var rng = new Rng(31);
        var hull = new ConvexHull(Corners);
        ConvexShape[] cores =
        [
            ConvexShape.Box(Vector3.One), ConvexShape.Mesh(hull), ConvexShape.Box(Vector3.One).Rounded(0.1f),
            ConvexShape.Segment(Corners[0], Corners[1]), ConvexShape.Cylinder(0.5f, 1),
            ConvexShape.Triangle(Corners[0], Corners[1], Corners[2]), ConvexShape.Mesh(hull).Scaled(new(1, 2, 3)),
        ];
        int count = 0, same = 0;
        for (int i = 0; i < 500; i++)
        {
            ConvexShape a = cores[i % cores.Length], b = cores[i / cores.Length % cores.Length];
            RigidPose inA = Pose(1), inB = Pose(1), poseA = Pose(0), poseB = Pose(5);
            DistanceResult r = ConvexQuery.SignedDistance(a.Placed(inA), poseA, b.Placed(inB), poseB);
            DistanceResult plain = ConvexQuery.SignedDistance(a, poseA * inA, b, poseB * inB);
            Assert.Equal(plain.Distance, r.Distance, 2e-6f);
            Assert.True((plain.PointA - r.PointA).Length() < 1e-3f || plain.IsOverlapping, $"{i}: {r}, plain {plain}");
            Assert.True((poseA.TransformPoint(r.LocalPointA) - r.PointA).Length() < 4e-6f, $"{i}: {r}");
            Assert.True((poseB.TransformPoint(r.LocalPointB) - r.PointB).Length() < 4e-6f, $"{i}: {r}");
            count++;
            if (plain.Iterations == r.Iterations) same++;
        }

        Assert.True(same > 0.9 * count, $"{same} of {count} took as many supports");

        RigidPose Pose(float distance) => new(rng.Rotation(), distance * rng.UnitVector());
    }

    [Fact]
    public void PointsAreInTheFrameOfThePlacedShape()
    {
        // A capsule along x, beside the origin of its object.
        var turn = new RigidPose(Quaternion.CreateFromAxisAngle(Vector3.UnitZ, MathF.PI / 2), new Vector3(5, 0, 0));
        ConvexShape capsule = ConvexShape.Capsule(0.5f, 2).Placed(turn);
        DistanceResult r = ConvexQuery.Distance(
            capsule, new RigidPose(new Vector3(0, 10, 0)), ConvexShape.Sphere(1), new RigidPose(
                new Vector3(10, 10, 0)));
        Assert.Equal(1.5f, r.Distance, 1e-6f);
        Assert.True((r.LocalPointA - new Vector3(7.5f, 0, 0)).Length() < 1e-6f, r.ToString());
        Assert.True((r.PointA - new Vector3(7.5f, 10, 0)).Length() < 1e-6f, r.ToString());
    }

    [Fact]
    public void RoundingAddsToTheMarginAndIsScaledWithTheShape()
    {
        ConvexShape rounded = ConvexShape.Box(Vector3.One).Rounded(0.25f).Rounded(0.25f);
        Assert.Equal(0.5, rounded.Margin);
        Assert.Equal(1, rounded.Scaled(new Vector3(2)).Margin);
        Assert.Equal(0, rounded.Scaled(new Vector3(2, 1, 1)).Margin);
        DistanceResult r = ConvexQuery.Distance(
            rounded.Scaled(new Vector3(2, 1, 1)), RigidPose.Identity, ConvexShape.Point(), new RigidPose(
                new Vector3(5, 0, 0)));
        Assert.Equal(2f, r.Distance);
        Assert.Equal(ShapeKind.Sphere, ConvexShape.Point().Rounded(1).Kind);
        Assert.Equal(ShapeKind.Capsule, ConvexShape.Segment(Corners[0], Corners[1]).Rounded(1).Kind);
    }

    [Fact]
    public void RecordsHoldDecoratedShapesToTheBit()
    {
        foreach (ConvexShape shape in Decorated())
        {
            var record = new QueryRecord(shape, Beside, ConvexShape.Sphere(1), RigidPose.Identity);
            QueryRecord back = QueryRecord.Parse(record.ToString());
            Assert.Equal(record.ToString(), back.ToString());
            Assert.Equal(ResultBits.Of(record.Distance()), ResultBits.Of(back.Distance()));
        }
    }

    [Fact]
    public void ScenesHoldDecoratedShapes()
    {
        ConvexShape[] shapes = [.. Decorated()];
        foreach (BroadPhaseKind kind in Enum.GetValues<BroadPhaseKind>())
        {
            var scene = new CollisionScene(kind);
            var rng = new Rng(7);
            RigidPose[] poses = [.. shapes.Select(_ => new RigidPose(rng.Rotation(), 6 * rng.UnitVector()))];
            for (int i = 0; i < shapes.Length; i++) scene.Add(shapes[i], poses[i]);
            var found = new List<PairDistance>();
            scene.FindPairsWithin(float.PositiveInfinity, found);
            Assert.Equal(shapes.Length * (shapes.Length - 1) / 2, found.Count);
            foreach (PairDistance pair in found)
            {
                DistanceResult alone = ConvexQuery.Distance(
                    shapes[pair.Pair.A], poses[pair.Pair.A], shapes[pair.Pair.B], poses[pair.Pair.B]);
                Assert.Equal(ResultBits.Of(alone), ResultBits.Of(pair.Result));
            }

            var overlaps = new List<ObjectPair>();
            scene.FindOverlaps(overlaps);
            Assert.Equal(found.Where(p => p.Result.IsOverlapping).Select(p => p.Pair), overlaps);
        }
    }

    [Fact]
    public void DefaultDecoratorsAreInvalidInput()
    {
        Assert.Equal(GjkStatus.InvalidInput, Ask(default(Placed<PointShape>)));
        Assert.Equal(GjkStatus.InvalidInput, Ask(default(Scaled<PointShape>)));
        Assert.Equal(GjkStatus.InvalidInput, Ask(new Placed<ConvexMesh>(default, Beside)));

        static GjkStatus Ask<T>(T shape)
            where T : struct, ISupportMap =>
            ConvexQuery.Distance(shape, RigidPose.Identity, new SphereShape(1), Beside).Status;
    }

    [Fact]
    public void EveryShapeSaysWhatItIs()
    {
        Assert.Equal("no shape", default(ConvexShape).ToString());
        Assert.Equal("sphere, radius 0.5", ConvexShape.Sphere(0.5f).ToString());
        Assert.Equal(
            "mesh of 5 vertices scaled by <1, 2, 3>",
            ConvexShape.Mesh(Corners).Scaled(new Vector3(1, 2, 3)).ToString());
        Assert.Equal(
            "box, half extents <1, 1, 1> rounded by 0.25 placed at <1, 2, 3>",
            ConvexShape.Box(Vector3.One).Rounded(0.25f).Placed(new RigidPose(new Vector3(1, 2, 3))).ToString());
        Assert.Equal("<0, 0, 0>", RigidPose.Identity.ToString());
        Assert.Equal("<0, 0, 0> to <1, 2, 3>", new Aabb(Vector3.Zero, new Vector3(1, 2, 3)).ToString());
        DistanceResult r = ConvexQuery.Distance(
            new SphereShape(1), RigidPose.Identity, new SphereShape(1), new RigidPose(new Vector3(3, 0, 0)));
        Assert.Equal("Separated, 1 from <1, 0, 0> to <2, 0, 0>", r.ToString());
        Assert.Equal("(0, 0), parts 0 and 0: None", default(PairDistance).ToString());
        Assert.Equal("(0, 1): None", new PairDistance(default, -1, -1, new ObjectPair(0, 1)).ToString());
    }

    private static IEnumerable<ConvexShape> Decorated()
    {
        Vector3 uneven = new(0.7f, -1.3f, 2.1f);
        yield return ConvexShape.Mesh(Corners).Placed(Beside);
        yield return ConvexShape.Mesh(Corners).Scaled(uneven).Rounded(0.3f).Placed(Beside).Scaled(uneven).Rounded(0.1f);
        yield return ConvexShape.Box(Vector3.One).Rounded(0.3f);
        yield return ConvexShape.Capsule(0.3f, 0.7f).Scaled(uneven).Rounded(0.2f).Placed(Beside).Placed(Beside);
        yield return ConvexShape.Cylinder(0.3f, 0.7f).Rounded(0.3f).Scaled(uneven);
        yield return ConvexShape.Triangle(Corners[0], Corners[1], Corners[2]).Rounded(0.3f).Scaled(new Vector3(-2));
        yield return ConvexShape.Sphere(0.3f).Placed(Beside).Scaled(new Vector3(2));
    }

    private static void Same<T>(in T typed, in ConvexShape shape)
        where T : struct, ISupportMap
    {
        Assert.Equal((typed.Center, typed.Margin), (shape.Center, shape.Margin));
        Assert.Equal(typed.BoundingRadius, shape.BoundingRadius, 1e-14);
        var rng = new Rng(11);
        for (int i = 0; i < 200; i++)
        {
            Double3 d = rng.UnitVector();
            Assert.Equal(typed.Support(d, out Double3 p), shape.Support(d, out Double3 q));
            Assert.Equal(p, q);
            var pose = new RigidPose(rng.Rotation(), 12 * rng.UnitVector());
            DistanceResult a = ConvexQuery.Distance(typed, RigidPose.Identity, new SphereShape(1), pose);
            DistanceResult b = ConvexQuery.Distance(shape, RigidPose.Identity, ConvexShape.Sphere(1), pose);
            Assert.Equal(ResultBits.Of(a), ResultBits.Of(b));
        }
    }
}
