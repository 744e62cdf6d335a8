using Gjk.Demo.Study.Fit;
using MathNet.Numerics.Distributions;

namespace Gjk.Demo.Study.Simulate;

/// <summary>How often a study finds a difference that is there.</summary>
/// <param name="People">How many take part.</param>
/// <param name="TrialsPerGap">How often each of them sees each gap of a condition.</param>
/// <param name="Power">The share of studies whose paired t test of the PSE is below 5 %.</param>
internal readonly record struct PowerPoint(int People, int TrialsPerGap, double Power);

/// <summary>Simulates whole studies of two conditions, fits every person, and counts what the test finds.</summary>
internal sealed class PowerSimulation
{
    public const double Wanted = 0.8;

    private const double Significant = 0.05;

    private readonly Observer _observer;
    private readonly float[] _gaps;
    private readonly int _studies, _seed;

    /// <param name="observer">The people; their Difference is the one to find.</param>
    /// <param name="gaps">The gaps that are shown.</param>
    /// <param name="studies">Simulated studies for each point.</param>
    /// <param name="seed">Where the random numbers begin.</param>
    public PowerSimulation(Observer observer, float[] gaps, int studies, int seed)
    {
        (_observer, _gaps, _studies, _seed) = (observer, gaps, studies, seed);
    }

    /// <summary>For each number of trials, points with more and more people, until the power is reached.</summary>
    public IEnumerable<PowerPoint> Until(IReadOnlyList<int> trialsPerGap, int mostPeople)
    {
        foreach (int trials in trialsPerGap)
        {
            for (int people = 4; people <= mostPeople; people += people < 16 ? 2 : people < 40 ? 4 : 10)
            {
                PowerPoint point = At(people, trials);
                yield return point;
                if (point.Power >= Wanted) break;
            }
        }
    }

    public PowerPoint At(int people, int trialsPerGap)
    {
        var random = new Random(_seed);
        int found = 0;
        for (int study = 0; study < _studies; study++)
        {
            double[] differences = [.. Enumerable.Range(0, people)
                .Select(_ => Difference(trialsPerGap, random)).Where(d => !double.IsNaN(d))];
            if (differences.Length >= 2 && PairedDifference.Test(differences) < Significant) found++;
        }

        return new PowerPoint(people, trialsPerGap, (double)found / _studies);
    }

    /// <summary>One person's difference of two fitted PSEs; NaN where a fit has no threshold.</summary>
    private double Difference(int trialsPerGap, Random random)
    {
        double bias = _observer.Bias + _observer.Between * Normal.Sample(random, 0, 1);
        return Pse(bias + _observer.Difference, trialsPerGap, random) - Pse(bias, trialsPerGap, random);
    }

    private double Pse(double bias, int trialsPerGap, Random random)
    {
        var curve = new Curve(CurveForm.Gaussian, bias, _observer.Noise, _observer.Lapse);
        var data = new PsychometricData(
            _gaps.Select(g => new GapCount(g, Binomial.Sample(random, curve.Touching(g), trialsPerGap), trialsPerGap)));
        CurveFit fit = CurveFit.Of(data, CurveForm.Gaussian, hasLapse: true);
        return fit.Status == FitStatus.Fitted ? fit.Curve.Pse : double.NaN;
    }
}
