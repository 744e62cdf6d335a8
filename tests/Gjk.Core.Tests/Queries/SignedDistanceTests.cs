namespace Gjk.Core.Tests.Queries;

/// <summary>The signed distance of random pairs: certified, no direction cheaper, as deep as a search over all facets
/// says.</summary>
public class SignedDistanceTests
{
    [Fact]
    public void TheDepthOfPolytopesIsThatOfAllTheirFacets()
    {
        int overlapping = 0;
        for (ulong seed = 0; seed < (ulong)Budget.Count(400); seed++)
        {
            TestPair pair = Generators.Pair(71_000 + seed, Generators.PolytopeKinds, 0.6);
            DistanceResult r = pair.SignedDistance();
            if (!r.IsOverlapping) continue;
            overlapping++;
            double margins = pair.A.Margin + pair.B.Margin;
            bool coresOverlap = r.Distance < -margins * (1 + 1e-6) - 1e-6 && pair.A.Vertices!.Length > 3;
            if (!coresOverlap) continue;
            double truth = CloudDepth.Of(pair) + margins;
            Assert.True(
                Math.Abs(r.Distance + truth) <= 1.2e-7 * truth + 1e-12, $"{r.Distance:R}, depth {truth:R}: {pair}");
        }

        Assert.InRange(overlapping, 0.3 * Budget.Count(400), 0.95 * Budget.Count(400));
    }

    /// <summary>A certificate says that the way out is one; that none of many others is shorter is what can be said
    /// about every shape.</summary>
    [Fact]
    public void EveryAnswerIsCertifiedAndNoDirectionIsCheaper() => Each(72_000, 600, (pair, _) =>
    {
        DistanceResult r = pair.SignedDistance();
        if (r.Status == GjkStatus.IterationLimit) return pair.IsPolytope ? $"status {r.Status}" : null;
        string? problem = Certificate.ProblemOfSigned(
            pair.A.Shape, pair.PoseA, pair.B.Shape, pair.PoseB, r, pair.Scale, !pair.IsPolytope);
        if (problem is not null || !r.IsOverlapping) return problem;
        Body<ConvexShape> a = new(pair.A.Shape, pair.PoseA), b = new(pair.B.Shape, pair.PoseB);
        double cheapest = Directions.Many.Min(u => -Certificate.Gap(a, b, u));
        return -r.Distance <= cheapest + pair.Band(-r.Distance)
            ? null
            : $"depth {-r.Distance:R}, but a direction costs {cheapest:R}";
    });

    [Fact]
    public void ApartEveryFieldIsThatOfTheDistance() => Each(73_000, 600, (pair, _) =>
    {
        DistanceResult r = pair.SignedDistance(), d = pair.Distance();
        if (r.Status == GjkStatus.IterationLimit && d.IsOverlapping) return null;
        return r.Status == d.Status && (r.IsOverlapping || ResultBits.AreSame(r, d)) ? null : $"{r}, distance {d}";
    });

    [Fact]
    public void TypedShapesGiveTheSameBits()
    {
        for (ulong seed = 0; seed < (ulong)Budget.Count(300); seed++)
        {
            var rng = new Rng(74_000 + seed);
            Vector3 half = rng.Vector(0.1, 1);
            RigidPose poseA = Generators.Pose(rng, rng.Vector(-1, 1)), poseB = Generators.Pose(rng, rng.Vector(-1, 1));
            var hull = new ConvexHull(Clouds.InBox(rng, 12, Vector3.One));
            Same(new BoxShape(half), ConvexShape.Box(half), new ConvexMesh(hull), ConvexShape.Mesh(hull));
            Same(new CapsuleShape(1, 0.5f), ConvexShape.Capsule(1, 0.5f), new BoxShape(half), ConvexShape.Box(half));
            Same(new SphereShape(0.7f), ConvexShape.Sphere(0.7f), new ConvexMesh(hull), ConvexShape.Mesh(hull));
            Same(new SphereShape(0.7f), ConvexShape.Sphere(0.7f), new SphereShape(1), ConvexShape.Sphere(1));

            void Same<TA, TB>(in TA a, in ConvexShape closedA, in TB b, in ConvexShape closedB)
                where TA : struct, ISupportMap
                where TB : struct, ISupportMap
            {
                DistanceResult typed = ConvexQuery.SignedDistance(a, poseA, b, poseB);
                DistanceResult closed = ConvexQuery.SignedDistance(closedA, poseA, closedB, poseB);
                Assert.True(ResultBits.AreSame(typed, closed), $"seed {seed}: {typed}, closed {closed}");
            }
        }
    }

    [Fact]
    public void APairThatMovesIsAnsweredAsIfAskedForTheFirstTime() => Each(75_000, 200, (pair, rng) =>
    {
        var warm = default(WarmStart);
        Vector3 velocity = rng.UnitVector() * (float)(0.03 * pair.Scale);
        var turn = Quaternion.CreateFromAxisAngle(rng.UnitVector(), rng.Float(0, 0.1));
        RigidPose poseA = pair.PoseA;
        for (int frame = 0; frame < 10; frame++)
        {
            poseA = new RigidPose(Quaternion.Normalize(turn * poseA.Rotation), poseA.Position + velocity);
            TestPair moved = pair with { PoseA = poseA };
            DistanceResult cold = moved.SignedDistance();
            DistanceResult r = ConvexQuery.SignedDistance(moved.A.Shape, poseA, moved.B.Shape, moved.PoseB, ref warm);
            if (cold.Status == GjkStatus.IterationLimit || r.Status == GjkStatus.IterationLimit) continue;
            double band = 2 * pair.Band(Math.Abs(cold.Distance));
            if (!(Math.Abs(r.Distance - cold.Distance) <= band))
                return $"frame {frame}: {r.Status} {r.Distance:R}, cold {cold.Status} {cold.Distance:R} of {moved}";
            if (frame % 3 == 2) ConvexQuery.Distance(moved.A.Shape, poseA, moved.B.Shape, moved.PoseB, ref warm);
        }

        return null;
    });

    [Theory]
    [InlineData(1e-30f)]
    [InlineData(1e-10f)]
    [InlineData(1e10f)]
    [InlineData(1e30f)]
    public void ASizeIsOnlyAFactor(float factor) => Each(76_000, 100, (pair, _) =>
    {
        if (!pair.IsPolytope) return null;
        TestPair resized = pair.Resized(factor);
        string? problem = Certificate.ProblemOfSigned(
            resized.A.Shape, resized.PoseA, resized.B.Shape, resized.PoseB, resized.SignedDistance(), resized.Scale);
        return problem is null ? null : $"{problem} of {resized}";
    });

    [Fact]
    public void TheSimplexHoldsTheDeepestPoints() => Each(77_000, 300, (pair, _) =>
    {
        TestPair p = pair;
        DistanceResult r = ConvexQuery.SignedDistance(p.A.Shape, p.PoseA, p.B.Shape, p.PoseB, out FinalSimplex simplex);
        if (!ResultBits.AreSame(r, pair.SignedDistance())) return "another answer";
        if (r.Status == GjkStatus.IterationLimit) return null;
        Double3 onA = default;
        for (int i = 0; i < simplex.Count; i++) onA += simplex.PointOnA(i) * simplex.Weight(i);
        var body = new Body<ConvexShape>(p.A.Shape, p.PoseA);
        Double3 reached = onA + body.InverseRotate(r.Normal) * p.A.Shape.Margin;
        double off = (reached - r.LocalPointA).Length;
        return simplex.Count is >= 1 and <= 4 && off <= 1e-6 * (p.Scale + onA.Length) ? null : $"off by {off:R}";
    });

    private static void Each(ulong seed, int count, Func<TestPair, Rng, string?> examine)
    {
        for (ulong i = 0; i < (ulong)Budget.Count(count); i++)
        {
            TestPair pair = (i % 4) switch
            {
                0 => Generators.NearPair(seed + i, Generators.AllKinds, i % 8 == 0 ? -1e-3 : -1e-6),
                1 => Generators.MadePair(seed + i),
                _ => Generators.Pair(seed + i, Generators.AllKinds, 0.7),
            };
            string? problem = examine(pair, new Rng(seed ^ i));
            Assert.True(problem is null, $"{problem}\n{pair}");
        }
    }
}
