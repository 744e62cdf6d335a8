namespace Gjk.Demo.Tests.Import;

/// <summary>The command itself: exit codes, what it prints, what it leaves behind.</summary>
public sealed class ImportCommandTests
{
    private const string Cube = """
        v -1 -1 -1
        v 1 -1 -1
        v 1 1 -1
        v -1 1 -1
        v -1 -1 1
        v 1 -1 1
        v 1 1 1
        v -1 1 1
        f 1 4 3 2
        f 5 6 7 8
        f 1 2 6 5
        f 2 3 7 6
        f 3 4 8 7
        f 4 1 5 8

        """;

    [Theory]
    [InlineData("import", "FILE")]
    [InlineData("import scene.json", "scene.json: its name must end in .unity, .prefab, .obj")]
    [InlineData("import a.FBX", "a.FBX: FBX is not read; save it as GLB: in Blender with File > Export")]
    [InlineData("import -", "-: its name must end in")]
    [InlineData("import a.obj b.obj", "b.obj")]
    [InlineData("import a.obj --nope", "--nope")]
    [InlineData("import a.obj --out", "--out")]
    [InlineData("import a.obj --out a.obj", "overwrite")]
    [InlineData("import a.obj --project .", "--project is for files of Unity")]
    [InlineData("import none.obj", "none.obj: cannot be read: there is no such file")]
    [InlineData("import none.unity", "none.unity: cannot be read")]
    [InlineData("import none.unity --project nowhere", "nowhere: --project: there is no such directory")]
    public void WrongArgumentsAreOneLine(string args, string part) =>
        DemoRun.Of(args.Split(' ')).AssertRefused(part);

    [Fact]
    public void TheUsualCase()
    {
        using var directory = new TempDirectory();
        string file = directory.Write("cube.obj", Cube);
        DemoRun run = DemoRun.Of("import", file);
        run.AssertDone();
        Assert.StartsWith("{ \"version\": 1, \"name\": \"cube\",\n  \"meshes\": {\n    \"default\": [\n", run.Out);
    }

    /// <summary>A warning alone is no failure.</summary>
    [Fact]
    public void AWarningGoesToStandardError()
    {
        using var directory = new TempDirectory();
        string file = directory.Write("open.obj", Cube.Replace("f 4 1 5 8\n", ""));
        DemoRun run = DemoRun.Of("import", file, "--out", directory.File("scene.json"));
        Assert.Equal(0, run.ExitCode);
        Assert.Equal(
            $"gjk-demo: {file}: warning: the part \"default\" is not closed, so whether it is convex is not known: "
            + $"as a convex shape it is the hull of its points\n"
            + $"gjk-demo: wrote 1 object to {directory.File("scene.json")}\n",
            run.Error);
    }

    /// <summary>An open box and a box with a dent become surfaces, the closed one a solid; a convex one stays a hull.
    /// The scene is a scene that query takes: a ball in the dent touches nothing, and one in the wall of it
    /// does.</summary>
    [Fact]
    public void ConcaveMeshesAreKeptAsSurfaces()
    {
        using var directory = new TempDirectory();
        const string lid = "f 5 6 7 8\n", dent = "v 0 0 0\nf 5 6 9\nf 6 7 9\nf 7 8 9\nf 8 5 9\n";
        string open = Cube.Replace(lid, "");
        string file = directory.Write("parts.obj", "o hull\n" + Cube);
        DemoRun hull = DemoRun.Of("import", file, "--concave");
        hull.AssertDone();
        Assert.Equal(DemoRun.Of("import", file).Out, hull.Out);

        DemoRun surface = DemoRun.Of("import", directory.Write("open.obj", open), "--concave");
        surface.AssertDone();
        Assert.Contains("\"shape\": { \"type\": \"surface\", \"mesh\": \"default\" }", surface.Out);

        DemoRun solid = DemoRun.Of("import", directory.Write("dent.obj", open + dent), "--concave");
        solid.AssertDone();
        Assert.Equal("", solid.Error);
        Assert.Contains("\"type\": \"surface\", \"mesh\": \"default\", \"solid\": true }", solid.Out);
        const string ball = ", { \"shape\": { \"type\": \"sphere\", \"radius\": 0.125 }, \"position\": ";
        string balls = $"{ball}[0, 0, 0.5] }}{ball}[0, 0, -0.5] }} ], \"pairs\": [[0, 1], [0, 2]]\n}}\n";
        string scene = directory.Write("scene.json", solid.Out[..solid.Out.LastIndexOf(']')] + balls);
        DemoRun query = DemoRun.Of("query", scene);
        query.AssertDone();
        Assert.Equal(["false", "true"], query.Out.TrimEnd('\n').Split('\n')[1..].Select(row => row.Split(',')[3]));
    }

    /// <summary>Points without faces have no triangles to keep: the warning stays.</summary>
    [Fact]
    public void CloudsStayHulls()
    {
        using var directory = new TempDirectory();
        string file = directory.Write("cloud.obj", Cube[..Cube.IndexOf('f')]);
        DemoRun run = DemoRun.Of("import", file, "--concave");
        Assert.Equal(DemoRun.Of("import", file).Out, run.Out);
        Assert.Contains("it is taken as the hull of its points", run.Error);
    }

    [Fact]
    public void WhatIsLeftIsWrittenAndTheExitCodeTellsOfTheRest()
    {
        using var directory = new TempDirectory();
        var text = new UnityText();
        text.Box(text.Object("good"));
        UnityObject bad = text.Object("bad");
        int line = text.NextLine;
        long id = text.Component(bad.GameObject, 154, "TerrainCollider");
        string scene = text.Save(directory, "scene.unity");
        string target = directory.File("scene.json");
        DemoRun run = DemoRun.Of("import", scene, "--out", target);
        Assert.Equal((1, ""), (run.ExitCode, run.Out));
        Assert.Equal(
            $"gjk-demo: {scene}:{line}: fileID {id} (TerrainCollider) of \"bad\": a TerrainCollider's heights are in a "
            + "binary asset that only Unity reads; export the terrain as OBJ\n"
            + $"gjk-demo: {scene}: 1 thing could not be read; the scene has the other object\n",
            run.Error);
        DemoRun.Of("query", target).AssertDone();
    }

    [Fact]
    public void IfNothingIsLeftTheOldFileStays()
    {
        using var directory = new TempDirectory();
        var text = new UnityText();
        text.Component(text.Object("bad").GameObject, 154, "TerrainCollider");
        string scene = text.Save(directory, "scene.unity");
        string target = directory.Write("scene.json", "old");
        DemoRun run = DemoRun.Of("import", scene, "--out", target);
        Assert.Equal((1, ""), (run.ExitCode, run.Out));
        Assert.EndsWith("1 thing could not be read; nothing is left to write\n", run.Error);
        Assert.Equal("old", File.ReadAllText(target));
        Assert.Equal(2, directory.Files.Length);
    }

    [Fact]
    public void ARefusalLeavesNoFile()
    {
        using var directory = new TempDirectory();
        string file = directory.Write("bad.obj", Cube + "f 1 2 9\n");
        DemoRun.Of("import", file, "--out", directory.File("scene.json")).AssertRefused(
            $"{file}:15: there is no vertex 9: 8 came before this face");
        Assert.Equal([file], directory.Files);
    }

    /// <summary>A name may hold anything.</summary>
    [Fact]
    public void NamesAreQuotedAndMadeUnique()
    {
        using var directory = new TempDirectory();
        const string triangle = "f 1 2 3\n";
        string file = directory.Write(
            "names.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\no a \"\\\\ \u00e9\n" + triangle + "o b\n" + triangle);
        Assert.Equal(["a \"\\\\ \u00e9", "b"], Imported.Quietly(file).Names);
    }

    [UnixFact]
    public void CtrlCLeavesNoFile()
    {
        using var directory = new TempDirectory();
        string pipe = directory.File("slow.obj");
        DemoProcess.Shell("mkfifo \"$1\"", pipe).AssertDone();
        using RunningDemo demo = RunningDemo.Start("import", pipe, "--out", directory.File("scene.json"));
        demo.WaitUntil(_ => Array.Exists(directory.Files, f => f.EndsWith(".tmp", StringComparison.Ordinal)));
        demo.Interrupt();
        DemoRun run = demo.Wait();
        Assert.Equal((130, "", ""), (run.ExitCode, run.Out, run.Error));
        Assert.Equal([pipe], directory.Files);
    }

    [LinuxFact]
    public void AnInputWithoutAnEndIsRefused()
    {
        using var directory = new TempDirectory();
        File.CreateSymbolicLink(directory.File("endless.stl"), "/dev/zero");
        DemoRun.Of("import", directory.File("endless.stl")).AssertRefused("more than 268435456 bytes");
    }
}
