namespace Gjk.Core.Tests.Support;

/// <summary>Objects of many kinds in a box at a density where about half touch another; they drift, turn, now and then
/// jump, come and go.</summary>
internal sealed class MovingWorld
{
    private readonly Rng _rng;
    private readonly string[] _kinds;
    private readonly float _side;

    public MovingWorld(ulong seed, int count, string[] kinds, float side = 0)
    {
        _rng = new Rng(seed);
        _kinds = kinds;
        // About one unit across: found by trial, and asserted by the tests that rely on it.
        _side = side > 0 ? side : 1.7f * MathF.Cbrt(count);
        for (int i = 0; i < count; i++) Add();
    }

    public List<ConvexShape> Shapes { get; } = [];

    public List<RigidPose> Poses { get; } = [];

    public Rng Rng => _rng;

    public int Count => Shapes.Count;

    public int Add()
    {
        Shapes.Add(Generators.Shape(_rng, _kinds[_rng.Below(_kinds.Length)]).Shape);
        Poses.Add(Generators.Pose(_rng, _rng.Vector(0, _side)));
        return Count - 1;
    }

    /// <summary>A step of about a hundredth of a size; one in two hundred jumps anywhere.</summary>
    public void Step(int i)
    {
        RigidPose pose = Poses[i];
        if (_rng.Below(200) == 0)
        {
            Poses[i] = Generators.Pose(_rng, _rng.Vector(0, _side));
            return;
        }

        Quaternion turn = Quaternion.CreateFromAxisAngle(_rng.UnitVector(), 0.02f);
        Poses[i] = new RigidPose(Quaternion.Normalize(turn * pose.Rotation), pose.Position + _rng.Vector(-0.02, 0.02));
    }

    public CollisionScene Scene(BroadPhaseKind kind) => Filled(new CollisionScene(kind));

    public CollisionScene Scene(IBroadPhase phase) => Filled(new CollisionScene(phase));

    private CollisionScene Filled(CollisionScene scene)
    {
        for (int i = 0; i < Count; i++) Assert.Equal(i, scene.Add(Shapes[i], Poses[i]));
        return scene;
    }

    /// <summary>What a scene of these objects must say: every pair asked, cold.</summary>
    public List<ObjectPair> AllOverlaps(Func<int, bool>? isThere = null)
    {
        List<ObjectPair> pairs = [];
        for (int a = 0; a < Count; a++)
        {
            if (isThere is not null && !isThere(a)) continue;
            for (int b = a + 1; b < Count; b++)
                if ((isThere is null || isThere(b)) && ConvexQuery.Overlaps(Shapes[a], Poses[a], Shapes[b], Poses[b]))
                    pairs.Add(new ObjectPair(a, b));
        }

        return pairs;
    }

    /// <summary>How many of the objects are in a pair.</summary>
    public static int Touched(List<ObjectPair> pairs)
    {
        HashSet<int> touched = [];
        foreach (ObjectPair p in pairs)
        {
            touched.Add(p.A);
            touched.Add(p.B);
        }

        return touched.Count;
    }
}
