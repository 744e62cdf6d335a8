using Gjk.Demo.Study.Data;
using Gjk.Demo.Study.Fit;
using Gjk.Demo.Study.Plan;
using MathNet.Numerics.Distributions;

namespace Gjk.Demo.Study.Simulate;

/// <summary>What a simulated person sees: a gap looks closed below <see cref="Bias"/>, with Gaussian noise. Lengths are
/// in units of the scene.</summary>
internal sealed record Observer
{
    /// <summary>The gap that looks like touching half of the time.</summary>
    public double Bias { get; init; } = 0.012;

    /// <summary>The standard deviation of one judgement.</summary>
    public double Noise { get; init; } = 0.015;

    /// <summary>The share of careless answers at either end.</summary>
    public double Lapse { get; init; } = 0.02;

    /// <summary>The standard deviation of the bias between people.</summary>
    public double Between { get; init; } = 0.005;

    /// <summary>How much larger the bias is for each pair than for the pair before it in the plan.</summary>
    public double Difference { get; init; } = 0.006;

    /// <summary>How far an adjustment stays back towards where it began, as a share of the start's gap.</summary>
    public double StartPull { get; init; } = 0.02;
}

/// <summary>Simulated people who do a study.</summary>
internal static class Simulation
{
    public static IEnumerable<Trial> Run(StudyPlan plan, Observer observer, int people, int seed)
    {
        var random = new Random(seed);
        for (int person = 1; person <= people; person++)
        {
            double bias = observer.Bias + observer.Between * Normal.Sample(random, 0, 1);
            int number = 0;
            foreach (Trial trial in Person(plan, observer, bias, random))
                yield return trial with { Plan = plan.Id, Participant = $"simulated-{person}", Number = ++number };
        }
    }

    private static IEnumerable<Trial> Person(StudyPlan plan, Observer observer, double bias, Random random)
    {
        for (int p = 0; p < plan.Pairs.Count; p++)
        {
            PairPlan pair = plan.Pairs[p];
            var place = new Placement(pair, Vector3.UnitX);
            var curve = new Curve(CurveForm.Gaussian, bias + p * observer.Difference, observer.Noise, observer.Lapse);
            foreach (ViewPlan view in plan.Views)
            {
                var trial = new Trial { Pair = pair.Name, View = view.Name };
                foreach (Trial done in Adjustments(plan, observer, curve, trial, place, random)) yield return done;
                foreach (Trial done in Constants(plan, curve, trial, place, random)) yield return done;
                foreach (Trial done in Mismatches(plan, pair, curve, trial, random)) yield return done;
            }
        }

        if (plan.CatchTrials == 0) yield break;
        var first = new Placement(plan.Pairs[0], Vector3.UnitX);
        for (int i = 0; i < plan.CatchTrials; i++)
        {
            var curve = new Curve(CurveForm.Gaussian, bias, observer.Noise, observer.Lapse);
            var trial = new Trial { Pair = plan.Pairs[0].Name, View = plan.Views[0].Name, Kind = Trial.Catch };
            yield return Shown(trial, first, i % 2 == 0 ? plan.CatchGap : -plan.CatchGap, curve, random);
        }
    }

    private static IEnumerable<Trial> Adjustments(
        StudyPlan plan, Observer observer, Curve curve, Trial trial, Placement place, Random random)
    {
        for (int i = 0; i < plan.Adjustment?.Repeats; i++)
        {
            foreach (float start in plan.Adjustment.Starts)
            {
                double wanted = Normal.Sample(random, curve.Pse + observer.StartPull * start, observer.Noise);
                float at = place.Position((float)wanted);
                yield return trial with
                {
                    Task = Trial.Adjustment,
                    Start = start,
                    Distance = place.Distance(at),
                    Record = place.Record(at),
                };
            }
        }
    }

    private static IEnumerable<Trial> Constants(
        StudyPlan plan, Curve curve, Trial trial, Placement place, Random random)
    {
        for (int i = 0; i < plan.Constant?.Repeats; i++)
        {
            foreach (float gap in plan.Constant.Gaps) yield return Shown(trial, place, gap, curve, random);
        }
    }

    private static Trial Shown(Trial trial, Placement place, float gap, Curve curve, Random random)
    {
        float at = place.Position(gap), distance = place.Distance(at);
        return trial with
        {
            Task = Trial.Constant,
            Gap = gap,
            Distance = distance,
            Record = place.Record(at),
            Answer = random.NextDouble() < curve.Touching(distance) ? 1 : 0,
        };
    }

    /// <summary>What rests looks right if its gap or overlap looks like touching from either side.</summary>
    private static IEnumerable<Trial> Mismatches(
        StudyPlan plan, PairPlan pair, Curve curve, Trial trial, Random random)
    {
        foreach (string collider in plan.Mismatch?.Colliders ?? [])
        {
            Placement place = new(pair with { B = Collider.Of(pair.B, collider) }, Vector3.UnitY);
            float at = place.Position(0);
            var record = new QueryRecord(pair.A, place.PoseA, pair.B, place.PoseB(at));
            float distance = ConvexQuery.SignedDistance(pair.A, place.PoseA, pair.B, place.PoseB(at)).Distance;
            double right = Math.Min(curve.Touching(distance), 1 - curve.Touching(distance + 4 * curve.Scale));
            for (int i = 0; i < plan.Mismatch!.Repeats; i++)
            {
                yield return trial with
                {
                    Task = Trial.Mismatch,
                    Collider = collider,
                    Distance = distance,
                    Record = record.ToString(),
                    Answer = random.NextDouble() < right ? 1 : 0,
                };
            }
        }
    }
}
