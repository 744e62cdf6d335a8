namespace Gjk.Core.Tests.Queries;

/// <summary>Round hulls about one centre have thousands of ways out that are nearly equally long, more than the general
/// search has room for. Their depth is that of all facets of the difference.</summary>
public class HullDepthTests
{
    private static readonly ConvexHull Ico642 = RoundHulls.Ico(3), Uv642 = RoundHulls.Uv(21, 32);

    public static TheoryData<string> Balls => ["ico 642", "uv 642", "uv 1k", "uv 2k", "uv 4k", "ico 2562"];

    /// <summary>By all facets, for the size whose cost is promised.</summary>
    [Fact]
    public void TheDepthIsThatOfAllFacets()
    {
        foreach (ConvexHull hull in new[] { Ico642, Uv642 })
        {
            for (ulong seed = 0; seed < (ulong)Budget.Count(3); seed++)
            {
                var rng = new Rng(71_000 + seed);
                RigidPose poseA = Generators.Pose(rng, default);
                RigidPose poseB = Generators.Pose(rng, rng.UnitVector() * rng.LogFloat(1e-9, 1e-2));
                DistanceResult r = Depth(hull, poseA, hull, poseB);
                double truth = FacetDepth.Of(hull, poseA, hull, poseB);
                Assert.Equal(GjkStatus.Overlapping, r.Status);
                Assert.True(
                    Math.Abs(-r.Distance - truth) <= Accuracy.Band(truth, 2), $"{-r.Distance:R}, {truth:R}: {seed}");
            }
        }
    }

    /// <summary>In one place, one in the other, turned, and a little apart: none ends at the limit.</summary>
    [Theory]
    [MemberData(nameof(Balls))]
    public void BallsAboutOneCentreHaveADepth(string name)
    {
        ConvexHull hull = Hull(name);
        var smaller = new ConvexHull([.. Points(hull).Select(p => p * 0.7f)]);
        var rng = new Rng(72_000);
        RigidPose pose = Generators.Pose(rng, default), turned = Generators.Pose(rng, default);
        RigidPose near = Generators.Pose(rng, rng.UnitVector() * 1e-3f);
        AssertDepth(hull, RigidPose.Identity, hull, RigidPose.Identity);
        AssertDepth(hull, RigidPose.Identity, smaller, RigidPose.Identity);
        AssertDepth(hull, pose, hull, turned);
        AssertDepth(hull, pose, smaller, near);
        DistanceResult r = ConvexQuery.SignedDistance(new ConvexMesh(hull), pose, new PointShape(), turned);
        Assert.Equal(GjkStatus.Overlapping, r.Status);
    }

    /// <summary>A scale by powers of two is exact, so the hull of the scaled corners is the same hull.</summary>
    [Fact]
    public void AScaledHullIsTheHullOfItsScaledCorners()
    {
        var rng = new Rng(73_000);
        RigidPose pose = Generators.Pose(rng, default), turned = Generators.Pose(rng, default);
        foreach (Vector3 scale in new[] { new Vector3(-2), new Vector3(2, -2, 2), new Vector3(0.5f, 1, 1) })
        {
            var baked = new ConvexHull([.. Points(Ico642).Select(p => p * scale)]);
            DistanceResult r = ConvexQuery.SignedDistance(
                ConvexShape.Mesh(Ico642).Scaled(scale), pose, ConvexShape.Mesh(Ico642), turned);
            Assert.Equal(GjkStatus.Overlapping, r.Status);
            Assert.Equal(FacetDepth.Of(baked, pose, Ico642, turned), -r.Distance, 1e-6);
        }
    }

    /// <summary>Circles of sines and cosines cross in copies 1e-45 to 1e-16 apart; the facets between them have no
    /// normal but rounding. The first of the two hulls with every such crossing made one corner is the same but for
    /// rounding.</summary>
    [Fact]
    public void CornersInManyCopies()
    {
        string file = Path.Combine(ProjectFolder.Root, "tests", "Cases", "pole_copies.records.txt");
        foreach (string line in File.ReadLines(file))
        {
            QueryRecord p = QueryRecord.Parse(line);
            DistanceResult r = ConvexQuery.SignedDistance(p.A, p.PoseA, p.B, p.PoseB);
            double truth = FacetDepth.Of(WithoutCopies(p.A), p.PoseA, WithoutCopies(p.B), p.PoseB);
            Assert.Equal(GjkStatus.Overlapping, r.Status);
            Assert.Equal(truth, -r.Distance, 3e-7 * truth);
        }
    }

    private static ConvexHull WithoutCopies(in ConvexShape shape)
    {
        float scale = shape.Scale.X;
        return new(
            [.. Points(shape.Hull!).Select(p => (X: Near(p.X), Y: Near(p.Y), Z: Near(p.Z))).Distinct()
                .Select(p => new Vector3(p.X, p.Y, p.Z) * scale)]);
    }

    /// <summary>As far as the copies agree.</summary>
    private static float Near(float x) => Math.Abs(x) < 1e-12f ? 0 : x is > 0.99999f or < -0.99999f ? Math.Sign(x) : x;

    /// <summary>Where not one facet is as high as another, too many must be looked at: the first of them tell, and both
    /// bounds hold.</summary>
    [Fact]
    public void ASearchThatWouldTakeTooLongIsNotBegun()
    {
        ConvexHull spiral = RoundHulls.Spiral(4000);
        var mesh = new ConvexMesh(spiral);
        DistanceResult r = ConvexQuery.SignedDistance(mesh, RigidPose.Identity, mesh, RigidPose.Identity);
        Assert.Equal(GjkStatus.IterationLimit, r.Status);
        Assert.InRange(r.Iterations, 500, 4000);
        Double3 normal = r.Normal;
        double[] heights = [.. Points(spiral).Select(p => Double3.Dot(p, normal))];
        double cost = heights.Max() - heights.Min();
        Assert.InRange(-r.LowerBound, cost - 1e-6, cost + 1e-6);
        Assert.InRange(-r.Distance, 1.9, cost);
    }

    /// <summary>What has no facets is divided into cells: a round pin in a hole of many sides.</summary>
    [Theory]
    [InlineData(128)]
    [InlineData(256)]
    public void APinInAHoleOfManySides(int sides)
    {
        Vector3[] corners = Clouds.Prism(sides, 1, 1);
        for (ulong seed = 0; seed < (ulong)Budget.Count(8); seed++)
        {
            var rng = new Rng(74_000 + seed);
            RigidPose pose = Generators.Pose(rng, default);
            float radius = rng.Float(0.3, 0.9);
            var pair = new TestPair(
                $"seed {seed}", TestShape.Mesh("prism", new ConvexHull(corners), corners), pose,
                TestShape.Cylinder(radius, 1.5f), pose);
            DistanceResult r = pair.SignedDistance();
            Assert.Equal(GjkStatus.Overlapping, r.Status);
            double truth = Math.Cos(Math.PI / sides) + radius;
            Assert.InRange(-r.Distance, truth - 1e-6, truth + 1e-6 * pair.Scale);
        }
    }

    private static ConvexHull Hull(string name) => name switch
    {
        "ico 642" => Ico642,
        "uv 642" => Uv642,
        "uv 1k" => RoundHulls.Uv(24, 48),
        "uv 2k" => RoundHulls.Uv(33, 64),
        "uv 4k" => RoundHulls.Uv(45, 90),
        _ => RoundHulls.Ico(4),
    };

    private static IEnumerable<Vector3> Points(ConvexHull hull) =>
        Enumerable.Range(0, hull.VertexCount).Select(hull.GetVertex);

    private static DistanceResult Depth(ConvexHull a, in RigidPose poseA, ConvexHull b, in RigidPose poseB) =>
        ConvexQuery.SignedDistance(new ConvexMesh(a), poseA, new ConvexMesh(b), poseB);

    private static void AssertDepth(ConvexHull a, in RigidPose poseA, ConvexHull b, in RigidPose poseB)
    {
        DistanceResult r = Depth(a, poseA, b, poseB);
        Assert.Equal(GjkStatus.Overlapping, r.Status);
        string? problem = Certificate.ProblemOfSigned(new ConvexMesh(a), poseA, new ConvexMesh(b), poseB, r, 2);
        Assert.True(problem is null, problem);
    }
}
