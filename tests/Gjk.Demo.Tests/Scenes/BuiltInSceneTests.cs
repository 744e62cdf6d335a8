namespace Gjk.Demo.Tests.Scenes;

/// <summary>The generator of the report's scenes. It is compiled into this assembly, as it is in the bench.</summary>
public sealed class BuiltInSceneTests
{
    [Fact]
    public void TheCubeHasEachCornerThreeTimes()
    {
        BuiltInScene scene = BuiltInScenes.Cubes();
        Assert.Equal(24, scene.Vertices.Count);
        Assert.Equal(8, scene.Vertices.Distinct().Count());
        Assert.All(scene.Vertices.GroupBy(v => v), corner => Assert.Equal(3, corner.Count()));
        Assert.All(scene.Vertices, v => Assert.Equal(new Vector3(0.5f), Vector3.Abs(v)));
        Assert.Equal(8, new ConvexHull(scene.Vertices).VertexCount);
    }

    [Fact]
    public void TheSphereHas515DistinctCorners()
    {
        BuiltInScene scene = BuiltInScenes.Spheres();
        Assert.Equal(515, scene.Vertices.Count);
        Assert.Equal(515, scene.Vertices.Distinct().Count());
        Assert.All(scene.Vertices, v => Assert.InRange(v.Length(), 0.499999f, 0.500001f));
        Assert.Equal(515, new ConvexHull(scene.Vertices).VertexCount);
    }

    /// <summary>As many vertices, corners and triangles as the sphere that Unity brings along.</summary>
    [Fact]
    public void UnitysSphereHas386DistinctCorners()
    {
        BuiltInScene scene = BuiltInScenes.Spheres(SphereMesh.Unity);
        Assert.Equal(515, scene.Vertices.Count);
        Assert.Equal(386, scene.Vertices.Distinct().Count());
        Assert.All(scene.Vertices, v => Assert.InRange(v.Length(), 0.499999f, 0.500001f));
        var hull = new ConvexHull(scene.Vertices);
        Assert.Equal((386, 768), (hull.VertexCount, hull.TriangleCount));
        Assert.Equal(BuiltInScenes.Spheres().Poses, scene.Poses);
    }

    [Theory]
    [InlineData("query --builtin spheres")]
    [InlineData("cast --builtin spheres")]
    public void TheMeshOfTheSpheresCanBeChosen(string call)
    {
        DemoRun even = DemoRun.Of(call.Split(' '));
        DemoRun unity = DemoRun.Of([.. call.Split(' '), "--mesh", "unity"]);
        even.AssertDone();
        unity.AssertDone();
        Assert.Equal(191, unity.Out.TrimEnd('\n').Split('\n').Length);
        Assert.NotEqual(even.Out, unity.Out);
        Assert.Equal(even.Out, DemoRun.Of([.. call.Split(' '), "--mesh", "even"]).Out);
    }

    [Fact]
    public void EveryCommandTakesTheBuiltInScenesAndTheMesh()
    {
        using var directory = new TempDirectory();
        DemoRun time = DemoRun.Of("time", "--builtin", "spheres", "--mesh", "unity", "--seconds", "0.1");
        time.AssertDone();
        Assert.StartsWith("{\"scene\":\"spheres\",\"pairs\":190,\"overlapping\":5,", time.Out);
        DemoRun replay = DemoRun.Of("--mesh", "unity", "--frames", "1");
        replay.AssertDone();
        Assert.Contains("515 (386)", replay.Out);
        DemoRun world = DemoRun.Of("--mesh", "unity", "--frames", "1", "--objects", "50");
        world.AssertDone();
        Assert.Contains("515 (386)", world.Out);
        string page = directory.File("p.html");
        DemoRun.Of("view", "--builtin", "spheres", "--mesh", "unity", "--out", page).AssertDone();
        DemoRun.Of("trace", "--builtin", "spheres", "--mesh", "unity", "--pair", "Sphere (1),19", "--out", page)
            .AssertDone();
    }

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void TheGridsStandAsTheReportDescribes(bool cubes)
    {
        BuiltInScene scene = cubes ? BuiltInScenes.Cubes() : BuiltInScenes.Spheres();
        Assert.Equal(20, scene.Poses.Count);
        Assert.Equal(20, scene.ObjectNames.Distinct().Count());
        Assert.Equal(20, scene.Poses.Select(p => p.Rotation).Distinct().Count());
        Assert.Equal(10, scene.Poses.Count(p => p.Position.Y == 0));
        Assert.Equal(10, scene.Poses.Count(p => p.Position.Y == 2.25f));

        float reach = scene.Vertices.Max(v => v.Length());
        int close = 0;
        for (int i = 0; i < 20; i++)
        {
            for (int j = i + 1; j < 20; j++)
            {
                float apart = Vector3.Distance(scene.Poses[i].Position, scene.Poses[j].Position);
                if (apart < 0.9f) close++;
                else Assert.True(apart > 2 * reach, $"{i} and {j} are {apart} apart");
            }
        }

        Assert.Equal(5, close);
    }
}
