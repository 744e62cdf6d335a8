using Gjk.Core;

namespace Gjk.Bench.Scenes;

/// <summary>Arrangements of boxes that are the worst case for some broad phase, and their motion.</summary>
internal sealed class WorstBoxes
{
    /// <summary>Arrangements in which few boxes overlap.</summary>
    public static readonly string[] Sparse =
        ["cubes", "rods", "plates", "line", "points", "one far off", "sizes 1e-9 to 1e9"];

    /// <summary>Arrangements in which every two boxes overlap.</summary>
    public static readonly string[] Dense = ["identical", "nested"];

    /// <summary>Frames in one direction. As many frames lead back.</summary>
    private const int FramesThere = 64;

    private readonly Vector3[] _centers;
    private readonly Vector3[] _halves;
    private readonly Vector3[] _steps;
    private int _frame;

    public WorstBoxes(string kind, int count)
    {
        _centers = new Vector3[count];
        _halves = new Vector3[count];
        _steps = new Vector3[count];
        var rng = new Prng(1);
        for (int i = 0; i < count; i++) (_centers[i], _halves[i], _steps[i]) = Make(kind, i, count, rng);
    }

    /// <summary>Adds or moves all boxes.</summary>
    public void Place(IBroadPhase phase)
    {
        for (int i = 0; i < _centers.Length; i++)
        {
            var box = new Aabb(_centers[i] - _halves[i], _centers[i] + _halves[i]);
            if (phase.Count <= i) phase.Add(i, box);
            else phase.Move(i, box);
        }
    }

    /// <summary>Moves the boxes on by one frame.</summary>
    public void Advance()
    {
        bool isBack = (_frame++ / FramesThere & 1) != 0;
        for (int i = 0; i < _centers.Length; i++) _centers[i] += isBack ? -_steps[i] : _steps[i];
    }

    private static (Vector3 Center, Vector3 Half, Vector3 Step) Make(string kind, int i, int count, Prng rng)
    {
        int side = (int)Math.Ceiling(Math.Sqrt(count));
        float room = 1.7f * (float)Math.Cbrt(count);
        Vector3 Within(float low, float high) => new(rng.Range(low, high), rng.Range(low, high), rng.Range(low, high));
        Vector3 step = Within(-0.01f, 0.01f);
        switch (kind)
        {
            case "rods":
                return (new Vector3(0, i % side, i / side), new Vector3(500, 0.25f, 0.25f), step);
            case "plates":
                return (new Vector3(0, 0, i), new Vector3(500, 500, 0.25f), step);
            case "line":
                return (new Vector3(i, 0, 0), Vector3.Zero, new Vector3(step.X, 0, 0));
            case "points":
                return (Within(0, room), Vector3.Zero, step);
            case "one far off":
                return (i == 0 ? new Vector3(1e30f) : Within(0, room), new Vector3(0.5f), step);
            case "sizes 1e-9 to 1e9":
                float size = (float)Math.Pow(10, rng.Range(-9, 9));
                return (Within(-100, 100) * size, new Vector3(size), step * size);
            case "identical":
                return (Vector3.One, Vector3.One, Vector3.Zero);
            case "nested":
                return (Vector3.Zero, new Vector3(i + 1), Vector3.Zero);
            default:
                return (Within(0, room), new Vector3(0.5f), step);
        }
    }
}
