namespace Gjk.Demo.Study.Fit;

/// <summary>How many answers were "touching" at one signed gap.</summary>
/// <param name="Gap">The signed distance of the two objects, in units of the scene.</param>
/// <param name="Touching">Answers "touching".</param>
/// <param name="Trials">All answers; at least 1.</param>
internal readonly record struct GapCount(double Gap, int Touching, int Trials);

/// <summary>The answers of one person to one condition, counted for each gap, in ascending order of the gaps.</summary>
internal sealed class PsychometricData
{
    public PsychometricData(IEnumerable<(double Gap, bool IsTouching)> answers)
        : this(answers.GroupBy(a => a.Gap).Select(g => new GapCount(g.Key, g.Count(a => a.IsTouching), g.Count())))
    {
    }

    public PsychometricData(IEnumerable<GapCount> counts)
    {
        Counts = [.. counts.OrderBy(c => c.Gap)];
        Trials = Counts.Sum(c => c.Trials);
        Center = Counts.Sum(c => c.Gap * c.Trials) / Trials;
        Range = Counts[^1].Gap - Counts[0].Gap;
    }

    public GapCount[] Counts { get; }

    public int Trials { get; }

    /// <summary>The mean gap.</summary>
    public double Center { get; }

    /// <summary>The largest gap minus the smallest one.</summary>
    public double Range { get; }

    /// <summary>True if all answers are the same. No curve has a threshold then.</summary>
    public bool HasOneAnswer =>
        Counts.All(c => c.Touching == 0) || Counts.All(c => c.Touching == c.Trials);

    /// <summary>True if one gap separates the answers: every larger one got "apart" only, every smaller one "touching"
    /// only. The likelihood then grows for ever as the curve gets steeper, so it has no maximum.</summary>
    public bool IsStep =>
        Counts.Where(c => c.Touching > 0).Max(c => c.Gap) <= Counts.Where(c => c.Touching < c.Trials).Min(c => c.Gap);
}
