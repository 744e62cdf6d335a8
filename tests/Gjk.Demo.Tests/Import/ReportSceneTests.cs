namespace Gjk.Demo.Tests.Import;

/// <summary>Scenes that are built as the report's two are: no prefab and no collider of Unity, but a mesh and a script
/// on each object, and some of the objects inactive. The numbers are our own.</summary>
public sealed class ReportSceneTests
{
    /// <summary>20 cubes below an active object, and 20 spheres below an inactive one.</summary>
    [Fact]
    public void OfTheMeasuredSceneTheCubesAreImported()
    {
        using var directory = new TempDirectory();
        string scene = Measured().Save(directory, "measure.unity");
        Imported imported = Imported.Quietly(scene);
        Assert.Equal("measure", imported.Scene.Name);
        Assert.Equal(Enumerable.Range(0, 20).Select(i => $"Cube ({i})"), imported.Names);
        Assert.Equal(190, imported.Scene.Pairs.Count);
        for (int i = 0; i < 20; i++)
        {
            Vector3 middle = PlaceOf(i) + new Vector3(0, 2, 0);
            Imported.AssertBounds(
                imported.Scene.Objects[i], middle - new Vector3(0.5f), middle + new Vector3(0.5f));
        }
    }

    [Fact]
    public void TheCommandsTakeTheWrittenScene()
    {
        using var directory = new TempDirectory();
        string unity = Measured().Save(directory, "measure.unity");
        string scene = directory.File("scene.json");
        DemoRun run = DemoRun.Of("import", unity, "--out", scene);
        run.AssertDone();
        Assert.Equal("", run.Out);
        DemoRun query = DemoRun.Of("query", scene);
        query.AssertDone();
        List<CsvRow> rows = CsvRow.Parse(query.Out);
        Assert.Equal(190, rows.Count);
        Assert.Equal(1.5f, rows[0].Distance);

        // Without --out the same scene goes to standard output.
        DemoRun piped = DemoRun.Of("import", unity);
        piped.AssertDone();
        Assert.Equal(File.ReadAllText(scene), piped.Out);
        Assert.Equal(2, directory.Files.Length);
    }

    /// <summary>Nine objects of which three are switched off, one of them by the object above it.</summary>
    [Fact]
    public void OfTheVisualizerTheActiveObjectsAreImported()
    {
        using var directory = new TempDirectory();
        var text = new UnityText();
        UnityObject camera = text.Object("Main Camera", position: new Vector3(0, 1, -10));
        text.Component(camera.GameObject, 20, "Camera", "field of view: 60");
        UnityObject off = text.Object("Hidden", isActive: false);
        for (int i = 0; i < 9; i++)
        {
            UnityObject one = text.Object(
                "Shape", i == 8 ? off : null, new Vector3(3 * i, 0, 0), isActive: i is not (2 or 5));
            text.ScriptCollider(one, i % 2 == 0 ? UnityText.Cube : UnityText.Sphere);
        }

        Imported imported = Imported.Quietly(text.Save(directory, "visualizer.unity"));
        Assert.Equal(["Shape", "Shape #2", "Shape #3", "Shape #4", "Shape #5", "Shape #6"], imported.Names);
        Assert.Equal([0f, 3, 9, 12, 18, 21], imported.Scene.Objects.Select(o => o.Pose.Position.X));
        Assert.Equal(
            ["Box", "Sphere", "Sphere", "Box", "Box", "Sphere"],
            imported.Scene.Objects.Select(o => o.Shape.Kind.ToString()));
    }

    /// <summary>Everything off is nothing to import.</summary>
    [Fact]
    public void ASceneWithoutAnActiveShapeIsRefused()
    {
        using var directory = new TempDirectory();
        var text = new UnityText();
        text.ScriptCollider(text.Object("Cube", isActive: false), UnityText.Cube);
        text.Object("Light");
        string scene = text.Save(directory, "empty.unity");
        DemoRun.Of("import", scene, "--out", directory.File("out.json")).AssertRefused(scene, "no active object");
        Assert.Equal([scene], directory.Files);
    }

    private static UnityText Measured()
    {
        var text = new UnityText();
        UnityObject cubes = text.Object("Cubes", position: new Vector3(0, 2, 0));
        UnityObject spheres = text.Object("Spheres", isActive: false);
        for (int i = 0; i < 20; i++)
        {
            text.ScriptCollider(text.Object($"Cube ({i})", cubes, PlaceOf(i)), UnityText.Cube);
            text.ScriptCollider(text.Object($"Sphere ({i})", spheres, PlaceOf(i)), UnityText.Sphere);
        }

        return text;
    }

    private static Vector3 PlaceOf(int i) => new(2.5f * (i % 5), 0, 2.5f * (i / 5));
}
