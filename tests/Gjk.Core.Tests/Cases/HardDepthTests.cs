namespace Gjk.Core.Tests.Cases;

/// <summary>The signed distance of the hard pairs: every depth exact to float rounding, every way out certified, and
/// apart the bits of the distance.</summary>
public class HardDepthTests
{
    public static TheoryData<string> Families => [.. CaseFamily.DepthNames, .. CaseFamily.Names];

    [Theory]
    [InlineData("depth_box_deep", 75)]
    [InlineData("depth_box_shallow", 75)]
    [InlineData("depth_concentric", 390)]
    [InlineData("depth_far", 50)]
    [InlineData("depth_flush", 498)]
    [InlineData("depth_hull128", 18)]
    [InlineData("depth_hull32", 75)]
    [InlineData("depth_hull8", 75)]
    [InlineData("depth_needle", 54)]
    [InlineData("depth_nested", 48)]
    [InlineData("depth_ratio", 50)]
    [InlineData("depth_round", 75)]
    public void EveryPairIsThere(string family, int pairs) =>
        Assert.InRange(CaseFamily.Load(family).Cases.Count(c => c.Depth > 0), pairs * 9 / 10, pairs);

    [Theory]
    [MemberData(nameof(Families))]
    public void EveryDepthIsExactToFloatRounding(string family) => CaseFamily.Each(family, c =>
    {
        if (!c.Overlap) return null;
        DistanceResult r = c.Pair.SignedDistance();
        double band = Accuracy.Band(c.Depth, c.Pair.Scale);
        if (r.Status == GjkStatus.IterationLimit) return Limit(c, r);
        return r.IsOverlapping || c.Depth <= Accuracy.FlagScale * c.Pair.Scale
            ? Math.Abs(r.Distance + c.Depth) <= band ? null : $"signed distance {r.Distance:R}, allowed error {band:R}"
            : $"status {r.Status}";
    });

    [Theory]
    [MemberData(nameof(Families))]
    public void EveryWayOutIsCertified(string family) => CaseFamily.Each(family, c =>
    {
        DistanceResult r = c.Pair.SignedDistance();
        return r.Status == GjkStatus.IterationLimit
            ? null
            : Certificate.ProblemOfSigned(
                c.Pair.A.Shape, c.Pair.PoseA, c.Pair.B.Shape, c.Pair.PoseB, r, c.Pair.Scale);
    });

    [Theory]
    [MemberData(nameof(Families))]
    public void TheLowerBoundIsBelowTheTrueSignedDistance(string family) => CaseFamily.Each(family, c =>
    {
        DistanceResult r = c.Pair.SignedDistance();

        // The file's answers have 20 digits, a double 16.
        double truth = c.Overlap ? -c.Depth : c.Distance;
        return r.LowerBound <= truth + Math.Abs(truth) * 2.3e-16 ? null : $"lower bound {r.LowerBound:R}";
    });

    [Theory]
    [MemberData(nameof(Families))]
    public void ApartItIsTheDistanceBitForBit(string family) => CaseFamily.Each(family, c =>
    {
        DistanceResult r = c.Pair.SignedDistance(), d = c.Pair.Distance();
        if (r.Status == GjkStatus.IterationLimit) return null;
        if (r.Status != d.Status) return $"status {r.Status}, the distance's {d.Status}";
        return r.IsOverlapping || ResultBits.AreSame(r, d) ? null : $"{r}, the distance says {d}";
    });

    [Theory]
    [MemberData(nameof(Families))]
    public void SwappingTheShapesKeepsTheDepth(string family) => CaseFamily.Each(family, c =>
    {
        DistanceResult r = c.Pair.SignedDistance(), s = c.Pair.Swapped.SignedDistance();
        if (r.Status == GjkStatus.IterationLimit || s.Status == GjkStatus.IterationLimit) return null;
        double band = 2 * Accuracy.Band(Math.Abs(r.Distance), c.Pair.Scale);
        return Math.Abs(r.Distance - s.Distance) <= band ? null : $"{r.Distance:R}, swapped {s.Distance:R}";
    });

    [Theory]
    [MemberData(nameof(Families))]
    public void AWarmStartChangesNothingBeyondTheAccuracy(string family)
    {
        var warm = default(WarmStart);
        CaseFamily.Each(family, c =>
        {
            // The memory of another pair first, then its own, then that of its distance.
            double truth = c.Overlap ? -c.Depth : c.Distance;
            double band = Accuracy.Band(Math.Abs(truth), c.Pair.Scale);
            for (int i = 0; i < 3; i++)
            {
                TestPair p = c.Pair;
                DistanceResult r = ConvexQuery.SignedDistance(p.A.Shape, p.PoseA, p.B.Shape, p.PoseB, ref warm);
                if (r.Status == GjkStatus.IterationLimit) return Limit(c, r);
                if (!(Math.Abs(r.Distance - truth) <= band)) return $"query {i}: {r.Status}, {r.Distance:R}";
                if (i == 1) ConvexQuery.Distance(p.A.Shape, p.PoseA, p.B.Shape, p.PoseB, ref warm);
            }

            return null;
        });
    }

    /// <summary>The only pairs that outgrow the room are spheres of 4,096 vertices about one centre; their bounds are
    /// true.</summary>
    private static string? Limit(HardCase c, in DistanceResult r)
    {
        if (!c.Pair.Name.StartsWith("dense", StringComparison.Ordinal)) return $"status {r.Status}";
        bool holds = r.LowerBound <= -c.Depth && -c.Depth <= r.Distance && r.Distance < -0.99 * c.Depth;
        return holds ? null : $"bounds {r.LowerBound:R} and {r.Distance:R}";
    }
}
