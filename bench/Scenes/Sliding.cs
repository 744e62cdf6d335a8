namespace Gjk.Bench.Scenes;

/// <summary>Poses of overlapping pairs over a few frames, forward and backward without end. In each frame the second
/// object of every pair slides across the shortest way out, by one percent of the smaller object's size. Pairs that
/// would part are pushed in again, so that every frame asks for a depth.</summary>
public sealed class Sliding
{
    /// <summary>Frames to either side of the given place. They are few, so that the contacts stay of their
    /// kind.</summary>
    private const int StepsAside = 2;

    private const int FramesPerRound = 4 * StepsAside;
    private const double SizesPerFrame = 0.01;
    private const ulong Seed = 42;

    /// <summary>A push aims half as deep as the one before, because needles become thinner where they slide.</summary>
    private const int MostPushes = 16;

    private readonly RigidPose[][] _frames = new RigidPose[FramesPerRound][];
    private int _frame;

    /// <exception cref="FactorCheckException">A pair does not overlap in one of the frames.</exception>
    public Sliding(BenchScene scene)
    {
        for (int i = 0; i < _frames.Length; i++) _frames[i] = [.. scene.Poses];
        var prng = new Prng(Seed);
        var path = new RigidPose[2 * StepsAside + 1];
        for (int i = 0; i < scene.Pairs.Length; i++)
        {
            BenchScene.Pair pair = scene.Pairs[i];
            Walk(scene, pair, prng, path);
            // Neighbours in the list are in different phases, so that all frames do equally much work.
            for (int frame = 0; frame < _frames.Length; frame++)
                _frames[frame][pair.B] = path[StepOf((frame + i) % FramesPerRound)];
        }
    }

    /// <summary>The poses of the next frame.</summary>
    public RigidPose[] Next() => _frames[_frame = (_frame + 1) % _frames.Length];

    /// <summary>From one end of the path to the other, and back.</summary>
    private static int StepOf(int phase) => phase <= 2 * StepsAside ? phase : FramesPerRound - phase;

    private static void Walk(BenchScene scene, BenchScene.Pair pair, Prng prng, RigidPose[] path)
    {
        ref ConvexShape a = ref scene.Shapes[pair.A], b = ref scene.Shapes[pair.B];
        RigidPose poseA = scene.Poses[pair.A], middle = scene.Poses[pair.B];
        DistanceResult start = ConvexQuery.SignedDistance(a, poseA, b, middle);
        Double3 wayOut = start.Normal, across = Double3.Cross(wayOut, prng.UnitVector());
        double step = SizesPerFrame * Math.Min(Motion.Size(a), Motion.Size(b));
        for (int i = 0; i < path.Length; i++)
        {
            Double3 place = middle.Position + across * ((i - StepsAside) * step / across.Length);
            path[i] = PushedIn(a, poseA, b, middle.Rotation, place, -start.Distance);
        }
    }

    private static RigidPose PushedIn(
        in ConvexShape a, in RigidPose poseA, in ConvexShape b, Quaternion rotation, Double3 place, double depth)
    {
        for (int push = 0; push < MostPushes; push++)
        {
            var pose = new RigidPose(rotation, (Vector3)place);
            DistanceResult result = ConvexQuery.SignedDistance(a, poseA, b, pose);
            if (DepthCheck.IsDepth(result)) return pose;
            place -= (Double3)result.Normal * (result.Distance + depth);
            depth *= 0.5;
        }

        throw new FactorCheckException($"A pair that slides left the overlap: {a} and {b} at {place}");
    }
}
