namespace Gjk.Bench.Runtimes;

/// <summary>Boxes of size 1 that turn and tremble in a crowded room; a frame moves all of them and finds the pairs that
/// overlap.</summary>
internal sealed class MovingBoxes
{
    private const int Count = 2000;
    private const float Room = 17;
    private const ulong Seed = 72;

    private readonly CollisionScene _scene = new();
    private readonly Vector3[] _places = new Vector3[Count];
    private readonly List<ObjectPair> _found = [];
    private int _frame;

    public MovingBoxes()
    {
        var prng = new Prng(Seed);
        var box = ConvexShape.Box(new Vector3(0.5f));
        for (int i = 0; i < Count; i++)
        {
            _places[i] = new Vector3(prng.Range(0, Room), prng.Range(0, Room), prng.Range(0, Room));
            _scene.Add(box, new RigidPose(_places[i]));
        }
    }

    public float Frame()
    {
        _frame++;
        for (int i = 0; i < Count; i++)
        {
            Quaternion turn = Quaternion.CreateFromAxisAngle(Vector3.UnitY, _frame * 0.01f + i);
            _scene.Move(i, new RigidPose(turn, _places[i] + new Vector3(0.01f * ((_frame + i) % 7), 0, 0)));
        }

        _scene.FindOverlaps(_found);
        return _found.Count;
    }
}
