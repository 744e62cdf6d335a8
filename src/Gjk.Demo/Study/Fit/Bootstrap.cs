using MathNet.Numerics.Distributions;

namespace Gjk.Demo.Study.Fit;

/// <summary>Intervals by resampling with replacement. Percentiles of few values are too narrow, so that their
/// probabilities are widened as Hesterberg (2015) proposes: 2.5 % becomes Phi(-sqrt(n / (n - 1)) t), with Student's
/// quantile t.</summary>
internal static class Bootstrap
{
    public const int Resamples = 4_000;

    /// <summary>The interval of 95 % for a statistic of independent values.</summary>
    public static Estimate Of(IReadOnlyList<double> values, Func<double[], double> statistic, Random random)
    {
        double[] sample = [.. values];
        double value = statistic(sample);
        int n = sample.Length;
        if (n < 2) return new Estimate(value, double.NaN, double.NaN);
        var statistics = new double[Resamples];
        for (int i = 0; i < Resamples; i++)
        {
            for (int k = 0; k < n; k++) sample[k] = values[random.Next(n)];
            statistics[i] = statistic(sample);
        }

        Array.Sort(statistics);
        double t = StudentT.InvCDF(0, 1, n - 1, 0.975);
        double tail = Normal.CDF(0, 1, -Math.Sqrt(n / (n - 1.0)) * t);
        return new Estimate(value, At(statistics, tail), At(statistics, 1 - tail));
    }

    /// <summary>The interval of a difference of two means of values that are resampled apart.</summary>
    public static Estimate Difference(IReadOnlyList<double> a, IReadOnlyList<double> b, Random random)
    {
        if (a.Count < 2 || b.Count < 2) return new Estimate(a.Average() - b.Average(), double.NaN, double.NaN);
        double[] differences = new double[Resamples];
        for (int i = 0; i < Resamples; i++) differences[i] = ResampledMean(a, random) - ResampledMean(b, random);
        Array.Sort(differences);
        return new Estimate(a.Average() - b.Average(), At(differences, 0.025), At(differences, 0.975));
    }

    public static double Mean(double[] values) => values.Average();

    /// <summary>The standard deviation of the population that the values are a sample of; NaN for one value.</summary>
    public static double Deviation(double[] values)
    {
        double mean = values.Average();
        return Math.Sqrt(values.Sum(v => (v - mean) * (v - mean)) / (values.Length - 1));
    }

    private static double ResampledMean(IReadOnlyList<double> values, Random random)
    {
        double sum = 0;
        for (int i = 0; i < values.Count; i++) sum += values[random.Next(values.Count)];
        return sum / values.Count;
    }

    private static double At(double[] sorted, double probability)
    {
        double at = probability * (sorted.Length - 1);
        int low = (int)at;
        return sorted[low] + (at - low) * (sorted[Math.Min(low + 1, sorted.Length - 1)] - sorted[low]);
    }
}
