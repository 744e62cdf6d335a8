namespace Gjk.Core.Tests.BroadPhase;

/// <summary>Boxes as they are worst for one broad phase or another, and how they move.</summary>
internal sealed class WorstBoxes
{
    /// <summary>None of them has more true pairs than a few per object.</summary>
    public static readonly string[] Sparse =
    [
        "rods", "sliding rods", "flying rods", "rods in three directions", "plates", "plates and rods", "line",
        "points",
        "cubes", "one far off", "one huge", "sizes from 1e-9 to 1e9", "powers of two", "boxes with gaps",
    ];

    /// <summary>Every two are a pair.</summary>
    public static readonly string[] Dense = ["one place", "identical", "nested"];

    /// <summary>A tree that grows by one of them at a time grows deep, as surfaces say nothing.</summary>
    public static readonly string[] Deep =
    [
        .. Dense, "line", "line, backward", "line, anywhere", "nested, inward", "nested powers of two",
        "infinite surfaces", "flat",
    ];

    private readonly Rng _rng;
    private readonly Vector3[] _centers;
    private readonly Vector3[] _halves;
    private readonly Vector3[] _steps;
    private readonly int _side;

    /// <param name="kind">One of the names.</param>
    /// <param name="count">How many boxes.</param>
    /// <param name="seed">Of the places.</param>
    public WorstBoxes(string kind, int count, ulong seed = 1)
    {
        _rng = new Rng(seed);
        _centers = new Vector3[count];
        _halves = new Vector3[count];
        _steps = new Vector3[count];
        _side = (int)Math.Ceiling(Math.Sqrt(count));
        for (int i = 0; i < count; i++) (_centers[i], _halves[i], _steps[i]) = Make(kind, i, count);
    }

    public int Count => _centers.Length;

    public Aabb Box(int i) => new(_centers[i] - _halves[i], _centers[i] + _halves[i]);

    /// <summary>The pairs that are near each other, one by one.</summary>
    public IEnumerable<ObjectPair> Pairs(float margin)
    {
        for (int i = 0; i < Count; i++)
            for (int j = i + 1; j < Count; j++)
                if (BoundsTable.Near(Box(i), Box(j), margin)) yield return new ObjectPair(i, j);
    }

    /// <summary>Moves all boxes one step; to and fro, so that they stay what they are.</summary>
    public void Step(int frame)
    {
        for (int i = 0; i < Count; i++) _centers[i] += (frame / 16 & 1) == 0 ? _steps[i] : -_steps[i];
    }

    public void AddTo(IBroadPhase phase)
    {
        for (int i = 0; i < Count; i++) phase.Add(i, Box(i));
    }

    public void MoveIn(IBroadPhase phase)
    {
        for (int i = 0; i < Count; i++) phase.Move(i, Box(i));
    }

    private (Vector3 Center, Vector3 Half, Vector3 Step) Make(string kind, int i, int count)
    {
        // On a grid of the whole count, a unit apart.
        var onGrid = new Vector3(0, i % _side, i / _side);
        float room = 1.7f * MathF.Cbrt(count);
        Vector3 anywhere = _rng.Vector(0, room), step = _rng.Vector(-0.01, 0.01);
        var rod = new Vector3(500, 0.25f, 0.25f);
        return kind switch
        {
            "rods" => (onGrid, rod, new Vector3(0, step.Y, step.Z)),
            "sliding rods" => (onGrid, rod, new Vector3(1000 * step.X, 0, 0)),
            "flying rods" => (onGrid, rod, new Vector3(0, 0, i / _side * 0.5f)),
            "rods in three directions" => ThreeWays(i, count, step),
            "plates" => (new Vector3(0, 0, i), new Vector3(500, 500, 0.25f), step * new Vector3(100, 100, 1)),
            "plates and rods" => PlatesBesideRods(i, count, step),
            "line" => (new Vector3(i, 0, 0), Vector3.Zero, new Vector3(10 * step.X, 0, 0)),
            "points" => (anywhere, Vector3.Zero, step),
            "cubes" => (anywhere, new Vector3(0.5f), step),
            "one far off" => (i == 0 ? new Vector3(1e30f) : anywhere, new Vector3(0.5f), step),
            "one huge" => (anywhere, i == 0 ? new Vector3(2 * room) : new Vector3(0.2f), step),
            "sizes from 1e-9 to 1e9" => OfAnySize(_rng.Range(-9, 9)),
            "powers of two" => OnPowers(i % 200 - 100),
            "boxes with gaps" => Gaps(i, count, step),
            "one place" => (Vector3.One, Vector3.Zero, Vector3.Zero),
            "identical" => (Vector3.One, Vector3.One, Vector3.Zero),
            "nested" => (Vector3.Zero, new Vector3(i + 1), Vector3.Zero),
            "line, backward" => (new Vector3(0, -i, 0), Vector3.Zero, Vector3.Zero),
            "line, anywhere" => (new Vector3(0, 0, _rng.Float(0, 1)), Vector3.Zero, Vector3.Zero),
            "nested, inward" => (Vector3.Zero, new Vector3(count - i), Vector3.Zero),
            "nested powers of two" => (Vector3.Zero, new Vector3((float)Math.Pow(2, i % 250 - 125)), Vector3.Zero),
            "infinite surfaces" => (Vector3.Zero, new Vector3(_rng.Float(0.5, 1) * float.MaxValue), Vector3.Zero),
            "flat" => (new Vector3(i + 0.5f, 0.5f, 0), new Vector3(0.5f, 0.5f, 0), Vector3.Zero),
            _ => throw new ArgumentException("No such kind.", nameof(kind)),
        };
    }

    /// <summary>A lattice of rods along x, y and z, each through the whole of it, that do not touch.</summary>
    private static (Vector3 Center, Vector3 Half, Vector3 Step) ThreeWays(int i, int count, Vector3 step)
    {
        int side = (int)Math.Ceiling(Math.Sqrt(count / 3.0)), a = i / 3 % side, b = i / 3 / side;
        float half = 0.5f * side;
        return (i % 3) switch
        {
            0 => (new Vector3(half, a, b), new Vector3(half, 0.1f, 0.1f), new Vector3(step.X, 0, 0)),
            1 => (new Vector3(a + 0.33f, half, b + 0.33f), new Vector3(0.1f, half, 0.1f), new Vector3(0, step.Y, 0)),
            _ => (new Vector3(a + 0.66f, b + 0.66f, half), new Vector3(0.1f, 0.1f, half), new Vector3(0, 0, step.Z)),
        };
    }

    /// <summary>A stack of plates, and beside it rods as long as the stack is high: each near each plate, none
    /// touching.</summary>
    private static (Vector3 Center, Vector3 Half, Vector3 Step) PlatesBesideRods(int i, int count, Vector3 step)
    {
        int half = count / 2;
        float height = 0.01f * half;
        if (i < half)
            return (new Vector3(0, 0, 0.02f * i), new Vector3(50, 50, 0.005f), new Vector3(0.01f * step.X, 0, 0));
        var rod = new Vector3(52, -50 + 100f * (i - half) / half, height);
        return (rod, new Vector3(0.001f, 20f / half, height), new Vector3(0, 0, 0.1f * step.Z));
    }

    private (Vector3 Center, Vector3 Half, Vector3 Step) OfAnySize(double exponent)
    {
        float size = (float)Math.Pow(10, exponent);
        return (_rng.Vector(-100, 100) * size, new Vector3(size), _rng.Vector(-0.01, 0.01) * size);
    }

    /// <summary>Rings of boxes around the origin, each ring twice as large and twice as far as the one
    /// before.</summary>
    private (Vector3 Center, Vector3 Half, Vector3 Step) OnPowers(int exponent)
    {
        float size = (float)Math.Pow(2, exponent);
        return (_rng.UnitVector() * size * 100, new Vector3(size), _rng.Vector(-0.01, 0.01) * size);
    }

    /// <summary>A cube of boxes that are apart by less than their leaves reach, so that each has 26
    /// neighbours.</summary>
    private static (Vector3 Center, Vector3 Half, Vector3 Step) Gaps(int i, int count, Vector3 step)
    {
        int side = (int)Math.Ceiling(Math.Cbrt(count));
        return (new Vector3(i % side, i / side % side, i / side / side), new Vector3(0.47f), step);
    }
}
