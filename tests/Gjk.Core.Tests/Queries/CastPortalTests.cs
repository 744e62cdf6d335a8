namespace Gjk.Core.Tests.Queries;

/// <summary>Casts of polytopes against all half-spaces of their difference: the entry is the last that is
/// entered.</summary>
public class CastPortalTests
{
    private static readonly string[] Kinds = ["box", "hull", "needle", "plate", "mini", "big"];

    /// <summary>Any two, in any pose, on a line that is aimed anywhere near the middle or at the rim.</summary>
    [Fact]
    public void TheFirstContactIsTheLastHalfSpaceEntered()
    {
        int hits = 0, count = Budget.Count(1500);
        for (int i = 0; i < count; i++)
        {
            var rng = new Rng((ulong)i);
            TestShape a = Shape(rng, Kinds[i % Kinds.Length]), b = Shape(rng, Kinds[i / Kinds.Length % Kinds.Length]);
            Vector3 from = rng.Vector(-1, 1) * rng.Float(2, 12);
            var pair = new TestPair(
                $"portal {i}", a, Generators.Pose(rng, rng.Vector(-5, 5)), b, Generators.Pose(rng, from));
            Vector3 aim = rng.Vector(-1, 1) * (float)(pair.Scale * rng.Float(0, 0.8));
            Vector3 motion = (pair.PoseA.Position + aim - from) * rng.Float(0.6, 3);
            hits += Check(pair, motion) ? 1 : 0;
        }

        Assert.InRange(hits, 0.3 * count, 0.75 * count);
    }

    /// <summary>Along an axis that faces are square to and edges point along, corner over corner.</summary>
    [Fact]
    public void AlignedCratesMeetFaceToFace()
    {
        for (int i = 0; i < 600; i++)
        {
            var rng = new Rng((ulong)(900 + i));
            TestShape a = TestShape.Box(Vector3.One), b = TestShape.Box(new Vector3(1, 0.5f, 2));
            Vector3 at = new(rng.Below(9) * 0.25f, 4, rng.Below(9) * 0.25f);
            var pair = new TestPair($"crates {i}", a, RigidPose.Identity, b, new RigidPose(at));
            CastResult r = Cast(pair, new Vector3(0, -8, 0));
            Assert.Equal((CastStatus.Hit, 2.5f / 8, Vector3.UnitY), (r.Status, r.Fraction, r.Normal));
            Check(pair, new Vector3(rng.Below(5) - 2, -8, rng.Below(5) - 2));
        }
    }

    /// <summary>Round hulls, whose faces hardly differ: the planes on both sides prove the fraction.</summary>
    [Fact]
    public void LargeHullsEndWithinTheirRounds()
    {
        foreach (int points in new[] { 100, 1000, 5000 })
        {
            var rng = new Rng((ulong)points);
            var cloud = new Vector3[points];
            for (int i = 0; i < points; i++) cloud[i] = Vector3.Normalize(rng.Vector(-1, 1));
            ConvexShape hull = ConvexShape.Mesh(cloud);
            for (int i = 0; i < 100; i++)
            {
                Vector3 from = Vector3.Normalize(rng.Vector(-1, 1)) * 5, aim = rng.Vector(-0.9, 0.9);
                RigidPose poseA = new(rng.Rotation(), Vector3.Zero), poseB = new(rng.Rotation(), from);
                CastResult r = ConvexQuery.Cast(hull, poseA, default, hull, poseB, aim - from);
                Assert.True(r.Status == CastStatus.Hit, $"{points} {i}: {r}");
                Assert.InRange(r.Iterations, 4, 40);
                DistanceResult d = ConvexQuery.SignedDistance(
                    hull, poseA, hull, new RigidPose(poseB.Rotation, from + (aim - from) * r.Fraction));
                Assert.InRange(d.Distance, -1e-6, 1e-6);
            }
        }
    }

    /// <summary>A body that flies nearly along a face, with slopes down to where the portal hands over.</summary>
    [Fact]
    public void FlatSlopesEndAtTheSamePlace()
    {
        for (int i = 0; i < 400; i++)
        {
            var rng = new Rng((ulong)(40 + i));
            float slope = MathF.Pow(10, -rng.Float(0, 7));
            var pair = new TestPair(
                $"slope {i}", TestShape.Box(new Vector3(4, 1, 4)), RigidPose.Identity,
                TestShape.Box(new Vector3(0.25f)), new RigidPose(new Vector3(-8, 1.25f + slope * 5, rng.Float(-3, 3))));
            Check(pair, new Vector3(10, -10 * slope, rng.Float(-1, 1)));
        }
    }

    /// <summary>A segment falls through a triangle so flat that its own edges are nearly parallel to the motion: the
    /// planes along it are tilted by rounding, and prove nothing.</summary>
    [Fact]
    public void FlatThroughFlatIsNoMiss()
    {
        CastResult r = ConvexQuery.Cast(
            ConvexShape.Triangle(new(1, 2, 0), new(3, 0, 0), new(1, 3, 0)), RigidPose.Identity, default,
            ConvexShape.Segment(new(0, 1, 0), new(5, 2, 0)), new RigidPose(new Vector3(-7, 0, 1e-7f)),
            new Vector3(14, 0, -2e-7f));
        Assert.Equal((CastStatus.Hit, 0.5f), (r.Status, r.Fraction));
    }

    /// <summary>A point falls through a triangle of this height; a needle's normal is not believed.</summary>
    [Theory]
    [InlineData(2.5e-8f, false)]
    [InlineData(1.2e-7f, true)]
    public void ANeedleIsNoPortal(float height, bool isPortal) =>
        AssertPortal(
            isPortal, new(0, 2, 0), new(0, -4, 0),
            new(-1, 0, -height / 3), new(1, 0, -height / 3), new(0, 0, 2 * height / 3));

    /// <summary>A point flies through a triangle nearly along it.</summary>
    [Theory]
    [InlineData(0.5e-5f, false)]
    [InlineData(2e-5f, true)]
    public void AGrazedTriangleIsNoPortal(float slope, bool isPortal) =>
        AssertPortal(
            isPortal, new(-2, 2 * slope, 0), new(4, -4 * slope, 0), new(-1, 0, -1), new(1, 0, -1), new(0, 0, 1));

    /// <summary>A point falls onto a triangle with a tip. One that is level with the triangle is passed over, a high
    /// one makes a portal of its own, and in between nothing is certain.</summary>
    [Theory]
    [InlineData(3.5e-15f, true)]
    [InlineData(1.4e-14f, false)]
    [InlineData(0.5e-10f, false)]
    [InlineData(2e-10f, true)]
    public void ATipAboveAPortalIsLevelOrATurn(float tip, bool isPortal) =>
        AssertPortal(
            isPortal, new(0.1f, 2, -0.7f), new(0, -4, 0),
            new(-1, 0, -1), new(1, 0, -1), new(0, 0, 1), new(0, tip, -0.2f));

    private static void AssertPortal(bool isPortal, Vector3 from, Vector3 motion, params Vector3[] corners)
    {
        var mesh = new ConvexMesh(corners);
        var point = new PointShape();
        PairFrame.Compose(ref mesh, RigidPose.Identity, ref point, new RigidPose(from), out PairFrame frame);
        Assert.Equal(MotionVerdict.Hit, CastLine.Make(frame, motion, out CastLine line));
        frame.Translation = line.Nearest;
        SolverState.Make<ConvexMesh, PointShape>(frame, out SolverState state);
        CastFinding cast = default;
        MotionVerdict verdict = CastPortal.Solve(ref mesh, ref point, frame, line, 1, ref cast, ref state);
        Assert.Equal(isPortal ? MotionVerdict.Hit : MotionVerdict.Undecided, verdict);
    }

    private static CastResult Cast(TestPair p, Vector3 motion) =>
        ConvexQuery.Cast(p.A.Shape, p.PoseA, default, p.B.Shape, p.PoseB, motion);

    /// <summary>Whether it hits, as all half-spaces say.</summary>
    private static bool Check(TestPair pair, Vector3 motion)
    {
        CastResult r = Cast(pair, motion);
        (double entry, double exit, Double3 normal) = CloudDepth.Along(pair, motion);
        double speed = motion.Length(), graze = 1e-9 * pair.Scale / speed, way = Math.Max(entry, 0) * speed;
        string what = $"{pair} along {TestShape.T(motion)}: {r}, truly {entry:R} to {exit:R}";
        if (Math.Abs(exit - entry) < graze || Math.Abs(entry - 1) < graze || Math.Abs(entry) < graze) return r.IsHit;
        CastStatus truth = entry > exit || entry > 1 || exit < 0 ? CastStatus.Miss
            : entry < 0 ? CastStatus.OverlappingAtStart : CastStatus.Hit;
        Assert.True(r.Status == truth, what);
        if (truth != CastStatus.Hit) return r.IsHit;
        Assert.True(Math.Abs(r.Fraction - entry) * speed <= 1e-7 * Math.Max(pair.Scale, way), what);

        // Another normal is as good where its plane is entered no earlier.
        double slope = Double3.Dot(r.Normal, motion), at = PlaneOf(pair, r.Normal) / slope;
        bool isSame = ((Double3)r.Normal - normal).Length < 1e-6;
        Assert.True(isSame || (slope < 0 && (at - entry) * speed > -2e-6 * Math.Max(pair.Scale, way)), what);
        return true;
    }

    /// <summary>How far along n the difference reaches.</summary>
    private static double PlaneOf(TestPair p, Vector3 n)
    {
        var a = new Body<ConvexShape>(p.A.Shape, p.PoseA);
        var b = new Body<ConvexShape>(p.B.Shape, p.PoseB);
        Double3 between = (Double3)p.PoseB.Position - p.PoseA.Position;
        return p.A.Vertices!.Max(v => Double3.Dot(a.Rotate(v), n))
            - p.B.Vertices!.Min(v => Double3.Dot(b.Rotate(v) + between, n));
    }

    private static TestShape Shape(Rng rng, string kind) => kind switch
    {
        "box" => TestShape.Box(new Vector3(rng.Float(0.2, 2), rng.Float(0.2, 2), rng.Float(0.2, 2))),
        "needle" => TestShape.Mesh(Clouds.InBox(rng, 6, new Vector3(1e-3f, 2, 1e-3f))),
        "plate" => TestShape.Box(new Vector3(2, 1e-3f, rng.Float(0.5, 2))),
        "mini" => TestShape.Mesh(Clouds.InBox(rng, 5, new Vector3(1e-3f))),
        "big" => TestShape.Mesh(Clouds.InBox(rng, 8, new Vector3(4))),
        _ => TestShape.Mesh(Clouds.InBox(rng, 7, Vector3.One)),
    };
}
