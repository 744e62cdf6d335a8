namespace Gjk.Core;

/// <summary>Moves many objects of a scene at once, on several threads.</summary>
internal sealed class SceneMoves(SceneObjects objects)
{
    /// <summary>In place of a slot: nothing moves.</summary>
    public const int None = -1;

    /// <summary>Count of objects that one thread moves in turn. A matter of speed only.</summary>
    private const int ShareLength = 512;

    /// <summary>By slot: the last move of the object. Out of date unless that move names the slot.</summary>
    private int[] _lastMoves = [];

    private int _refused;

    /// <summary>By move: the slot of its object, or <see cref="None"/>.</summary>
    public int[] Slots { get; private set; } = [];

    /// <summary>By move: the new box.</summary>
    public Aabb[] Boxes { get; private set; } = [];

    /// <summary>Finds the slots and boxes, and changes nothing in the scene yet.</summary>
    /// <returns>The first move that is refused; negative for none.</returns>
    public int Prepare(int[] ids, RigidPose[] poses, Workers? workers)
    {
        Reserve(ids.Length);
        _refused = int.MaxValue;
        Workers.Run(workers, new PrepareJob(this, objects, ids, poses), ids.Length, ShareLength, default);
        return _refused < int.MaxValue ? _refused : -1;
    }

    /// <summary>Gives the objects their poses. The broad phase takes the boxes.</summary>
    public void Apply(RigidPose[] poses, long calls, Workers? workers)
    {
        DropRepeated(poses.Length);
        Workers.Run(workers, new ApplyJob(objects, Slots, poses, calls), poses.Length, ShareLength);
    }

    private void Reserve(int count)
    {
        if (_lastMoves.Length < objects.Ids.Length) _lastMoves = new int[objects.Ids.Length];
        if (Slots.Length >= count) return;
        int capacity = BoundsTable.Grown(Slots.Length, count);
        (Boxes, Slots) = (new Aabb[capacity], new int[capacity]);
    }

    /// <summary>Keeps the last move of each object. An entry that another call left does no harm: its move is another
    /// object's, or comes later.</summary>
    private void DropRepeated(int count)
    {
        for (int i = 0; i < count; i++)
        {
            int slot = Slots[i], before = _lastMoves[slot];
            if (before < i && Slots[before] == slot) Slots[before] = None;
            _lastMoves[slot] = i;
        }
    }

    private void Refuse(int move)
    {
        lock (this) _refused = Math.Min(_refused, move);
    }

    private readonly struct PrepareJob(SceneMoves moves, SceneObjects objects, int[] ids, RigidPose[] poses) : IShareJob
    {
        public void Run(int begin, int end)
        {
            for (int i = begin; i < end; i++)
            {
                int slot = objects.SlotOf(ids[i]);
                ref readonly RigidPose pose = ref poses[i];
                if (slot < 0 || !pose.IsValid)
                {
                    moves.Refuse(i);
                    return;
                }

                moves.Slots[i] = slot;
                if (objects.Poses[slot] != pose) moves.Boxes[i] = objects.Bounds[slot].BoxAt(pose);
            }
        }
    }

    private readonly struct ApplyJob(SceneObjects objects, int[] slots, RigidPose[] poses, long calls) : IShareJob
    {
        public void Run(int begin, int end)
        {
            for (int i = begin; i < end; i++)
            {
                int slot = slots[i];
                if (slot == None) continue;
                if (objects.Poses[slot] == poses[i])
                {
                    slots[i] = None;
                    continue;
                }

                objects.Poses[slot] = poses[i];
                objects.MovedAfter[slot] = calls;
            }
        }
    }
}
