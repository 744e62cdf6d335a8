using Gjk.Bench.Baseline;

namespace Gjk.Bench.Scenes;

/// <summary>The same objects in two forms, for the library and for the report's algorithm, and the pairs to
/// query.</summary>
public sealed class BenchScene
{
    private readonly List<ConvexShape> _shapes = [];
    private readonly List<RigidPose> _poses = [];
    private readonly List<SupportCollider> _colliders = [];
    private readonly List<Pair> _pairs = [];

    /// <summary>The library's shapes. They are in an array, so that a query takes them by reference and without a
    /// copy.</summary>
    public ConvexShape[] Shapes { get; private set; } = [];

    public RigidPose[] Poses { get; private set; } = [];

    public SupportCollider[] Colliders { get; private set; } = [];

    public Pair[] Pairs { get; private set; } = [];

    /// <summary>Adds an object. The baseline scans all the vertices. The library has built its own shape from
    /// them.</summary>
    public int Add(in ConvexShape shape, Vector3[] vertices, in RigidPose pose)
    {
        _colliders.Add(new MeshSupportCollider(vertices, pose.Rotation, pose.Position));
        return Add(shape, pose);
    }

    /// <summary>Adds an object to a scene that only the library is asked about.</summary>
    public int Add(in ConvexShape shape, in RigidPose pose)
    {
        _shapes.Add(shape);
        _poses.Add(pose);
        return _shapes.Count - 1;
    }

    public void AddPair(int a, int b) => _pairs.Add(new Pair(a, b));

    public BenchScene WithAllPairs()
    {
        for (int a = 0; a < _shapes.Count; a++)
            for (int b = a + 1; b < _shapes.Count; b++)
                AddPair(a, b);
        return Build();
    }

    public BenchScene Build()
    {
        Shapes = [.. _shapes];
        Poses = [.. _poses];
        Colliders = [.. _colliders];
        Pairs = [.. _pairs];
        return this;
    }

    /// <summary>A scene with the same objects and the first pairs of the list.</summary>
    public BenchScene WithFirstPairs(int count) =>
        new() { Shapes = Shapes, Poses = Poses, Colliders = Colliders, Pairs = [.. Pairs.Take(count)] };

    public readonly struct Pair
    {
        public readonly int A;
        public readonly int B;

        public Pair(int a, int b) => (A, B) = (a, b);
    }
}
