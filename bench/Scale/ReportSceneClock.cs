namespace Gjk.Bench.Scale;

/// <summary>Measures the frames of the report's scenes of 20 objects.</summary>
internal sealed class ReportSceneClock
{
    /// <summary>Frames between two readings of the clock. A single frame takes little longer than a reading.</summary>
    private const int FramesPerSample = 50;

    /// <summary>Units per frame. The step is one percent of the size along two axes, forward in one frame and back in
    /// the next.</summary>
    private static readonly Vector3 Step = new(0.01f, 0, 0.01f);

    private readonly CollisionScene _scene = new(BroadPhaseKind.SortAndSweep);
    private readonly RigidPose[][] _frames;
    private readonly List<ObjectPair> _pairs = [];
    private readonly List<PairDistance> _distances = [];
    private readonly bool _isMoving;
    private readonly Question _question;
    private int _frame;

    private ReportSceneClock(BenchScene objects, Question question, bool isMoving)
    {
        for (int i = 0; i < objects.Shapes.Length; i++) _scene.Add(objects.Shapes[i], objects.Poses[i]);
        _frames = [objects.Poses, [.. objects.Poses.Select(p => new RigidPose(p.Rotation, p.Position + Step))]];
        _question = question;
        _isMoving = isMoving;
    }

    public static ScaleRow Measure(string name, Question question, bool isMoving, double seconds)
    {
        BenchScene objects = ReportScenes.Create(name);
        FrameFigures figures = new ReportSceneClock(objects, question, isMoving).Measure(seconds);
        return new ScaleRow(name, question, objects.Shapes.Length, isMoving, BroadPhaseKind.SortAndSweep, 1, figures);
    }

    private FrameFigures Measure(double seconds)
    {
        FrameLoop.WarmUp(Frame);
        var samples = new Samples();
        int rounds = FrameLoop.Repeat(seconds, () =>
        {
            long start = Stopwatch.GetTimestamp();
            for (int i = 0; i < FramesPerSample; i++) Frame();
            samples.Add(FrameLoop.Milliseconds(Stopwatch.GetTimestamp() - start) / FramesPerSample);
        });
        double bytes = FrameLoop.BytesPerFrame(Frame, rounds * FramesPerSample);
        _scene.FindOverlaps(_pairs);
        return new FrameFigures(null, null, samples.Median, null, _pairs.Count, null, bytes, null);
    }

    private void Frame()
    {
        RigidPose[] poses = _frames[_frame++ & 1];
        for (int i = 0; _isMoving && i < poses.Length; i++) _scene.Move(i, poses[i]);
        if (_question == Question.Distances) _scene.FindPairsWithin(float.PositiveInfinity, _distances);
        else _scene.FindOverlaps(_pairs);
    }
}
