namespace Gjk.Bench.Scenes;

/// <summary>Poses of a scene over a few frames. They run forward and backward, so that they never end. In each frame
/// every object turns by one degree about an axis of its own and moves by one percent of its size, from one side of its
/// place to the other. The demo's <c>time</c> moves objects in the same way.</summary>
public sealed class Motion
{
    /// <summary>Frames to either side of the given place. Their number is small, so that most overlaps and gaps of the
    /// scene stay as they were.</summary>
    private const int StepsAside = 16;

    private const float RadiansPerFrame = MathF.PI / 180;
    private const double SizesPerFrame = 0.01;
    private const ulong Seed = 41;

    private readonly RigidPose[][] _frames = new RigidPose[2 * StepsAside + 1][];
    private int _frame;
    private int _step = 1;

    public Motion(BenchScene scene)
    {
        for (int i = 0; i < _frames.Length; i++) _frames[i] = new RigidPose[scene.Poses.Length];
        var prng = new Prng(Seed);
        for (int i = 0; i < scene.Poses.Length; i++)
        {
            RigidPose middle = scene.Poses[i];
            Vector3 axis = prng.UnitVector();
            Vector3 course = prng.UnitVector() * (float)(SizesPerFrame * Size(scene.Shapes[i]));
            for (int frame = 0; frame < _frames.Length; frame++)
            {
                int step = frame - StepsAside;
                Quaternion turn = Quaternion.CreateFromAxisAngle(axis, step * RadiansPerFrame);
                Quaternion rotation = Quaternion.Normalize(turn * middle.Rotation);
                _frames[frame][i] = new RigidPose(rotation, middle.Position + step * course);
            }
        }
    }

    /// <summary>Frames from one end to the other and back.</summary>
    public static int FramesPerRound => 4 * StepsAside;

    /// <summary>The poses of the next frame.</summary>
    public RigidPose[] Next()
    {
        if (_frame + _step < 0 || _frame + _step >= _frames.Length) _step = -_step;
        _frame += _step;
        return _frames[_frame];
    }

    /// <summary>The longest side of the shape's bounding box in its own frame.</summary>
    internal static double Size(in ConvexShape shape) =>
        Math.Max(Math.Max(Extent(shape, new(1, 0, 0)), Extent(shape, new(0, 1, 0))), Extent(shape, new(0, 0, 1)));

    private static double Extent(in ConvexShape shape, in Double3 axis)
    {
        shape.Support(axis, out Double3 furthest);
        shape.Support(-axis, out Double3 nearest);
        return Double3.Dot(axis, furthest - nearest) + 2 * shape.Margin;
    }
}
