namespace Gjk.Bench.Scenes;

/// <summary>Pairs of which the second object moves, in a straight line and without turning.</summary>
public sealed class CastScene
{
    private readonly BenchScene _scene = new();
    private readonly List<Vector3> _motions = [];

    /// <param name="isRays">Whether the second objects are points, and each pair is asked as a ray.</param>
    public CastScene(bool isRays) => IsRays = isRays;

    public bool IsRays { get; }

    public ConvexShape[] Shapes => _scene.Shapes;

    public RigidPose[] Poses => _scene.Poses;

    public BenchScene.Pair[] Pairs => _scene.Pairs;

    /// <summary>For every pair how far its second object goes.</summary>
    public Vector3[] Motions { get; private set; } = [];

    public void Add(in ConvexShape a, in RigidPose poseA, in ConvexShape b, in RigidPose poseB, Vector3 motion)
    {
        int first = _scene.Add(a, poseA);
        _scene.AddPair(first, _scene.Add(b, poseB));
        _motions.Add(motion);
    }

    public CastScene Build()
    {
        _scene.Build();
        Motions = [.. _motions];
        return this;
    }

    /// <summary>When the moving pairs first touch; pairs of the set of rays are asked as rays.</summary>
    public float SumOfFractions()
    {
        float sum = 0;
        for (int i = 0; i < Pairs.Length; i++)
        {
            (int a, int b) = (Pairs[i].A, Pairs[i].B);
            sum += IsRays
                ? (float)CastCheck.RayOf(this, i).Status
                : ConvexQuery.Cast(Shapes[a], Poses[a], default, Shapes[b], Poses[b], Motions[i]).Fraction;
        }

        return sum;
    }
}
