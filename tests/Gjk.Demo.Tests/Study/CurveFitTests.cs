using System.Globalization;
using Gjk.Core.Tests.Support;
using Gjk.Demo.Study.Data;
using Gjk.Demo.Study.Fit;

namespace Gjk.Demo.Tests.Study;

public sealed class CurveFitTests
{
    private static readonly string Cases = Repository.File("tests/Gjk.Demo.Tests/Study/Cases");

    /// <summary>The answers are those of R 4.2.2: glm(answer ~ gap, binomial(link = "probit")), PSE and sigma from its
    /// coefficients, the deviance of the counts.</summary>
    public static IEnumerable<object[]> AnswersOfR() =>
        File.ReadLines(Path.Combine(Cases, "probit-answers.csv")).Skip(1).Select(line => line.Split(','))
            .Select(f => new object[] { f[0], Number(f[1]), Number(f[2]), Number(f[3]) });

    [Theory]
    [MemberData(nameof(AnswersOfR))]
    public void FitsWithoutLapseAreThoseOfR(string file, double pse, double sigma, double deviance)
    {
        List<Trial> trials = TrialFiles.Load([Path.Combine(Cases, $"probit-{file}.csv")], CancellationToken.None);
        var data = new PsychometricData(trials.Select(t => ((double)t.Distance, t.Answer == 1)));
        CurveFit fit = CurveFit.Of(data, CurveForm.Gaussian, hasLapse: false);
        Assert.Equal(FitStatus.Fitted, fit.Status);
        Assert.True(Math.Abs(fit.Curve.Pse - pse) < 1e-4 * sigma, $"{fit.Curve.Pse} for {pse}");
        Assert.True(Math.Abs(fit.Curve.Scale - sigma) < 1e-4 * sigma, $"{fit.Curve.Scale} for {sigma}");
        Assert.True(Math.Abs(fit.Curve.Deviance(data) - deviance) < 1e-4, $"{fit.Curve.Deviance(data)} for {deviance}");
    }

    [Theory]
    [InlineData(0, false, 1e-3)]
    [InlineData(0.02, true, 1)]
    public void ManyStudiesAreUnbiasedAndTheirIntervalsCover(double lapse, bool hasLapse, double unit)
    {
        var truth = new Curve(CurveForm.Gaussian, 0.2 * unit, unit, lapse);
        GapCount[] gaps = [.. Enumerable.Range(-4, 10).Select(i => new GapCount(0.6 * i * unit, 0, 40))];
        var like = new PsychometricData(gaps);
        var random = new Random(7);
        int studies = Budget.Whole(1_000);
        double pse = 0, jnd = 0;
        int pseCovered = 0, jndCovered = 0;
        for (int i = 0; i < studies; i++)
        {
            CurveFit fit = CurveFit.Of(CurveFit.Simulated(truth, like, random), CurveForm.Gaussian, hasLapse);
            Assert.Equal(FitStatus.Fitted, fit.Status);
            Estimate ofPse = fit.Pse(), ofJnd = fit.Jnd();
            pse += ofPse.Value / studies;
            jnd += ofJnd.Value / studies;
            if (ofPse.Low <= truth.Pse && truth.Pse <= ofPse.High) pseCovered++;
            if (ofJnd.Low <= truth.Jnd && truth.Jnd <= ofJnd.High) jndCovered++;
        }

        string said = $"bias {(pse - truth.Pse) / truth.Jnd:P2}, {(jnd - truth.Jnd) / truth.Jnd:P2} of the JND, "
            + $"covered {pseCovered}, {jndCovered} of {studies}";
        Assert.True(Math.Abs(pse - truth.Pse) < 0.05 * truth.Jnd, said);
        Assert.True(Math.Abs(jnd - truth.Jnd) < 0.05 * truth.Jnd, said);
        Assert.True(IsNominal(pseCovered, studies), said);
        Assert.True(IsNominal(jndCovered, studies), said);
    }

    [Fact]
    public void ManyStudiesOfManyPeopleCoverTheMean()
    {
        const int people = 10;
        int studies = Budget.Whole(1_000);
        var random = new Random(3);
        int covered = 0;
        for (int i = 0; i < studies; i++)
        {
            double[] values =
                [.. Enumerable.Range(0, people).Select(
                    _ => 5 + MathNet.Numerics.Distributions.Normal.Sample(random, 0, 2))];
            Estimate mean = Bootstrap.Of(values, Bootstrap.Mean, random);
            if (mean.Low <= 5 && 5 <= mean.High) covered++;
        }

        Assert.True(IsNominal(covered, studies), $"{covered} of {studies}");
    }

    /// <summary>Whether intervals of 95 % cover so often: within three standard deviations of the binomial.</summary>
    private static bool IsNominal(int covered, int studies) =>
        Math.Abs(covered - 0.95 * studies) <= 3 * Math.Sqrt(0.95 * 0.05 * studies);

    [Theory]
    [InlineData(0.01)]
    [InlineData(0.05)]
    [InlineData(0.09)]
    public void LapsesAreFoundUpToTheirBound(double lapse)
    {
        var truth = new Curve(CurveForm.Logistic, 0, 1, lapse);
        var data = new PsychometricData(Enumerable.Range(-10, 21)
            .Select(gap => new GapCount(gap, (int)Math.Round(truth.Touching(gap) * 100_000), 100_000)));
        CurveFit fit = CurveFit.Of(data, CurveForm.Logistic, hasLapse: true);
        Assert.Equal(lapse, fit.Curve.Lapse, 3);
        Assert.Equal(truth.Jnd, fit.Curve.Jnd, 2);
        Assert.Equal(truth.Slope, fit.Curve.Slope, 0.005);
    }

    [Fact]
    public void LapsesBeyondTheBoundStayAtIt()
    {
        var truth = new Curve(CurveForm.Gaussian, 0, 1, 0.2);
        var data = new PsychometricData(Enumerable.Range(-10, 21)
            .Select(gap => new GapCount(gap, (int)Math.Round(truth.Touching(gap) * 1_000), 1_000)));
        Assert.Equal(0.1, CurveFit.Of(data, CurveForm.Gaussian, hasLapse: true).Curve.Lapse, 6);
    }

    [Theory]
    [InlineData("5 5 5 5", FitStatus.OneAnswer)]
    [InlineData("5 5 0 0", FitStatus.Step)]
    [InlineData("5 2 0 0", FitStatus.Step)]
    [InlineData("1 2 3 5", FitStatus.NoSlope)]
    [InlineData("5 4 1 0", FitStatus.Fitted)]
    public void WhatHasNoThresholdIsSaid(string touching, object status)
    {
        var data =
            new PsychometricData(
                touching.Split(' ').Select((t, i) => new GapCount(i, int.Parse(t, CultureInfo.InvariantCulture), 5)));
        Assert.Equal((FitStatus)status, CurveFit.Of(data, CurveForm.Gaussian, hasLapse: false).Status);
    }

    [Fact]
    public void TheCheckOfFitIsEvenForTheTrueCurveAndSmallForAnother()
    {
        var truth = new Curve(CurveForm.Gaussian, 0, 1, 0);
        var like = new PsychometricData(Enumerable.Range(-3, 7).Select(gap => new GapCount(gap, 0, 30)));
        var random = new Random(5);
        int small = 0;
        for (int i = 0; i < 60; i++)
        {
            CurveFit fit = CurveFit.Of(CurveFit.Simulated(truth, like, random), CurveForm.Gaussian, hasLapse: false);
            if (fit.FitProbability(60, random) < 0.2) small++;
        }

        Assert.InRange(small, 4, 24);
        int[] odd = [30, 10, 25, 5, 25, 3, 0];
        var strange = new PsychometricData(odd.Select((t, i) => new GapCount(i, t, 30)));
        Assert.True(CurveFit.Of(strange, CurveForm.Gaussian, hasLapse: false).FitProbability(99, random) < 0.05);
    }

    [Fact]
    public void ManyComparisonsAreCorrectedAsHolmDoes()
    {
        // R: p.adjust(c(0.01, 0.04, 0.03, 0.5), "holm")
        Assert.Equal(
            [0.04, 0.09, 0.09, 0.5], PairedDifference.Holm([0.01, 0.04, 0.03, 0.5]).Select(p => Math.Round(p, 12)));
    }

    [Fact]
    public void ThePairedTestIsThatOfR()
    {
        // R: t.test(c(1.2, -0.3, 0.8, 2.1, 0.4, 0.9))$p.value
        Assert.Equal(0.04845389965, PairedDifference.Test([1.2, -0.3, 0.8, 2.1, 0.4, 0.9]), 9);
    }

    private static double Number(string text) => double.Parse(text, CultureInfo.InvariantCulture);
}
