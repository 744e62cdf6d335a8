using MathNet.Numerics;

namespace Gjk.Demo.Study.Fit;

/// <summary>The form of a psychometric function.</summary>
internal enum CurveForm
{
    /// <summary>The normal distribution, whose fit without lapses is the probit model.</summary>
    Gaussian,

    Logistic,
}

/// <summary>A psychometric function: the probability of the answer "touching" at a signed gap. It falls from 1 - lapse
/// to lapse, and it is one half at the point of subjective equality (PSE).</summary>
/// <param name="Form">The distribution.</param>
/// <param name="Pse">The gap at which both answers are equally likely, in units of the scene.</param>
/// <param name="Scale">The distribution's own spread: the standard deviation of the Gaussian, the scale of the
/// logistic.</param>
/// <param name="Lapse">The share of wrong answers far from the threshold, at either end.</param>
internal readonly record struct Curve(CurveForm Form, double Pse, double Scale, double Lapse)
{
    /// <summary>Spreads between the half and the upper quartile of the distribution.</summary>
    private static double QuartileOf(CurveForm form) => form == CurveForm.Gaussian ? 0.6744897501960817 : Math.Log(3);

    /// <summary>Just noticeable difference: from the PSE to 75 % (without lapses), in units of the scene.</summary>
    public double Jnd => Scale * QuartileOf(Form);

    /// <summary>How fast "touching" falls at the PSE, per unit of the scene; negative.</summary>
    public double Slope =>
        -(1 - 2 * Lapse) * (Form == CurveForm.Gaussian ? 1 / Math.Sqrt(2 * Math.PI) : 0.25) / Scale;

    public static double ScaleOf(CurveForm form, double jnd) => jnd / QuartileOf(form);

    public double Touching(double gap)
    {
        double z = (Pse - gap) / Scale;
        double rate = Form == CurveForm.Gaussian ? SpecialFunctions.Erfc(-z / Constants.Sqrt2) / 2
            : 1 / (1 + Math.Exp(-z));
        return Lapse + (1 - 2 * Lapse) * rate;
    }

    /// <summary>Minus the logarithm of the likelihood of the answers.</summary>
    public double Loss(PsychometricData data)
    {
        double loss = 0;
        foreach (GapCount c in data.Counts)
        {
            double p = Touching(c.Gap);
            if (c.Touching > 0) loss -= c.Touching * Math.Log(Math.Max(p, Smallest));
            if (c.Touching < c.Trials) loss -= (c.Trials - c.Touching) * Math.Log(Math.Max(1 - p, Smallest));
        }

        return loss;
    }

    /// <summary>Twice the logarithm of how much likelier the observed rates make the answers than the curve.</summary>
    public double Deviance(PsychometricData data)
    {
        double best = 0;
        foreach (GapCount c in data.Counts)
        {
            double p = (double)c.Touching / c.Trials;
            if (p is > 0 and < 1) best -= c.Touching * Math.Log(p) + (c.Trials - c.Touching) * Math.Log(1 - p);
        }

        return Math.Max(0, 2 * (Loss(data) - best));
    }

    /// <summary>A probability that no answer with it costs more than 690 of loss, which keeps the logarithm finite. No
    /// fit rests there, so its size does no harm.</summary>
    private const double Smallest = 1e-300;
}
