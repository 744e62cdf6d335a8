using Gjk.Demo.Tests.Scenes;

namespace Gjk.Demo.Tests.View;

/// <summary>A refusal of <c>view</c> gives one line, exit code 2 and no file.</summary>
public sealed class ViewRefusalTests
{
    [Theory]
    [InlineData("view", "SCENE.json")]
    [InlineData("view a.json", "--out or --svg")]
    [InlineData("view --out a.html", "SCENE.json or --builtin")]
    [InlineData("view a.json --builtin cubes --out a.html", "exclude")]
    [InlineData("view --builtin teapots --out a.html", "teapots")]
    [InlineData("view a.json b.json --out a.html", "b.json")]
    [InlineData("view a.json --out", "--out")]
    [InlineData("view a.json --nope", "--nope")]
    [InlineData("view a.json --out a.json", "overwrite the scene")]
    [InlineData("view a.json --svg ./a.json", "overwrite the scene")]
    [InlineData("view a.json --out b.html --svg b.html", "overwrite what --out writes")]
    [InlineData("view none.json --out none.html", "no such file")]
    public void WrongArgumentsAreOneLine(string args, string part) =>
        DemoRun.Of(args.Split(' ')).AssertRefused(part);

    [Theory]
    [InlineData("{", "scene.json")]
    [InlineData("""{"version":1,"objects":[],"frames":0}""", "$.frames")]
    [InlineData("""{"version":1,"objects":[],"frames":1.5}""", "$.frames")]
    [InlineData("""{"version":1,"objects":[],"frames":"many"}""", "$.frames")]
    [InlineData(
        """{"version":1,"objects":[{"shape":{"type":"point"},"velocity":[3e38,0,0]}],"frames":3}""",
        "$.objects[0].velocity")]
    [InlineData(
        """{"version":1,"objects":[{"shape":{"type":"point"},"angularVelocity":[0,0]}]}""",
        "$.objects[0].angularVelocity")]
    [InlineData(
        """
        {"version":1,"objects":[{"shape":{"type":"point"}},{"shape":{"type":"point"}}],"pairs":[[0,1]],
          "frames":2000000000}
        """,
        "2000000000 frames")]
    [InlineData("""{"version":1,"objects":[{"shape":{"type":"point"}}],"frames":2500001}""", "2500001 frames")]
    [InlineData("""{"version":1,"objects":[],"frames":2147483647}""", "2147483647 frames")]
    [InlineData(
        """{"version":1,"objects":[{"shape":{"type":"box","halfExtents":[3e38,1,1]},"scale":10}]}""",
        "$.objects[0]: the shape with its scale leaves the range of float")]
    [InlineData(
        """
        {"version":1,"objects":[{"shape":{"type":"mesh","mesh":"m"},"scale":[1,1,-3e38]}],
          "meshes":{"m":[[0,0,0],[0,0,9]]}}
        """,
        "$.objects[0]: the shape with its scale leaves the range of float")]
    [InlineData(
        """{"version":1,"objects":[{"shape":{"type":"capsule","radius":3e38,"halfHeight":3e38}}]}""",
        "$.objects[0]: the shape with its scale leaves the range of float")]
    public void BadScenesLeaveNoFile(string text, string part)
    {
        using var directory = new TempDirectory();
        string scene = directory.Write("scene.json", text);
        DemoRun.Of("view", scene, "--out", directory.File("a.html"), "--svg", directory.File("a.svg"))
            .AssertRefused(scene, part);
        Assert.Equal([scene], directory.Files);
    }

    [Fact]
    public void TargetsThatCannotBeWrittenLeaveNoFile()
    {
        using var directory = new TempDirectory();
        string scene = directory.Write("scene.json", """{"version":1,"objects":[]}""");
        string nowhere = Path.Combine(directory.Path, "nowhere", "a");
        DemoRun.Of("view", scene, "--out", nowhere).AssertRefused(nowhere, "no such directory");
        DemoRun.Of("view", scene, "--out", directory.File("a.html"), "--svg", nowhere)
            .AssertRefused(nowhere, "no such directory");
        DemoRun.Of("view", scene, "--svg", directory.Path).AssertRefused(directory.Path, "directory");
        DemoRun.Of("view", scene, "--out", "").AssertRefused("cannot be written");
        if (File.Exists("/dev/full"))
            DemoRun.Of("view", scene, "--out", "/dev/full").AssertRefused("/dev/full", "cannot be written");
        Assert.Equal([scene], directory.Files);
    }

    [UnixFact]
    public void CtrlCLeavesNoFile()
    {
        using var directory = new TempDirectory();
        string scene = directory.Write("scene.json", SceneTests.Points(20_000, pairs: ""));
        using RunningDemo demo = RunningDemo.Start(
            "view", scene, "--out", directory.File("a.html"), "--svg", directory.File("a.svg"));
        demo.WaitUntil(_ => Array.Exists(directory.Files, f => f.EndsWith(".tmp", StringComparison.Ordinal)));
        demo.Interrupt();
        DemoRun run = demo.Wait();
        Assert.Equal((130, "", ""), (run.ExitCode, run.Out, run.Error));
        Assert.Equal([scene], directory.Files);
    }
}
