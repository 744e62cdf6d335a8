namespace Gjk.Exact.Scenes;

/// <summary>Objects in motion. Each object moves straight on until a wall reflects it, and turns at a constant rate
/// about an axis of its own. No trigonometry is used, so the bits are the same in every run and on every
/// machine.</summary>
public sealed class MovingObjects
{
    private const ulong Seed = 0x4D_6F_74_69_6F_6E;

    private readonly IReadOnlyList<RigidPose> _first;
    private readonly Aabb _room;
    private readonly Vector3[] _firstSteps;
    private readonly Vector3[] _steps;

    /// <summary>The axis times the tangent of half the angle, per frame.</summary>
    private readonly Double3[] _turns;

    /// <param name="scene">Objects of unit size.</param>
    /// <param name="speed">Object sizes per frame. The turn is about twice as many radians. It moves a point half a
    /// size from the centre as far as the speed does.</param>
    public MovingObjects(BuiltInScene scene, double speed)
        : this(scene.Poses, scene.Room, speed)
    {
    }

    /// <param name="poses">Where the objects are in the first frame.</param>
    /// <param name="room">The box that their positions do not leave.</param>
    /// <param name="speed">Length per frame. The turn is about twice as many radians.</param>
    public MovingObjects(IReadOnlyList<RigidPose> poses, in Aabb room, double speed)
    {
        _first = poses;
        _room = room;
        IsMoving = speed > 0;
        Poses = [.. poses];
        _firstSteps = new Vector3[Poses.Length];
        _turns = new Double3[Poses.Length];
        var random = new Rng(Seed);
        for (int i = 0; i < Poses.Length; i++)
        {
            _firstSteps[i] = (Vector3)(random.Direction() * speed);
            _turns[i] = random.Direction() * speed;
        }

        _steps = [.. _firstSteps];
    }

    /// <summary>True if the speed is more than 0.</summary>
    public bool IsMoving { get; }

    /// <summary>The poses in this frame. In the first frame they are as given.</summary>
    public RigidPose[] Poses { get; }

    /// <summary>Moves the objects on by one frame.</summary>
    public void Advance()
    {
        if (!IsMoving) return;
        Aabb room = _room;
        for (int i = 0; i < Poses.Length; i++)
        {
            RigidPose moved = PoseMotion.Moved(Poses[i], (Double3)_steps[i], _turns[i], 1);
            Vector3 position = moved.Position;
            ref Vector3 step = ref _steps[i];
            Reflect(ref position.X, ref step.X, room.Min.X, room.Max.X);
            Reflect(ref position.Y, ref step.Y, room.Min.Y, room.Max.Y);
            Reflect(ref position.Z, ref step.Z, room.Min.Z, room.Max.Z);
            Poses[i] = new RigidPose(moved.Rotation, position);
        }
    }

    /// <summary>Goes back to the first frame.</summary>
    public void Rewind()
    {
        for (int i = 0; i < Poses.Length; i++) Poses[i] = _first[i];
        _firstSteps.CopyTo(_steps, 0);
    }

    /// <summary>Mirrors a coordinate at the wall that it passed. A step longer than the room ends at the other
    /// wall.</summary>
    private static void Reflect(ref float x, ref float step, float min, float max)
    {
        if (x >= min && x <= max) return;
        x = Math.Min(Math.Max(x < min ? min + (min - x) : max - (x - max), min), max);
        step = -step;
    }
}
