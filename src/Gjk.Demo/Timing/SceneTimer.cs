namespace Gjk.Demo.Timing;

/// <summary>Times the verbs on one scene.</summary>
internal sealed class SceneTimer
{
    /// <summary>How the time is divided. The cold distance gets the most, because everything else is compared with
    /// it.</summary>
    private const double ColdShare = 0.3, OtherShare = 0.1, BatchShare = 0.1;

    /// <summary>The least number of queries in a sample. Otherwise, for a list of only a few pairs, reading the clock
    /// would be a part of the figure.</summary>
    private const int LeastQueriesPerSample = 512;

    private readonly PairLoop _pairs;
    private readonly ConcaveLoop? _concave;
    private readonly ScenePath _path;
    private readonly TimeSpan _duration;
    private readonly Action<double> _progress;
    private readonly CancellationToken _cancel;
    private double _done;

    /// <param name="scene">The scene.</param>
    /// <param name="duration">How long to measure, after the warm-ups.</param>
    /// <param name="progress">Receives the completed share, from 0 to 1, between the measurements.</param>
    /// <param name="cancel">Ends the work.</param>
    public SceneTimer(Scene scene, TimeSpan duration, Action<double> progress, CancellationToken cancel)
    {
        _pairs = new PairLoop(scene, cancel);
        _concave = scene.IsConvex ? null : new ConcaveLoop(scene, cancel);
        _path = new ScenePath(scene);
        AreCastsTimed = scene.HasVelocities && !scene.HasTurns;
        _duration = duration;
        _progress = progress;
        _cancel = cancel;
    }

    /// <summary>True if an object has a velocity, and none turns.</summary>
    public bool AreCastsTimed { get; }

    /// <summary>Measures everything. Without pairs there is nothing to measure, and all means are null.</summary>
    public SceneTimes Run()
    {
        var times = new SceneTimes { Pairs = _pairs.Count };
        if (_pairs.Count == 0) return times;
        if (_concave is null) MeasureConvex(times);
        else MeasureConcave(times, _concave);
        _progress(1);
        return times;
    }

    private void MeasureConvex(SceneTimes times)
    {
        Samples cold = Measure(_pairs.Cold, _pairs.Count, ColdShare);
        times.Overlapping = _pairs.Overlapping;
        times.Iterations = (double)_pairs.Iterations / _pairs.Count;
        times.ColdNs = cold.MinimumNs;
        times.ColdMedianNs = cold.MedianNs;
        times.BytesPerCall = BytesPerCall(_pairs.Cold);
        times.WarmNs = Measure(() => _pairs.Warm(), _pairs.Count, OtherShare).MinimumNs;
        times.MovingNs = MeasureMoving(_pairs.Warm);
        times.BoolNs = Measure(_pairs.Boolean, _pairs.Count, OtherShare).MinimumNs;
        times.BatchNs = Measure(_pairs.Batch, _pairs.Count, BatchShare).MinimumNs;
        times.BatchWarmNs = Measure(_pairs.BatchWarm, _pairs.Count, BatchShare).MinimumNs;
        times.BatchBoolNs = Measure(_pairs.BatchBoolean, _pairs.Count, BatchShare).MinimumNs;
        int overlapping = _pairs.CollectOverlapping();
        if (overlapping > 0) times.DepthNs = Measure(_pairs.Depth, overlapping, OtherShare).MinimumNs;
        if (AreCastsTimed) times.CastNs = Measure(_pairs.Casts, _pairs.Count, OtherShare).MinimumNs;
    }

    private void MeasureConcave(SceneTimes times, ConcaveLoop pairs)
    {
        Samples cold = Measure(() => pairs.Distances(), _pairs.Count, ColdShare);
        times.Overlapping = pairs.Overlapping;
        times.Iterations = (double)pairs.Iterations / _pairs.Count;
        times.ColdNs = cold.MinimumNs;
        times.ColdMedianNs = cold.MedianNs;
        times.BytesPerCall = BytesPerCall(() => pairs.Distances());
        times.MovingNs = MeasureMoving(pairs.Distances);
        times.BoolNs = Measure(pairs.Boolean, _pairs.Count, OtherShare).MinimumNs;
        if (AreCastsTimed) times.CastNs = Measure(pairs.Casts, _pairs.Count, OtherShare).MinimumNs;
    }

    private double MeasureMoving(Action<RigidPose[]> pass)
    {
        void Move()
        {
            foreach (RigidPose[] poses in _path.Round()) pass(poses);
        }

        return Measure(Move, (long)_pairs.Count * _path.FramesPerRound, OtherShare).MinimumNs;
    }

    /// <summary>The least of several passes: the runtime allocates now and then too, but not in every pass.</summary>
    private double BytesPerCall(Action coldPass)
    {
        const int Passes = 3;
        long least = long.MaxValue;
        for (int pass = 0; pass < Passes; pass++)
        {
            long before = GC.GetAllocatedBytesForCurrentThread();
            coldPass();
            least = Math.Min(least, GC.GetAllocatedBytesForCurrentThread() - before);
        }

        return (double)least / _pairs.Count;
    }

    /// <summary>Warms up and measures.</summary>
    /// <param name="pass">The work.</param>
    /// <param name="queries">How many queries the pass makes.</param>
    /// <param name="share">The share of the whole time.</param>
    /// <returns>Times per pair.</returns>
    private Samples Measure(Action pass, long queries, double share)
    {
        int repeats = (int)Math.Max(LeastQueriesPerSample / queries, 1);
        Action sample = repeats == 1 ? pass : () => Repeat(pass, repeats);
        WarmUp.Run(sample, WarmUp.Usual, _cancel);
        Samples samples = Samples.Of(sample, _duration * share, queries * repeats, _cancel);
        _done += share;
        _progress(Math.Min(_done, 1));
        return samples;
    }

    private static void Repeat(Action pass, int times)
    {
        for (int i = 0; i < times; i++) pass();
    }
}
