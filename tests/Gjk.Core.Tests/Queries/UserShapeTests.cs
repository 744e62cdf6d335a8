namespace Gjk.Core.Tests.Queries;

/// <summary>A shape of one's own, right and wrong.</summary>
public class UserShapeTests
{
    private static readonly RigidPose Apart = new(new Vector3(4, 0.5f, 0.25f));

    /// <summary>Ten lines: a regular octahedron.</summary>
    private readonly struct Octahedron(float radius) : ISupportMap
    {
        public Double3 Center => default;
        public double Margin => 0;
        public double BoundingRadius => radius;
        public int Support(in Double3 d, out Double3 point)
        {
            double x = Math.Abs(d.X), y = Math.Abs(d.Y), z = Math.Abs(d.Z);
            point = x >= y && x >= z ? new(d.X < 0 ? -radius : radius, 0, 0)
                : y >= z ? new(0, d.Y < 0 ? -radius : radius, 0)
                : new(0, 0, d.Z < 0 ? -radius : radius);
            return -1;
        }

        public void GetFace(in Double3 direction, ref FaceCorners corners)
        {
        }

        public bool TryGetVertex(int id, out Double3 point)
        {
            point = default;
            return false;
        }
    }

    [Fact]
    public void TenLinesMakeAShape()
    {
        var mesh = TestShape.Mesh(
            Vector3.UnitX, -Vector3.UnitX, Vector3.UnitY, -Vector3.UnitY, Vector3.UnitZ, -Vector3.UnitZ);
        for (ulong i = 0; i < (ulong)Budget.Count(200); i++)
        {
            var rng = new Rng(i);
            RigidPose a = Generators.Pose(rng, rng.Vector(-1.5, 1.5)), b = Generators.Pose(rng, default);
            TestShape box = TestShape.Box(rng.Vector(0.1, 1));
            DistanceResult own = ConvexQuery.Distance(new Octahedron(1), a, box.Shape, b);
            ExactAnswer exact = new TestPair("", mesh, a, box, b).Exact();
            string? problem = Certificate.Problem(new Octahedron(1), a, box.Shape, b, own, 2);
            Assert.True(
                problem is null && Math.Abs(own.Distance - exact.Distance) <= Accuracy.Band(exact.Distance, 2),
                $"seed {i}: {problem}, {own.Distance:R}, truly {exact.Distance:R}");
        }
    }

    /// <summary>Rounded to float, the points of a curved shape disagree with one another by more than double could,
    /// above all far from the shape's own origin. That is no fault: the answer is as good as the points are, and says
    /// Separated.</summary>
    [Theory]
    [InlineData(0)]
    [InlineData(100)]
    public void ASupportThatComputesInFloatIsAnswered(float offset)
    {
        var center = new Vector3(offset, -0.5f * offset, 0.25f * offset);
        double noise = 1e-6 + 4 * offset / (1 << 24);
        for (ulong seed = 0; seed < (ulong)Budget.Count(300); seed++)
        {
            var rng = new Rng(seed);
            var ball = new BrokenShape(d => center + (Vector3)(d * (1 / d.Length)), 0, 1.0001, center);
            Vector3 away = rng.UnitVector() * rng.Float(2.01, 6);
            DistanceResult r = ConvexQuery.Distance(ball, RigidPose.Identity, ball, new RigidPose(away));
            double truth = ((Double3)away).Length - 2;
            Assert.True(
                r.Status == GjkStatus.Separated && Math.Abs(r.Distance - truth) <= noise,
                $"seed {seed}: {r.Status} {r.Distance:R}, truly {truth:R}");
            Assert.True(r.LowerBound <= truth + noise, $"seed {seed}: bound {r.LowerBound:R}, truly {truth:R}");
        }
    }

    public static TheoryData<string> Faults =>
    [
        "nan", "infinite", "huge", "opposite", "wandering", "nanMargin", "negativeMargin", "nanRadius",
        "infiniteRadius", "nanCenter", "farCenter",
    ];

    [Theory]
    [MemberData(nameof(Faults))]
    public void ABrokenShapeEndsAndSaysSo(string fault)
    {
        BrokenShape shape = Make(fault);
        foreach (RigidPose at in new[] { Apart, RigidPose.Identity, new RigidPose(new Vector3(1, 0.25f, 0)) })
        {
            DistanceResult r = ConvexQuery.Distance(shape, RigidPose.Identity, new BoxShape(Vector3.One), at);
            AssertEnded(fault, r);
            AssertEnded(fault, ConvexQuery.Distance(new BoxShape(Vector3.One), RigidPose.Identity, shape, at));
            ConvexQuery.Overlaps(shape, RigidPose.Identity, new BoxShape(Vector3.One), at, out GjkStatus status);
            Assert.True(Enum.IsDefined(status));
        }
    }

    [Theory]
    [InlineData("nan", GjkStatus.InvalidShape)]
    [InlineData("infinite", GjkStatus.InvalidShape)]
    [InlineData("opposite", GjkStatus.InvalidShape)]
    [InlineData("nanMargin", GjkStatus.InvalidInput)]
    [InlineData("negativeMargin", GjkStatus.InvalidInput)]
    [InlineData("nanRadius", GjkStatus.InvalidInput)]
    [InlineData("infiniteRadius", GjkStatus.InvalidInput)]
    [InlineData("nanCenter", GjkStatus.InvalidInput)]
    public void TheStatusNamesTheFault(string fault, GjkStatus expected)
    {
        GjkStatus status = ConvexQuery.Distance(
            Make(fault), RigidPose.Identity, new BoxShape(Vector3.One), Apart).Status;
        Assert.True(status == expected, $"{fault}: {status}, not {expected}");

        // The boolean solver stops at the first plane that separates and may never meet the contradiction; true it must
        // not say.
        Assert.False(ConvexQuery.Overlaps(Make(fault), RigidPose.Identity, new BoxShape(Vector3.One), Apart));
    }

    [Fact]
    public void ItsExceptionsPassThrough()
    {
        var shape = new BrokenShape(_ => throw new NotSupportedException("mine"));
        var e = Assert.Throws<NotSupportedException>(
            () => { ConvexQuery.Distance(shape, RigidPose.Identity, new PointShape(), Apart); });
        Assert.Equal("mine", e.Message);
    }

    [Fact]
    public void ARandomSupportEndsWithinTheCap()
    {
        for (ulong i = 0; i < (ulong)Budget.Count(300); i++)
        {
            var rng = new Rng(i);
            var shape = new BrokenShape(_ => rng.Vector(-1, 1));
            AssertEnded(
                $"seed {i}",
                ConvexQuery.Distance(
                    shape, RigidPose.Identity, new BoxShape(Vector3.One), new RigidPose(rng.Vector(-3, 3))));
        }
    }

    private static void AssertEnded(string fault, in DistanceResult r)
    {
        // The extended-precision solver may take up where the first one stopped, so twice the cap.
        Assert.True(r.Iterations <= 2 * GjkTolerances.MaxIterations, $"{fault}: {r.Iterations} iterations");
        Assert.True(Enum.IsDefined(r.Status));
        if (r.Status != GjkStatus.Separated) return;
        Assert.True(
            float.IsFinite(r.Distance) && float.IsFinite(r.Normal.X + r.PointA.X + r.PointB.X),
            $"{fault}: {r.Status} with {r.Distance}, {r.Normal}, {r.PointA}, {r.PointB}");
    }

    private static BrokenShape Make(string fault)
    {
        static Double3 Ball(Double3 d) => d * (1 / d.Length);
        int calls = 0;
        return fault switch
        {
            "nan" => new(_ => new Double3(double.NaN, 0, 0)),
            "infinite" => new(_ => new Double3(double.PositiveInfinity, 0, 0)),
            "huge" => new(d => Ball(d) * 1e300),
            "opposite" => new(d => -Ball(d)),
            "wandering" => new(d => Ball(d) * (1 + 0.5 * (calls++ % 3))),
            "nanMargin" => new(Ball, double.NaN),
            "negativeMargin" => new(Ball, -1),
            "nanRadius" => new(Ball, 0, double.NaN),
            "infiniteRadius" => new(Ball, 0, double.PositiveInfinity),
            "nanCenter" => new(Ball, 0, 2, new Double3(double.NaN, 0, 0)),
            "farCenter" => new(Ball, 0, 2, new Double3(1e200, 0, 0)),
            _ => throw new ArgumentException("No such fault.", nameof(fault)),
        };
    }
}
