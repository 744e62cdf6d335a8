using Gjk.Bench.Baseline;

namespace Gjk.Bench.Scenes;

/// <summary>Random pairs of one primitive for the generic path, where the compiler knows both types. The baseline knows
/// only meshes. It gets the mesh that a game engine has for the shape.</summary>
public sealed class TypedPairs<TShape>
    where TShape : struct, ISupportMap
{
    private const float MinDistance = 0.2f;
    private const float MaxDistance = 1.6f;

    private readonly TShape[] _shapes = new TShape[2 * RandomPairs.Count];
    private readonly RigidPose[] _poses = new RigidPose[2 * RandomPairs.Count];
    private readonly SupportCollider[] _colliders = new SupportCollider[2 * RandomPairs.Count];

    public TypedPairs(ulong seed, Func<Prng, (TShape Shape, Vector3[] Vertices)> create)
    {
        var prng = new Prng(seed);
        for (int i = 0; i < _shapes.Length; i++)
        {
            (_shapes[i], Vector3[] vertices) = create(prng);
            Vector3 position = i % 2 == 0 ? Vector3.Zero : prng.UnitVector() * prng.Range(MinDistance, MaxDistance);
            _poses[i] = new RigidPose(prng.Rotation(), position);
            _colliders[i] = new MeshSupportCollider(vertices, _poses[i].Rotation, position);
        }
    }

    public float Distance()
    {
        float sum = 0;
        for (int i = 0; i < _shapes.Length; i += 2)
            sum += ConvexQuery.Distance(_shapes[i], _poses[i], _shapes[i + 1], _poses[i + 1]).Distance;
        return sum;
    }

    public float BaselineDistance()
    {
        float sum = 0;
        for (int i = 0; i < _colliders.Length; i += 2)
            sum += ReportGjk.Distance(_colliders[i], _colliders[i + 1]).Distance;
        return sum;
    }
}
