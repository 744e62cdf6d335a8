using Gjk.Demo.Study.Data;

namespace Gjk.Demo.Study.Fit;

/// <summary>How a study is analysed.</summary>
internal sealed record AnalysisSettings
{
    public CurveForm Form { get; init; } = CurveForm.Gaussian;

    public bool HasLapse { get; init; } = true;

    /// <summary>Conditions are told apart by pair, or by view, or by both.</summary>
    public string By { get; init; } = "pair";

    /// <summary>A person who fails a larger share of the catch trials is left out.</summary>
    public double MostCatchErrors { get; init; } = 0.25;

    /// <summary>Simulated studies for the check of fit.</summary>
    public int Simulations { get; init; } = 200;

    public int Seed { get; init; } = 1;
}

/// <summary>One person's answers to one condition, and the curve through them.</summary>
internal sealed record PersonCurve(string Condition, string Person, PsychometricData Data, CurveFit Fit);

/// <summary>Everything that is learned from the trials of a study. People who fail catch trials are left out, and
/// practice never counts. First every person is measured alone; what is said of all is the mean of people, with an
/// interval by resampling people (Davison and Hinkley 1997, 3.8: trials of one person are not independent samples of
/// people).</summary>
internal sealed class StudyAnalysis
{
    private readonly AnalysisSettings _settings;
    private readonly Random _random;
    private readonly List<StudyRow> _rows = [];
    private readonly List<PersonCurve> _curves = [];

    public StudyAnalysis(IReadOnlyList<Trial> trials, AnalysisSettings settings)
    {
        (_settings, _random) = (settings, new Random(settings.Seed));
        Exclude(trials);
        Trial[] real = [.. trials.Where(t => t.Kind == Trial.Real && !Excluded.Contains(t.Participant))];
        if (real.Length == 0) throw new RefusedException(
            "no trials are left after practice, catch trials and exclusions");
        IncludedPeople = real.Select(t => t.Participant).Distinct().Count();
        Adjustments([.. real.Where(t => t.Task == Trial.Adjustment)]);
        Constants([.. real.Where(t => t.Task == Trial.Constant)]);
        Mismatches([.. real.Where(t => t.Task == Trial.Mismatch)]);
    }

    public List<string> Excluded { get; } = [];

    public int IncludedPeople { get; }

    public IReadOnlyList<StudyRow> Rows => _rows;

    public IReadOnlyList<PersonCurve> Curves => _curves;

    private void Exclude(IReadOnlyList<Trial> trials)
    {
        foreach (
            IGrouping<string, Trial> person in trials.Where(t => t.Kind == Trial.Catch).GroupBy(t => t.Participant))
        {
            int wrong = person.Count(t => t.Answer == 1 == t.Distance > 0), all = person.Count();
            bool isOut = wrong > _settings.MostCatchErrors * all;
            if (isOut) Excluded.Add(person.Key);
            _rows.Add(new StudyRow(
                Trial.Catch, "", person.Key, "errors", Estimate.None with { Value = (double)wrong / all }, all,
                    double.NaN,
                isOut ? "excluded" : ""));
        }
    }

    private string ConditionOf(Trial trial)
    {
        string name = _settings.By switch
        {
            "pair" => trial.Pair,
            "view" => trial.View,
            _ => $"{trial.Pair}/{trial.View}",
        };
        return trial.Task == Trial.Mismatch ? $"{name}/{trial.Collider}" : name;
    }

    private void Adjustments(Trial[] trials)
    {
        var means = new People();
        foreach ((string condition, string person, Trial[] own) in Cells(trials))
        {
            double[] gaps = [.. own.Select(t => (double)t.Distance)];
            Estimate mean = Bootstrap.Of(gaps, Bootstrap.Mean, _random);
            Add(Trial.Adjustment, condition, person, "mean", mean, own.Length);
            means.Add("mean", condition, person, mean.Value);
            if (gaps.Length > 1)
            {
                Estimate spread = Bootstrap.Of(gaps, Bootstrap.Deviation, _random);
                Add(Trial.Adjustment, condition, person, "spread", spread, own.Length);
                means.Add("spread", condition, person, spread.Value);
            }

            double[] apart = [.. own.Where(t => t.Start > 0).Select(t => (double)t.Distance)];
            double[] overlapping = [.. own.Where(t => t.Start <= 0).Select(t => (double)t.Distance)];
            if (apart.Length == 0 || overlapping.Length == 0) continue;
            Estimate bias = Bootstrap.Difference(apart, overlapping, _random);
            Add(Trial.Adjustment, condition, person, "start bias", bias, own.Length);
            means.Add("start bias", condition, person, bias.Value);
        }

        Together(Trial.Adjustment, means, ["mean", "spread", "start bias"], "mean");
    }

    private void Constants(Trial[] trials)
    {
        foreach (IGrouping<string, Trial> condition in trials.GroupBy(ConditionOf))
        {
            if (condition.Select(t => t.Answer).Distinct().Count() > 1) continue;
            string word = condition.First().Answer == 1 ? "touching" : "not touching";
            throw new RefusedException(
                $"condition {condition.Key}: all {condition.Count()} answers are \"{word}\", so there is no threshold");
        }

        var values = new People();
        foreach ((string condition, string person, Trial[] own) in Cells(trials))
        {
            var data = new PsychometricData(own.Select(t => ((double)t.Distance, t.Answer == 1)));
            CurveFit fit = CurveFit.Of(data, _settings.Form, _settings.HasLapse);
            _curves.Add(new PersonCurve(condition, person, data, fit));
            AddCurve(condition, person, data, fit, values);
        }

        Together(Trial.Constant, values, ["pse", "jnd", "slope"], "pse", "jnd");
    }

    private void AddCurve(string condition, string person, PsychometricData data, CurveFit fit, People values)
    {
        void Write(string measure, Estimate value, string note = "") =>
            _rows.Add(new StudyRow(Trial.Constant, condition, person, measure, value, data.Trials, double.NaN, note));
        if (fit.Status != FitStatus.Fitted)
        {
            Write("pse", Estimate.None, fit.Status switch
            {
                FitStatus.OneAnswer => "no threshold: all answers are the same",
                FitStatus.Step => "no spread: one gap separates the answers",
                _ => "no threshold: the answers do not follow the gap",
            });
            return;
        }

        Estimate pse = fit.Pse(), jnd = fit.Jnd();
        double deviance = fit.Curve.Deviance(data), probability = fit.FitProbability(_settings.Simulations, _random);
        Write("pse", pse);
        Write("jnd", jnd);
        Write("slope", Estimate.None with { Value = fit.Curve.Slope });
        if (_settings.HasLapse) Write("lapse", Estimate.None with { Value = fit.Curve.Lapse });
        Write("deviance", Estimate.None with { Value = deviance },
            $"{data.Counts.Length - fit.Parameters} degrees of freedom");
        Write("fit", Estimate.None with { Value = probability },
            probability < 0.05 ? "the curve does not describe the answers" : "");
        values.Add("pse", condition, person, pse.Value);
        values.Add("jnd", condition, person, jnd.Value);
        values.Add("slope", condition, person, fit.Curve.Slope);
    }

    private void Mismatches(Trial[] trials)
    {
        var rates = new People();
        foreach ((string condition, string person, Trial[] own) in Cells(trials))
            rates.Add("looks right", condition, person, own.Average(t => t.Answer));
        Together(Trial.Mismatch, rates, ["looks right"]);
        foreach (IGrouping<string, Trial> condition in trials.GroupBy(ConditionOf))
        {
            double mean = condition.Average(t => t.Distance);
            Add(Trial.Mismatch, condition.Key, StudyRow.Everybody, "drawn gap", Estimate.None with { Value = mean },
                condition.Count());
        }
    }

    private IEnumerable<(string Condition, string Person, Trial[] Trials)> Cells(Trial[] trials) =>
        from condition in trials.GroupBy(ConditionOf)
        from person in condition.GroupBy(t => t.Participant)
        select (condition.Key, person.Key, person.ToArray());

    private void Add(string task, string condition, string who, string measure, Estimate value, int count) =>
        _rows.Add(new StudyRow(task, condition, who, measure, value, count, double.NaN, ""));

    /// <summary>Adds the means of people, and the differences between conditions.</summary>
    private void Together(string task, People people, string[] measures, params string[] compared)
    {
        foreach (string measure in measures)
        {
            foreach ((string condition, Dictionary<string, double> of) in people.Of(measure))
                Add(task, condition, StudyRow.Everybody, measure,
                    Bootstrap.Of([.. of.Values], Bootstrap.Mean, _random), of.Count);
        }

        foreach (string measure in compared)
        {
            foreach (PairedDifference d in PairedDifference.All(people.Of(measure)))
            {
                _rows.Add(new StudyRow(
                    task, $"{d.A} - {d.B}", StudyRow.Everybody, $"difference of {measure}", d.Value, d.People, d.P,
                        ""));
            }
        }
    }

    /// <summary>The values of people by measure and condition, in order of appearance.</summary>
    private sealed class People
    {
        private readonly List<(string Measure, string Condition, Dictionary<string, double> Of)> _all = [];

        public void Add(string measure, string condition, string person, double value)
        {
            int at = _all.FindIndex(a => a.Measure == measure && a.Condition == condition);
            if (at < 0)
            {
                at = _all.Count;
                _all.Add((measure, condition, []));
            }

            _all[at].Of.Add(person, value);
        }

        public List<(string Name, Dictionary<string, double> Of)> Of(string measure) =>
            [.. _all.Where(a => a.Measure == measure).Select(a => (a.Condition, a.Of))];
    }
}
