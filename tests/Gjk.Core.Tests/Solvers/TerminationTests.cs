namespace Gjk.Core.Tests.Solvers;

/// <summary>How many rounds queries take: far from the cap on every valid pair, and never more than the cap on shapes
/// that lie.</summary>
public class TerminationTests
{
    /// <summary>What GjkTolerances.MaxIterations says of hulls, with room for a few pairs of which more than one solver
    /// looks at.</summary>
    private const int MostForHulls = 64;

    /// <summary>What it says of curved shapes, likewise.</summary>
    private const int MostForCurved = 128;

    public static TheoryData<string> Families => [.. CaseFamily.Names];

    [Theory]
    [MemberData(nameof(Families))]
    public void TheHardCasesTakeFewRounds(string family)
    {
        foreach (HardCase c in CaseFamily.Load(family).Cases) AssertFew(c.Pair, MostForHulls);
    }

    [Fact]
    public void OnTheAverageItIsAHandful()
    {
        double[] rounds =
        [
            .. CaseFamily.Names.SelectMany(f => CaseFamily.Load(f).Cases).Select(
                c => (double)c.Pair.Distance().Iterations)
        ];
        Assert.InRange(rounds.Average(), 2, 9);
    }

    [Fact]
    public void RandomPolytopesTakeFewRounds()
    {
        for (ulong i = 0; i < (ulong)Budget.Count(1000); i++)
            AssertFew(Generators.Pair(130_000 + i, [.. Generators.PolytopeKinds, "bigHull"]), MostForHulls);
    }

    [Fact]
    public void RandomCurvedShapesTakeFewRounds()
    {
        for (ulong i = 0; i < (ulong)Budget.Count(1000); i++)
            AssertFew(Generators.Pair(140_000 + i, Generators.AllKinds), MostForCurved);
    }

    /// <summary>Nearly touching is where a curved support creeps: each round halves the angle, and there is no vertex
    /// to end at.</summary>
    [Theory]
    [InlineData(0)]
    [InlineData(1e-7)]
    [InlineData(1e-4)]
    [InlineData(-1e-7)]
    [InlineData(-1e-4)]
    public void CurvedShapesThatNearlyTouch(double gap)
    {
        for (ulong i = 0; i < (ulong)Budget.Count(200); i++)
            AssertFew(Generators.NearPair(150_000 + i, Generators.CurvedKinds, gap), MostForCurved);
    }

    /// <summary>One side tells the truth, the other repeats a wrong corner, jumps, answers for another direction or
    /// slips further out each time.</summary>
    [Theory]
    [InlineData("stuck")]
    [InlineData("jumping")]
    [InlineData("turned")]
    [InlineData("growing")]
    [InlineData("late NaN")]
    public void ShapesThatContradictThemselvesEndWithinTheCap(string lie)
    {
        for (ulong i = 0; i < (ulong)Budget.Count(100); i++)
        {
            var rng = new Rng(i);
            var pose = new RigidPose(rng.Rotation(), rng.Vector(-3, 3));
            DistanceResult r = ConvexQuery.Distance(new Liar(lie), RigidPose.Identity, new BoxShape(Vector3.One), pose);
            Assert.True(
                r.Iterations <= 2 * GjkTolerances.MaxIterations && Enum.IsDefined(r.Status),
                $"{lie}, seed {i}: {r.Status} after {r.Iterations}");
            var warm = default(WarmStart);
            for (int k = 0; k < 2; k++)
            {
                Assert.True(
                    ConvexQuery.Distance(
                        new Liar(lie), RigidPose.Identity, new BoxShape(Vector3.One), pose,
                        ref warm).Iterations <= 2 * GjkTolerances.MaxIterations);
            }
            ConvexQuery.Overlaps(
                new Liar(lie), RigidPose.Identity, new BoxShape(Vector3.One), pose, out GjkStatus status);
            Assert.True(Enum.IsDefined(status));
        }
    }

    [Fact]
    public void ALieThatIsMetIsNamed()
    {
        var statuses = new HashSet<GjkStatus>();
        for (ulong i = 0; i < 100; i++)
        {
            var rng = new Rng(i);
            statuses.Add(
                ConvexQuery.Distance(
                    new Liar("turned"), RigidPose.Identity, new BoxShape(Vector3.One),
                    new RigidPose(rng.Rotation(), rng.Vector(-6, 6))).Status);
        }

        Assert.Contains(GjkStatus.InvalidShape, statuses);
    }

    private static void AssertFew(TestPair pair, int most)
    {
        DistanceResult r = pair.Distance();
        Assert.True(
            r.Status is GjkStatus.Separated or GjkStatus.Overlapping && r.Iterations <= most,
            $"{r.Status} after {r.Iterations} rounds\n{pair}");
    }

    /// <summary>A cube of half side 1 whose support lies.</summary>
    private readonly struct Liar(string lie) : ISupportMap
    {
        private readonly int[] _calls = new int[1];

        public Double3 Center => default;

        public double Margin => 0;

        public double BoundingRadius => 2;

        public int Support(in Double3 d, out Double3 point)
        {
            int call = _calls[0]++;
            point = Corner(d.X, d.Y, d.Z);
            if (lie == "stuck" && call > 1) point = new Double3(1, 1, 1);
            if (lie == "jumping" && call % 2 == 1) point = -point;
            if (lie == "turned") point = Corner(d.Y, d.Z, d.X);
            if (lie == "growing") point *= 1 + 0.1 * call;
            if (lie == "late NaN" && call > 1) point = new Double3(0, double.NaN, 0);
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

        private static Double3 Corner(double x, double y, double z) =>
            new(x < 0 ? -1 : 1, y < 0 ? -1 : 1, z < 0 ? -1 : 1);
    }
}
