using MathNet.Numerics.Distributions;
using MathNet.Numerics.Optimization;
using MathNet.Numerics.RootFinding;
using Numbers = MathNet.Numerics.LinearAlgebra.Vector<double>;

namespace Gjk.Demo.Study.Fit;

/// <summary>What could be learned from the answers.</summary>
internal enum FitStatus
{
    Fitted,

    /// <summary>All answers are the same.</summary>
    OneAnswer,

    /// <summary>One gap separates the answers, so the curve has no spread; see
    /// <see cref="PsychometricData.IsStep"/>.</summary>
    Step,

    /// <summary>"Touching" does not get rarer as the gap grows.</summary>
    NoSlope,
}

/// <summary>An estimate with its interval of 95 %.</summary>
internal readonly record struct Estimate(double Value, double Low, double High)
{
    public static readonly Estimate None = new(double.NaN, double.NaN, double.NaN);
}

/// <summary>The maximum-likelihood fit of a psychometric function. Nelder and Mead's simplex (MathNet.Numerics)
/// minimizes the loss over the PSE, the logarithm of the spread and, if asked for, the lapse rate. Gaps are shifted and
/// scaled to their mean and range first, so that no unit of length matters. Intervals are those of the profile
/// likelihood: all values whose best curve loses less than half of chi-squared's 95 % quantile (Kingdom and Prins 2016,
/// 4.4).</summary>
internal sealed class CurveFit
{
    /// <summary>A larger lapse rate is a person who does not do the task. Wichmann and Hill (2001) allow 0.06; a little
    /// more keeps the bound away from usual data. Pinned by CurveFitTests.LapsesAreFoundUpToTheirBound.</summary>
    public const double MostLapse = 0.1;

    /// <summary>Relative change of the loss at which the simplex ends. R's answers are met to 1e-4; a tolerance four
    /// times larger or smaller does no harm, since the parameters' error is its square root.</summary>
    private const double Tolerance = 1e-12;

    private const int MostSteps = 5_000;

    /// <summary>Half of the 95 % quantile of chi-squared with one degree of freedom.</summary>
    private const double HalfQuantile = 1.920729410347062;

    /// <summary>Ranges of gaps. A curve with a wider spread does not fall within the gaps that were shown.</summary>
    private const double WidestSpread = 10;

    private readonly PsychometricData _data;
    private readonly CurveForm _form;
    private readonly bool _hasLapse;
    private readonly double _unit;

    private CurveFit(PsychometricData data, CurveForm form, bool hasLapse)
    {
        (_data, _form, _hasLapse) = (data, form, hasLapse);
        _unit = data.Range > 0 ? data.Range : 1;
        if (data.HasOneAnswer) Status = FitStatus.OneAnswer;
        else if (data.IsStep) Status = FitStatus.Step;
        if (Status != FitStatus.Fitted) return;
        double[] best = Best(p => p, Start());
        Curve = CurveOf(best);
        if (best[1] > Math.Log(WidestSpread)) Status = FitStatus.NoSlope;
        Loss = Curve.Loss(data);
    }

    public FitStatus Status { get; }

    /// <summary>The likeliest curve, where <see cref="Status"/> is Fitted.</summary>
    public Curve Curve { get; }

    public double Loss { get; }

    public int Parameters => _hasLapse ? 3 : 2;

    public static CurveFit Of(PsychometricData data, CurveForm form, bool hasLapse) => new(data, form, hasLapse);

    public Estimate Pse()
    {
        double best = (Curve.Pse - _data.Center) / _unit;
        (double low, double high) = Profile(0, best);
        return new Estimate(Curve.Pse, _data.Center + low * _unit, _data.Center + high * _unit);
    }

    public Estimate Jnd()
    {
        (double low, double high) = Profile(1, Math.Log(Curve.Scale / _unit));
        double Jnd(double logarithm) => (Curve with { Scale = Math.Exp(logarithm) * _unit }).Jnd;
        return new Estimate(Curve.Jnd, Jnd(low), Jnd(high));
    }

    /// <summary>The share of studies by this very curve whose deviance is at least as large, by simulation: a check of
    /// fit that needs no large numbers (Wichmann and Hill 2001). Below 0.05 the curve does not describe the
    /// answers.</summary>
    public double FitProbability(int simulations, Random random)
    {
        double deviance = Curve.Deviance(_data);
        int larger = 0, done = 0;
        for (int i = 0; i < simulations; i++)
        {
            CurveFit again = Of(Simulated(Curve, _data, random), _form, _hasLapse);
            if (again.Status != FitStatus.Fitted) continue;
            done++;
            if (again.Curve.Deviance(again._data) >= deviance) larger++;
        }

        return (larger + 1.0) / (done + 1.0);
    }

    /// <summary>Answers that an observer with this curve could give to the same gaps.</summary>
    public static PsychometricData Simulated(Curve curve, PsychometricData like, Random random) =>
        new(like.Counts.Select(c => c with { Touching = Binomial.Sample(random, curve.Touching(c.Gap), c.Trials) }));

    private Curve CurveOf(IReadOnlyList<double> p)
    {
        double sine = _hasLapse ? Math.Sin(p[2]) : 0;
        return new Curve(_form, _data.Center + p[0] * _unit, Math.Exp(p[1]) * _unit, MostLapse * sine * sine);
    }

    /// <summary>The best of a coarse grid; the simplex then cannot end in a far local minimum.</summary>
    private double[] Start()
    {
        double[] best = [];
        double least = double.PositiveInfinity;
        for (int i = 0; i <= 8; i++)
        {
            for (int k = 0; k < 5; k++)
            {
                double pse = (_data.Counts[0].Gap - _data.Center) / _unit + i / 8.0;
                double[] at = [pse, Math.Log(Math.Pow(2, -k) / 2), .. _hasLapse ? [0.4] : Array.Empty<double>()];
                double loss = CurveOf(at).Loss(_data);
                if (loss < least) (least, best) = (loss, at);
            }
        }

        return best;
    }

    /// <summary>Minimizes the loss over free parameters that <paramref name="complete"/> makes all parameters
    /// of.</summary>
    private double[] Best(Func<double[], double[]> complete, double[] start)
    {
        IObjectiveFunction loss =
            ObjectiveFunction.Value(v => CurveOf(complete(v.AsArray() ?? v.ToArray())).Loss(_data));
        Numbers at = Numbers.Build.DenseOfArray(start);
        Numbers steps = Numbers.Build.Dense(start.Length, 0.1);
        try
        {
            return complete(NelderMeadSimplex.Minimum(loss, at, steps, Tolerance, MostSteps).MinimizingPoint.ToArray());
        }
        catch (MaximumIterationsException)
        {
            return complete(start);
        }
    }

    /// <summary>The ends of the profile-likelihood interval of one parameter.</summary>
    private (double Low, double High) Profile(int fixedIndex, double best)
    {
        double sine = _hasLapse ? Math.Asin(Math.Sqrt(Math.Min(1, Curve.Lapse / MostLapse))) : 0;
        double[] all = [(Curve.Pse - _data.Center) / _unit, Math.Log(Curve.Scale / _unit), .. Lapse(sine)];

        // At a bound of the lapse rate its angle has no effect, and a simplex that starts there does not move.
        if (_hasLapse) all[2] = Math.Clamp(all[2], 0.2, 1.3);
        double[] free = [.. all.Where((_, i) => i != fixedIndex)];
        double Excess(double value)
        {
            double[] Complete(double[] p) => [.. p[..fixedIndex], value, .. p[fixedIndex..]];
            return CurveOf(Best(Complete, free)).Loss(_data) - Loss - HalfQuantile;
        }

        return (End(Excess, best, -1), End(Excess, best, 1));
    }

    private double[] Lapse(double angle) => _hasLapse ? [angle] : [];

    private static double End(Func<double, double> excess, double best, int side)
    {
        double step = 0.05;
        double inside = best;
        for (int i = 0; i < 12; i++, step *= 2)
        {
            double outside = best + side * step;
            if (excess(outside) > 0)
            {
                return Brent.TryFindRoot(
                    excess, Math.Min(inside, outside), Math.Max(inside, outside), 1e-6, 60, out double root)
                    ? root
                    : outside;
            }

            inside = outside;
        }

        return side * double.PositiveInfinity;
    }
}
