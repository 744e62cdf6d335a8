using Gjk.Exact.Scenes;

namespace Gjk.Bench.Scenes;

/// <summary>The report's two scenes, as the demo replays them, with a baseline collider for every object.</summary>
public static class ReportScenes
{
    public const string Cubes = "cubes";
    public const string Spheres = "spheres";

    public static IReadOnlyList<string> Names { get; } = [Cubes, Spheres];

    public static BenchScene Create(string name)
    {
        BuiltInScene builtIn = name switch
        {
            Cubes => BuiltInScenes.Cubes(),
            Spheres => BuiltInScenes.Spheres(),
            _ => throw new ArgumentOutOfRangeException(nameof(name), name, "No such scene."),
        };
        Vector3[] vertices = [.. builtIn.Vertices];
        return AllAt(builtIn.Poses, ConvexShape.Mesh(vertices), vertices);
    }

    /// <summary>Copies of one shape in the given poses, and all pairs of them.</summary>
    /// <param name="poses">Where the copies are.</param>
    /// <param name="shape">The library's shape.</param>
    /// <param name="vertices">The mesh of the shape, for the baseline.</param>
    public static BenchScene AllAt(IEnumerable<RigidPose> poses, in ConvexShape shape, Vector3[] vertices)
    {
        var scene = new BenchScene();
        foreach (RigidPose pose in poses) scene.Add(shape, vertices, pose);
        return scene.WithAllPairs();
    }
}
