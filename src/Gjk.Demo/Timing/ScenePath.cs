using Gjk.Demo.View;

namespace Gjk.Demo.Timing;

/// <summary>The poses of all objects in every frame of a small, smooth motion. Each object moves from one side of its
/// place to the other and back, by 1 % of its own size and 1 degree per frame. The poses are computed before anything
/// is timed.</summary>
internal sealed class ScenePath
{
    /// <summary>How far an object moves per frame, as a share of its size.</summary>
    private const double StepShare = 0.01;

    /// <summary>How far an object turns per frame, in radians.</summary>
    private const double StepAngle = Math.PI / 180;

    /// <summary>Frames to either side of the given place. Their number is small, so that most overlaps and gaps of the
    /// scene stay as they were.</summary>
    private const int MostStepsAside = 16;

    /// <summary>Queries in a round, about. Long lists get fewer frames, so that a round does not take longer than
    /// this.</summary>
    private const int QueriesPerRound = 4_000_000;

    private readonly RigidPose[][] _frames;

    public ScenePath(Scene scene)
    {
        int aside = (int)Math.Clamp(QueriesPerRound / 4 / Math.Max(scene.Pairs.Count, 1), 1, MostStepsAside);
        var steps = new Double3[scene.Objects.Length];
        var axes = new Double3[scene.Objects.Length];
        var random = new DirectionSequence();
        for (int i = 0; i < steps.Length; i++)
        {
            steps[i] = random.Next() * (StepShare * Size(scene.Objects[i].Any));
            axes[i] = random.Next();
        }

        _frames = new RigidPose[2 * aside + 1][];
        for (int frame = 0; frame < _frames.Length; frame++)
        {
            int step = frame - aside;
            double sin = Math.Sin(StepAngle * step / 2), cos = Math.Cos(StepAngle * step / 2);
            _frames[frame] = new RigidPose[steps.Length];
            for (int i = 0; i < steps.Length; i++)
            {
                _frames[frame][i] = PoseMotion.Moved(
                    scene.Objects[i].Pose, steps[i] * step, axes[i] * sin, cos);
            }
        }
    }

    /// <summary>Frames in a round: from one end to the other, and back to the frame after the first.</summary>
    public int FramesPerRound => 2 * (_frames.Length - 1);

    /// <summary>The poses, frame by frame. The next round begins where this one ends.</summary>
    public IEnumerable<RigidPose[]> Round()
    {
        for (int frame = 0; frame < _frames.Length; frame++) yield return _frames[frame];
        for (int frame = _frames.Length - 2; frame > 0; frame--) yield return _frames[frame];
    }

    /// <summary>The longest side of the shape's bounding box in its own frame.</summary>
    private static double Size(in AnyShape shape)
    {
        var size = default(Double3);
        foreach (Double3 axis in (ReadOnlySpan<Double3>)[new(1, 0, 0), new(0, 1, 0), new(0, 0, 1)])
        {
            Double3 width = SupportSamples.Support(shape, axis) - SupportSamples.Support(shape, -axis);
            size += axis * Double3.Dot(axis, width);
        }

        return Math.Max(Math.Max(size.X, size.Y), size.Z);
    }
}
