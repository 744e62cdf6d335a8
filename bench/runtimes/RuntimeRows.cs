using Gjk.Bench.Benchmarks;
using Gjk.Bench.Table;
using Gjk.Exact.Scenes;

namespace Gjk.Bench.Runtimes;

/// <summary>The loops that are compared between runtimes. A name that ends in "report" is the report's algorithm on the
/// same pairs.</summary>
internal static class RuntimeRows
{
    private const int HullCorners = 32;
    private const ulong HullSeed = 71;

    /// <summary>The most gap of a contact point, in cubes' edges.</summary>
    private const float MostGap = 0.02f;

    public static IEnumerable<(string Name, TimedLoop Loop)> All()
    {
        IReadOnlyList<RigidPose> poses = BuiltInScenes.Cubes().Poses;
        BenchScene cubes = ReportScenes.Create(ReportScenes.Cubes), spheres = ReportScenes.Create(ReportScenes.Spheres);
        Vector3[] corners = MeshVertices.OnEllipsoid(new Prng(HullSeed), HullCorners, new Vector3(0.5f));
        BenchScene hulls = ReportScenes.AllAt(poses, ConvexShape.Mesh(corners), corners);
        int pairs = cubes.Pairs.Length;
        var warmStarts = new WarmStart[pairs];
        float[] mostGaps = [.. Enumerable.Repeat(MostGap, pairs)];

        yield return Row("cubes cold report", pairs, () => SceneQueries.BaselineDistance(cubes));
        yield return Row("cubes cold", pairs, () => SceneQueries.Distance(cubes));
        yield return Row("cubes warm", pairs, () => SceneQueries.WarmDistance(cubes, cubes.Poses, warmStarts));
        yield return Row("cubes depth", pairs, () => SceneQueries.Depth(cubes));
        yield return Row("spheres 515 depth", pairs, () => SceneQueries.Depth(spheres));
        yield return Row("hull 32 cold report", pairs, () => SceneQueries.BaselineDistance(hulls));
        yield return Row("hull 32 cold", pairs, () => SceneQueries.Distance(hulls));
#if OPENGJKSHARP
        var cubeCorners = BuiltInScenes.Cubes().Vertices.ToArray();
        yield return OpenGjkSharpRows.Row("cubes cold", cubes, cubeCorners);
        yield return OpenGjkSharpRows.Row("hull 32 cold", hulls, corners);
#endif
        yield return Row("hull 32 depth", pairs, () => SceneQueries.Depth(hulls));
        yield return Cold("capsules cold", poses, ConvexShape.Capsule(0.3f, 0.4f));
        yield return Cold("balls cold", poses, ConvexShape.Sphere(0.5f));
        yield return Cold("cylinders cold", poses, ConvexShape.Cylinder(0.5f, 0.5f));
        yield return Row("contacts of two boxes", pairs, () => SceneQueries.Contacts(cubes, mostGaps));
        TypedPairs<TriangleShape> triangles = new PrimitivePairs().Triangles;
        yield return Row("two triangles report", RandomPairs.Count, triangles.BaselineDistance);
        yield return Row("two triangles", RandomPairs.Count, triangles.Distance);
        yield return Row("frame of 2000 boxes", 1, new MovingBoxes().Frame);

        // The report's experiment: a frame asks for the distance of all pairs of both scenes, of which nothing moves.
        yield return Row("frame of 20 cubes report", 1, () => SceneQueries.BaselineDistance(cubes));
        yield return Row("frame of 20 cubes", 1, () => SceneQueries.Distance(cubes));
        yield return Row("frame of 20 spheres report", 1, () => SceneQueries.BaselineDistance(spheres));
        yield return Row("frame of 20 spheres", 1, () => SceneQueries.Distance(spheres));
    }

    private static (string Name, TimedLoop Loop) Cold(string name, IEnumerable<RigidPose> poses, in ConvexShape shape)
    {
        BenchScene scene = ReportScenes.AllAt(poses, shape, vertices: []);
        return Row(name, scene.Pairs.Length, () => SceneQueries.Distance(scene));
    }

    private static (string Name, TimedLoop Loop) Row(string name, int queries, Func<float> pass) =>
        (name, new TimedLoop(queries, pass));
}
