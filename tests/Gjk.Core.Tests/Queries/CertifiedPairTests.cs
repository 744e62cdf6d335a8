namespace Gjk.Core.Tests.Queries;

/// <summary>Random pairs of every kind of shape, certified without a reference; consistency and symmetry on the same
/// pairs.</summary>
public class CertifiedPairTests
{
    public static TheoryData<string> Kinds => [.. Generators.AllKinds, .. Generators.LaterKinds, "bigHull"];

    [Theory]
    [MemberData(nameof(Kinds))]
    public void EveryResultIsCertified(string kind) => Each(kind, 300, 1.0, pair => Problem(pair, pair.Distance()));

    [Theory]
    [MemberData(nameof(Kinds))]
    public void OverlapsSaysWhatDistanceSays(string kind) => Each(kind, 300, 1.0, pair =>
    {
        DistanceResult r = pair.Distance();
        bool flag = ConvexQuery.Overlaps(pair.A.Shape, pair.PoseA, pair.B.Shape, pair.PoseB, out GjkStatus status);
        return flag == r.IsOverlapping && flag == pair.Overlaps() && status == r.Status
            ? null
            : $"Overlaps {flag} ({status}), Distance {r.Status} {r.Distance:R}";
    });

    [Theory]
    [MemberData(nameof(Kinds))]
    public void SwappingMirrorsTheAnswer(string kind) => Each(kind, 300, 1.0, pair =>
    {
        DistanceResult r = pair.Distance(), s = pair.Swapped.Distance();
        if (r.Status != s.Status) return $"{r.Status} {r.Distance:R}, swapped {s.Status} {s.Distance:R}";
        if (Math.Abs(r.Distance - s.Distance) > 2 * pair.Band(r.Distance))
            return $"distance {r.Distance:R}, swapped {s.Distance:R}";

        // The normal of the closest points is unique, but its direction is only as sure as the distance is long.
        double turn = ((Double3)r.Normal + s.Normal).Length * r.Distance;
        double sure = pair.IsPolytope ? 1e-6 * pair.Scale : 4e-3 * Math.Max(pair.Scale, r.Distance);
        return turn <= sure ? null : $"normal {r.Normal}, swapped {s.Normal}";
    });

    [Theory]
    [MemberData(nameof(Kinds))]
    public void NearlyTouchingPairsAreCertified(string kind)
    {
        foreach (double gap in new[] { 1e-2, 1e-4, 1e-6, -1e-4 })
        {
            for (ulong i = 0; i < (ulong)Budget.Count(40); i++)
            {
                TestPair pair = Generators.NearPair(40_000 + i, [kind, "hull", "sphere"], gap);
                string? problem = Problem(pair, pair.Distance());
                Assert.True(problem is null, $"{problem}\n{pair}");
            }
        }
    }

    [Fact]
    public void TheRandomPairsTestBothAnswers()
    {
        const int Count = 2000;
        int hits = 0;
        for (ulong i = 0; i < Count; i++)
            if (Generators.Pair(i, Generators.AllKinds, 0.8).Distance().IsOverlapping) hits++;
        Assert.InRange(hits, 0.3 * Count, 0.7 * Count);
    }

    [Fact]
    public void TheSameQueryGivesTheSameBits()
    {
        for (ulong i = 0; i < (ulong)Budget.Count(200); i++)
        {
            TestPair pair = Generators.Pair(60_000 + i, Generators.AllKinds);
            Assert.Equal(ResultBits.Of(pair.Distance()), ResultBits.Of(pair.Distance()));
        }
    }

    private static string? Problem(TestPair pair, in DistanceResult r) =>
        Certificate.Problem(pair.A.Shape, pair.PoseA, pair.B.Shape, pair.PoseB, r, pair.Scale, !pair.IsPolytope);

    private static void Each(string kind, int count, double spread, Func<TestPair, string?> examine)
    {
        for (ulong i = 0; i < (ulong)Budget.Count(count); i++)
        {
            var rng = new Rng(i);
            string other = Generators.AllKinds[rng.Below(Generators.AllKinds.Length)];
            TestPair pair = Generators.Pair(20_000 + i, [kind, other], spread);
            string? problem = examine(pair);
            Assert.True(problem is null, $"{problem}\n{pair}");
        }
    }
}
