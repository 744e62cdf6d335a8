namespace Gjk.Demo.Trace;

/// <summary>Pairs with parallel faces on which the textbook's GJK fails. Each is the first of its kind in a search over
/// plain offsets, which a test does again.</summary>
internal static class TextbookExamples
{
    /// <summary>The gap between the parallel faces, and the steps of the search.</summary>
    public const float Gap = 0.25f, Step = 0.1f;

    /// <summary>Offsets along x and along z go up to this many steps.</summary>
    public const int Steps = 10;

    /// <summary>Two boxes, the upper one shifted to the side: the loop never ends.</summary>
    public static Scene Loop => Pair("loop", Boxes(2, 3));

    /// <summary>Two triangles in parallel planes, a quarter apart: the answer is that they intersect.</summary>
    public static Scene Wrong => Pair("wrong", Triangles(6, 9));

    /// <summary>The example of a name, or null.</summary>
    public static Scene? Named(string name) => name switch
    {
        "loop" => Loop,
        "wrong" => Wrong,
        _ => null,
    };

    /// <summary>Two equal boxes, one above the other, shifted by steps along x and z.</summary>
    public static (SceneObject A, SceneObject B) Boxes(int x, int z)
    {
        ConvexShape box = ConvexShape.Box(new Vector3(1, 0.5f, 1));
        return Objects(box, new Vector3(x * Step, 1 + Gap, z * Step), Quaternion.Identity);
    }

    /// <summary>Two equal triangles in parallel planes, one half a turn round from the other.</summary>
    public static (SceneObject A, SceneObject B) Triangles(int x, int z)
    {
        ConvexShape triangle = ConvexShape.Triangle(
            new Vector3(-1, 0, -1), new Vector3(1, 0, -1), new Vector3(0, 0, 1));
        return Objects(triangle, new Vector3(x * Step, Gap, z * Step), new Quaternion(0, 1, 0, 0));
    }

    private static (SceneObject A, SceneObject B) Objects(ConvexShape shape, Vector3 position, Quaternion turn) => (
        new SceneObject("lower", shape, RigidPose.Identity, default, default),
        new SceneObject("upper", shape, new RigidPose(turn, position), default, default));

    private static Scene Pair(string name, (SceneObject A, SceneObject B) pair) =>
        new(name, [pair.A, pair.B], ScenePairs.All(2), 1);
}
