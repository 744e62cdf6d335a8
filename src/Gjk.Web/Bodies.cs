namespace Gjk.Web;

/// <summary>The shapes that a page has made, its bodies, and the pairs that it asks about. Their numbers lie in pinned
/// arrays, which the page writes and reads in place.</summary>
internal sealed class Bodies
{
    /// <summary>Numbers of a body: rotation, position, velocity, angular velocity.</summary>
    public const int MotionSize = 13;

    /// <summary>Numbers of an answer; see <see cref="Answers"/>.</summary>
    public const int AnswerSize = 13;

    private readonly List<ConvexShape> _shapes = [];

    /// <summary>The index of each body's shape.</summary>
    public int[] ShapeOf { get; private set; } = [];

    public float[] Motions { get; private set; } = [];

    /// <summary>Two bodies per pair.</summary>
    public int[] Pairs { get; private set; } = [];

    public float[] Answers { get; private set; } = [];

    /// <summary>Makes room. The arrays are new ones after this call, and empty.</summary>
    public void Reserve(int bodies, int pairs)
    {
        ShapeOf = GC.AllocateArray<int>(bodies, pinned: true);
        Motions = GC.AllocateArray<float>(bodies * MotionSize, pinned: true);
        Pairs = GC.AllocateArray<int>(pairs * 2, pinned: true);
        Answers = GC.AllocateArray<float>(pairs * AnswerSize, pinned: true);
    }

    public int Add(in ConvexShape shape)
    {
        _shapes.Add(shape);
        return _shapes.Count - 1;
    }

    public ConvexShape Shape(int shape) => _shapes[shape];

    public ConvexShape ShapeAt(int body) => _shapes[ShapeOf[body]];

    public RigidPose PoseAt(int body)
    {
        float[] m = Motions;
        int i = body * MotionSize;
        return new RigidPose(
            new Quaternion(m[i], m[i + 1], m[i + 2], m[i + 3]), new Vector3(m[i + 4], m[i + 5], m[i + 6]));
    }

    public RigidMotion MotionAt(int body)
    {
        float[] m = Motions;
        int i = body * MotionSize + 7;
        return new RigidMotion(
            PoseAt(body), new Vector3(m[i], m[i + 1], m[i + 2]), new Vector3(m[i + 3], m[i + 4], m[i + 5]));
    }
}
