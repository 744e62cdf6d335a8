using MathNet.Numerics.Distributions;

namespace Gjk.Demo.Study.Fit;

/// <summary>The mean difference of two conditions over the people who did both.</summary>
/// <param name="A">The first condition.</param>
/// <param name="B">The second condition, which is subtracted.</param>
/// <param name="People">How many did both.</param>
/// <param name="Value">The mean, with an interval that holds for all differences of the table at once
/// (Bonferroni).</param>
/// <param name="P">The probability of such a mean without a difference: paired t test, corrected by Holm
/// (1979).</param>
internal readonly record struct PairedDifference(string A, string B, int People, Estimate Value, double P)
{
    /// <summary>All differences between conditions.</summary>
    /// <param name="values">For each condition, the value of each person.</param>
    public static PairedDifference[] All(IReadOnlyList<(string Name, Dictionary<string, double> Of)> values)
    {
        var raw = new List<(PairedDifference Difference, double[] Values)>();
        for (int a = 0; a < values.Count; a++)
        {
            for (int b = a + 1; b < values.Count; b++)
            {
                double[] differences =
                [
                    .. values[a].Of.Where(v => values[b].Of.ContainsKey(v.Key)).OrderBy(
                        v => v.Key, StringComparer.Ordinal)
                        .Select(v => v.Value - values[b].Of[v.Key]),
                ];
                if (differences.Length < 2) continue;
                raw.Add((
                    new PairedDifference(
                        values[a].Name, values[b].Name, differences.Length, default, Test(differences)),
                    differences));
            }
        }

        double[] corrected = Holm([.. raw.Select(r => r.Difference.P)]);
        return [.. raw.Select((r, i) => r.Difference with { Value = Interval(r.Values, raw.Count), P = corrected[i] })];
    }

    /// <summary>The two-sided probability of the paired t test.</summary>
    public static double Test(double[] differences)
    {
        double error = Bootstrap.Deviation(differences) / Math.Sqrt(differences.Length);
        double mean = differences.Average();
        if (error == 0) return mean == 0 ? 1 : 0;
        return 2 * StudentT.CDF(0, 1, differences.Length - 1, -Math.Abs(mean / error));
    }

    /// <summary>Holm's step-down correction: the k-th smallest of n is multiplied by n - k + 1, and none
    /// falls.</summary>
    public static double[] Holm(double[] p)
    {
        int[] order = [.. Enumerable.Range(0, p.Length).OrderBy(i => p[i])];
        var corrected = new double[p.Length];
        double most = 0;
        for (int k = 0; k < order.Length; k++)
        {
            most = Math.Max(most, Math.Min(1, (p.Length - k) * p[order[k]]));
            corrected[order[k]] = most;
        }

        return corrected;
    }

    private static Estimate Interval(double[] differences, int comparisons)
    {
        double mean = differences.Average();
        double t = StudentT.InvCDF(0, 1, differences.Length - 1, 1 - 0.025 / comparisons);
        double half = t * Bootstrap.Deviation(differences) / Math.Sqrt(differences.Length);
        return new Estimate(mean, mean - half, mean + half);
    }
}
