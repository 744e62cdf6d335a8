using System.Globalization;

namespace Gjk.Core.Tests.Cases;

/// <summary>The families of hard pairs with proved answers: no wrong flag, every distance exact to float rounding,
/// every result certified.</summary>
public class HardCaseTests
{
    private const int FailuresShown = 5;

    public static TheoryData<string> Families => [.. CaseFamily.Names];

    [Theory]
    [InlineData("parallel", 648)]
    [InlineData("align", 640)]
    [InlineData("touch", 860)]
    [InlineData("deep", 472)]
    [InlineData("aspect", 486)]
    [InlineData("large", 460)]
    [InlineData("degenerate", 744)]
    [InlineData("dense", 390)]
    [InlineData("everyday", 300)]
    [InlineData("offset", 150)]
    [InlineData("uneven", 200)]
    public void EveryPairIsThere(string family, int pairs)
    {
        IReadOnlyList<HardCase> cases = CaseFamily.Load(family).Cases;
        Assert.Equal(pairs, cases.Count);
        Assert.Contains(cases, c => c.Overlap);
        Assert.Contains(cases, c => !c.Overlap && c.Distance > 0);
    }

    [Theory]
    [MemberData(nameof(Families))]
    public void NoFlagIsWrong(string family) => Report(family, c =>
    {
        DistanceResult r = c.Pair.Distance();
        bool matters = Math.Max(c.Distance, c.Depth) > Accuracy.FlagScale * c.Pair.Scale;
        return (
            matters && r.IsOverlapping != c.Overlap ? double.PositiveInfinity : 0,
            $"overlap {r.IsOverlapping}, status {r.Status}");
    });

    [Theory]
    [MemberData(nameof(Families))]
    public void EveryDistanceIsExactToFloatRounding(string family) => Report(family, c =>
    {
        DistanceResult r = c.Pair.Distance();
        double error = Math.Abs(r.Distance - c.Distance);
        double ratio = error == 0 ? 0 : error / Accuracy.Band(c.Distance, c.Pair.Scale);
        return (
            double.IsNaN(ratio) ? double.PositiveInfinity : ratio,
            $"distance {r.Distance:R}, status {r.Status}, error {error:R}");
    });

    [Theory]
    [MemberData(nameof(Families))]
    public void NoPairReachesTheIterationLimit(string family) => Report(family, c =>
    {
        DistanceResult r = c.Pair.Distance();
        bool ended = r.Status is GjkStatus.Separated or GjkStatus.Overlapping
            && r.Iterations < GjkTolerances.MaxIterations / 2;
        return (ended ? 0 : double.PositiveInfinity, $"status {r.Status}, {r.Iterations} iterations");
    });

    [Theory]
    [MemberData(nameof(Families))]
    public void TheLowerBoundIsBelowTheTrueDistanceAndCloseToIt(string family) => Report(family, c =>
    {
        DistanceResult r = c.Pair.Distance();

        // The file's answers have 20 digits, a double 16.
        bool holds = r.LowerBound <= c.Distance * (1 + 2.3e-16);
        bool close = r.LowerBound >= r.Distance - Accuracy.Band(c.Distance, c.Pair.Scale);
        return (holds && close ? 0 : double.PositiveInfinity, $"lower bound {r.LowerBound:R}, distance {r.Distance:R}");
    });

    [Theory]
    [MemberData(nameof(Families))]
    public void EveryResultIsCertified(string family) => Report(family, c =>
    {
        string? problem = Certificate.Problem(
            c.Pair.A.Shape, c.Pair.PoseA, c.Pair.B.Shape, c.Pair.PoseB, c.Pair.Distance(), c.Pair.Scale);
        return (problem is null ? 0 : double.PositiveInfinity, problem ?? "");
    });

    [Theory]
    [MemberData(nameof(Families))]
    public void OverlapsSaysWhatDistanceSays(string family) => Report(family, c =>
    {
        bool flag = ConvexQuery.Overlaps(
            c.Pair.A.Shape, c.Pair.PoseA, c.Pair.B.Shape, c.Pair.PoseB, out GjkStatus status);
        DistanceResult r = c.Pair.Distance();
        return (
            flag == r.IsOverlapping && status == r.Status ? 0 : double.PositiveInfinity,
            $"Overlaps {flag} ({status}), Distance {r.Status} {r.Distance:R}");
    });

    [Theory]
    [MemberData(nameof(Families))]
    public void SwappingTheShapesMirrorsTheAnswer(string family) => Report(family, c =>
    {
        DistanceResult r = c.Pair.Distance(), s = c.Pair.Swapped.Distance();
        bool sameFlag = r.IsOverlapping == s.IsOverlapping
            || Math.Max(c.Distance, c.Depth) <= Accuracy.FlagScale * c.Pair.Scale;
        double error = Math.Abs(r.Distance - s.Distance), band = Accuracy.Band(c.Distance, c.Pair.Scale);
        return (
            sameFlag && error <= 2 * band ? 0 : double.PositiveInfinity,
            $"{r.Status} {r.Distance:R}, swapped {s.Status} {s.Distance:R}");
    });

    [Theory]
    [MemberData(nameof(Families))]
    public void AWarmStartChangesNothingBeyondTheAccuracy(string family)
    {
        var warm = default(WarmStart);
        Report(family, c =>
        {
            // The memory of another pair first, then its own.
            double worst = 0;
            for (int i = 0; i < 2; i++)
            {
                DistanceResult r = ConvexQuery.Distance(
                    c.Pair.A.Shape, c.Pair.PoseA, c.Pair.B.Shape, c.Pair.PoseB, ref warm);
                bool wrong = r.IsOverlapping != c.Overlap
                    && Math.Max(c.Distance, c.Depth) > Accuracy.FlagScale * c.Pair.Scale;
                double error = Math.Abs(r.Distance - c.Distance);
                double ratio = error == 0 ? 0 : error / Accuracy.Band(c.Distance, c.Pair.Scale);
                worst = wrong || double.IsNaN(ratio) ? double.PositiveInfinity : Math.Max(worst, ratio);
            }

            return (worst, "warm");
        });
    }

    /// <summary>Fails with the number of pairs whose error is above 1 (in units of what is allowed), and the worst of
    /// them in full.</summary>
    private static void Report(string family, Func<HardCase, (double Error, string Said)> examine)
    {
        var failures = new List<(double Error, string Said, HardCase Case)>();
        foreach (HardCase c in CaseFamily.Load(family).Cases)
        {
            (double error, string said) = examine(c);
            if (!(error <= 1)) failures.Add((error, said, c));
        }

        var shown = failures.OrderByDescending(f => f.Error).Take(FailuresShown);
        string worst = string.Join("\n", shown.Select(f => string.Create(
            CultureInfo.InvariantCulture,
            $"{f.Case.Pair.Name}: {f.Said}; truth: overlap {f.Case.Overlap}, distance {f.Case.Distance:R}, "
            + $"depth {f.Case.Depth:R}, scale {f.Case.Pair.Scale:R}, error {f.Error:R} of what is allowed")));
        Assert.True(failures.Count == 0, $"{family}: {failures.Count} pairs fail.\n{worst}");
    }
}
