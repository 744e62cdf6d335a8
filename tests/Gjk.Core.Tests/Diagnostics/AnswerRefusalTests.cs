namespace Gjk.Core.Tests.Diagnostics;

/// <summary>Wrong answers: whatever is changed in a right one, by a little more than the tolerance, is
/// refuted.</summary>
public class AnswerRefusalTests
{
    /// <summary>Part of the size: more than any tolerance of a polytope, less than anyone would see.</summary>
    private const float Little = 1e-5f;

    private static readonly string[] Polytopes =
        ["hull", "box", "needle", "sphere", "capsule", "triangle", "flat", "scaledHull", "made"];

    private static readonly (string Name, Func<DistanceResult, float, DistanceResult> Change)[] Lies =
    [
        ("longer", (r, s) => r.With(distance: r.Distance + Little * s)),
        ("shorter", (r, s) => r.With(distance: r.Distance - Little * s)),
        ("bound", (r, s) => r.With(bound: r.Distance + Little * s)),
        ("normal", (r, s) => r.With(normal: -r.Normal)),
        ("long normal", (r, s) => r.With(normal: r.Normal * 1.00001f)),
        ("turned", (r, s) => r.With(normal: Vector3.Normalize(r.Normal + new Vector3(0.01f, -0.02f, 0.01f)))),
        ("point A", (r, s) => r.With(pointA: r.PointA + new Vector3(0.01f * s))),
        ("point B", (r, s) => r.With(pointB: r.PointB - new Vector3(0.01f * s))),
        ("local A", (r, s) => r.With(localA: r.LocalPointA + new Vector3(0.01f * s))),
        ("local B", (r, s) => r.With(localB: r.LocalPointB - new Vector3(0.01f * s))),
        ("swapped", (r, s) => r.Swapped),
        ("overlap", (r, s) => new DistanceResult(
            GjkStatus.Overlapping, 0, 0, r.PointA, r.PointA, default, r.LocalPointA, r.LocalPointB, 1)),
        ("beyond", (r, s) => DistanceResult.Beyond(r.Distance + Little * s, r.Normal, 1)),
    ];

    public static TheoryData<string> LieNames => [.. Lies.Select(l => l.Name)];

    [Theory]
    [MemberData(nameof(LieNames))]
    public void AWrongDistanceIsRefuted(string lie)
    {
        Func<DistanceResult, float, DistanceResult> change = Lies.First(l => l.Name == lie).Change;
        int asked = 0;
        for (ulong i = 0; i < 300; i++)
        {
            TestPair p = Generators.Pair(i, Polytopes, 1.5);
            DistanceResult right = p.Distance();
            float size = (float)(p.A.Shape.BoundingRadius + p.B.Shape.BoundingRadius);
            if (right.Status != GjkStatus.Separated || right.Distance < 0.1f * size) continue;
            asked++;
            AssertRefuted(p, change(right, size), false);
        }

        Assert.True(asked > 80, $"only {asked} pairs");
    }

    [Theory]
    [InlineData("deeper")]
    [InlineData("shallower")]
    [InlineData("normal")]
    [InlineData("turned")]
    [InlineData("no normal")]
    [InlineData("local A")]
    [InlineData("point B")]
    [InlineData("bound")]
    [InlineData("apart")]
    public void AWrongDepthIsRefuted(string lie)
    {
        int asked = 0;
        for (ulong i = 0; i < 300; i++)
        {
            TestPair p = Generators.Pair(i, Polytopes, 0.7);
            DistanceResult r = p.SignedDistance();
            float size = (float)(p.A.Shape.BoundingRadius + p.B.Shape.BoundingRadius);
            if (r.Status != GjkStatus.Overlapping || r.Distance > -0.05f * size) continue;
            asked++;
            AssertRefuted(p, lie switch
            {
                "deeper" => r.With(distance: r.Distance - Little * size),
                "shallower" => r.With(distance: r.Distance + Little * size),
                "normal" => r.With(normal: -r.Normal),
                "turned" => r.With(normal: Vector3.Normalize(r.Normal + new Vector3(0.02f, 0.05f, -0.01f))),
                "no normal" => r.With(normal: default(Vector3)),
                "local A" => r.With(localA: r.LocalPointA + new Vector3(0.01f * size)),
                "point B" => r.With(pointB: r.PointB + new Vector3(0.01f * size)),
                "bound" => r.With(bound: 0.01f * size),
                _ => r.With(status: GjkStatus.Separated, distance: 0.01f * size),
            }, true);
        }

        Assert.True(asked > 50, $"only {asked} pairs");
    }

    [Fact]
    public void AWrongFlagIsRefuted()
    {
        foreach (HardCase c in CaseFamily.Load("touch").Cases.Concat(CaseFamily.Load("deep").Cases))
        {
            TestPair p = c.Pair;
            if (Math.Max(c.Distance, c.Depth) < 5e-8 * p.Scale) continue;
            CheckedAnswer check = AnswerCheck.Overlaps(p.A.Shape, p.PoseA, p.B.Shape, p.PoseB, !c.Overlap);
            Assert.True(check.Status == CheckStatus.Refuted, $"{check}\n{p}");
        }
    }

    /// <summary>Not those that only touch on the way, and not those whose whole way is within the tolerances.</summary>
    [Theory]
    [InlineData("early")]
    [InlineData("late")]
    [InlineData("normal")]
    [InlineData("turned")]
    [InlineData("point")]
    [InlineData("miss")]
    [InlineData("at the start")]
    public void AWrongHitIsRefuted(string lie)
    {
        foreach (CastCase c in CastFamily.Names.SelectMany(CastFamily.Load).Where(c => IsClear(c)))
        {
            CastResult r = c.Cast();
            float size = (float)(c.Pair.A.Shape.BoundingRadius + c.Pair.B.Shape.BoundingRadius);
            float closing = -Vector3.Dot(r.Normal, c.Velocity), step = 2 * Little * size / closing;
            step = Math.Max(step, 4e-6f * r.Fraction);
            if (step > r.Fraction) continue;
            AssertRefuted(c, lie switch
            {
                "early" => r.With(fraction: r.Fraction - step),
                "late" => r.With(fraction: r.Fraction + step),
                "normal" => r.With(normal: -r.Normal),
                "turned" => r.With(normal: Vector3.Normalize(r.Normal + new Vector3(0.1f, 0.15f, -0.1f))),
                "point" => r.With(point: r.Point + r.Normal * (0.01f * size)),
                "miss" => CastResult.Nothing(CastStatus.Miss, 1, 1),
                _ => new CastResult(CastStatus.OverlappingAtStart, 0, r.Point, default, 1),
            });
        }

        static bool IsClear(CastCase c)
        {
            CastResult r = c.Cast();
            bool closesIn = Vector3.Dot(r.Normal, c.Velocity) < -0.2f * c.Velocity.Length();
            return r.Status == CastStatus.Hit && r.Fraction is > 0.01f and < 0.97f && c.IsNormalUnique && closesIn
                && !new[] { "graze", "slide", "creep" }.Any(n => c.Pair.Name.Contains(n, StringComparison.Ordinal));
        }
    }

    /// <summary>Ellipsoids about one centre, whose depth no search has room for: the way out that a cast tells may be
    /// longer than the shortest one, but it is one.</summary>
    [Fact]
    public void ALongWayOutOfACastIsOpen()
    {
        const string Record =
            "gjk1 ellipsoid 0.47234414649251377 0.48060341513779292 0.42983013518446356 @ "
            + "-0.611402869 -0.0414017811 0.60775739 -0.504498065 -6.51561831E-17 4.23109152E-14 "
            + "-8.88706884E-15 ellipsoid 0.47234414649251377 0.48060341513779292 0.42983013518446356 @ "
            + "-0.789292037 0.400591105 0.459159195 0.0756152347 1.58527584E-07 -1.86792442E-06 "
            + "1.4060771E-06 ~ -0.264140904 0.0932587534 -0.565978348 0 0 0";
        QueryRecord p = QueryRecord.Parse(Record);
        CastResult r = p.Cast();
        DistanceResult s = ConvexQuery.SignedDistance(p.A, p.PoseA, p.B, p.PoseB);
        Assert.Equal((CastStatus.OverlappingAtStart, GjkStatus.IterationLimit), (r.Status, s.Status));
        Assert.Equal(CheckStatus.Open, Check(r));
        Assert.Equal(CheckStatus.Refuted, Check(Deep(1.001f * r.Depth)));
        Assert.Equal(CheckStatus.Refuted, Check(Deep(0.999f * r.Depth)));

        CastResult Deep(float depth) => new(r.Status, 0, r.Point, r.Normal, 1, depth);
        CheckStatus Check(CastResult told) =>
            AnswerCheck.Cast(p.A, p.PoseA, p.MotionA.Velocity, p.B, p.PoseB, p.MotionB.Velocity, told).Status;
    }

    [Fact]
    public void AWrongMissIsRefuted()
    {
        foreach (CastCase c in CastFamily.Load("cast_miss"))
        {
            CastResult hit = new(CastStatus.Hit, 0.5f, c.Pair.PoseB.Position, Vector3.UnitX, 1);
            AssertRefuted(c, hit);
            AssertRefuted(c, new CastResult(CastStatus.OverlappingAtStart, 0, c.Pair.PoseA.Position, default, 1));
        }
    }

    [Fact]
    public void AWrongRayIsRefuted()
    {
        var cone = new ConeShape(1, 1);
        var pose = new RigidPose(new Quaternion(0.6f, 0, 0, 0.8f), new Vector3(1, 2, 3));
        Vector3 origin = new(5, 2.1f, 3.2f), direction = -2 * Vector3.UnitX;
        RayCastResult r = ConvexQuery.RayCast(cone, pose, origin, direction);
        Assert.Equal(CheckStatus.Proved, AnswerCheck.RayCast(cone, pose, origin, direction, r).Status);
        RayCastResult[] lies =
        [
            new(r.Status, r.Distance * 1.0001f, r.Point, r.Normal, 0),
            new(r.Status, r.Distance * 0.9999f, r.Point, r.Normal, 0),
            new(r.Status, r.Distance, r.Point + new Vector3(0.01f), r.Normal, 0),
            new(r.Status, r.Distance, r.Point, -r.Normal, 0), RayCastResult.Nothing(CastStatus.Miss, 10, 0),
            new(CastStatus.OverlappingAtStart, 0, origin, default, 0),
        ];
        foreach (RayCastResult lie in lies)
            Assert.Equal(CheckStatus.Refuted, AnswerCheck.RayCast(cone, pose, origin, direction, lie).Status);
    }

    /// <summary>A ray without an end that misses is free for as far as it reaches.</summary>
    [Fact]
    public void AnEndlessRayThatMissesIsProved()
    {
        var box = new BoxShape(Vector3.One);
        RayCastResult r = ConvexQuery.RayCast(box, RigidPose.Identity, new Vector3(5, 1.5f, 0), -Vector3.UnitX);
        CheckedAnswer check = AnswerCheck.RayCast(
            box, RigidPose.Identity, new Vector3(5, 1.5f, 0), -Vector3.UnitX, r);
        Assert.Equal((CastStatus.Miss, CheckStatus.Proved), (r.Status, check.Status));
        Assert.Equal(double.PositiveInfinity, check.LowerBound);
    }

    private static CheckedAnswer Check(TestPair p, in DistanceResult r, bool isSigned) => isSigned
        ? AnswerCheck.SignedDistance(p.A.Shape, p.PoseA, p.B.Shape, p.PoseB, r)
        : AnswerCheck.Distance(p.A.Shape, p.PoseA, p.B.Shape, p.PoseB, r);

    private static void AssertRefuted(TestPair p, in DistanceResult told, bool isSigned)
    {
        CheckedAnswer check = Check(p, told, isSigned);
        Assert.True(check.Status == CheckStatus.Refuted, $"{check}; {told}, normal {told.Normal}\n{p}");
    }

    private static void AssertRefuted(CastCase c, in CastResult told)
    {
        CheckedAnswer check = AnswerCheck.Cast(
            c.Pair.A.Shape, c.Pair.PoseA, default, c.Pair.B.Shape, c.Pair.PoseB, c.Velocity, told);
        Assert.True(check.Status == CheckStatus.Refuted, $"{check}; {told}, truly {c.Outcome}\n{c.Pair}");
    }
}
