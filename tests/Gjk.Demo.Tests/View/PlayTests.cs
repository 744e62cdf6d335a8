using System.Security.Cryptography;
using System.Text;
using System.Text.RegularExpressions;

namespace Gjk.Demo.Tests.View;

/// <summary>What <c>play</c> writes, as far as no browser is needed: one file with the library, its licences, and a
/// policy that allows its own scripts only. The browser tests use the page.</summary>
public sealed class PlayTests
{
    private const string TwoSpheres = """
        {"version":1,"name":"a <b> & c","objects":[
          {"name":"one","shape":{"type":"sphere","radius":1}},
          {"name":"</script>","shape":{"type":"sphere","radius":1},"position":[3,0,0]}]}
        """;

    [Theory]
    [InlineData("play", "--out")]
    [InlineData("play scene.json --out a.html", "scene.json")]
    [InlineData("play --scene none.json --out a.html", "no such file")]
    [InlineData("play --mesh none.obj --out a.html", "no such file")]
    [InlineData("play --mesh part.blend --out a.html", "--mesh part.blend")]
    [InlineData("play --mesh a.obj --out a.obj", "overwrite the mesh")]
    [InlineData("play --scene a.json --out a.json", "overwrite the scene")]
    [InlineData("play --nope --out a.html", "--nope")]
    public void WrongArgumentsAreOneLine(string args, string part) =>
        DemoRun.Of(args.Split(' ')).AssertRefused(part);

    [Fact]
    public void BadInputLeavesNoFile()
    {
        using var directory = new TempDirectory();
        string scene = directory.Write("scene.json", """{"version":1,"objects":[{"shape":{"type":"ball"}}]}""");
        string mesh = directory.Write("part.obj", "v 1 2\n");
        string many = directory.Write("many.json", Many(5_001));
        string page = directory.File("a.html");
        DemoRun.Of("play", "--scene", scene, "--out", page).AssertRefused(scene, "$.objects[0].shape.type");
        DemoRun.Of("play", "--mesh", mesh, "--out", page).AssertRefused(mesh, "three coordinates");
        DemoRun.Of("play", "--scene", many, "--out", page).AssertRefused(many, "5001 objects", "5000");
        Assert.False(File.Exists(page));
        Assert.Equal(3, directory.Files.Count());
    }

    /// <summary>The demo alone, as its own project builds it, has no files for browsers beside it.</summary>
    [UnixFact]
    public void WithoutTheFilesForBrowsersItSaysHowToBuildThem()
    {
        using var directory = new TempDirectory();
        const string script = """
            cp "$(dirname "$GJK_DEMO")"/*.* "$1"
            "$GJK_HOST" "$1/gjk-demo.dll" play --out "$1/page.html"
            """;
        DemoProcess.Shell(script, directory.Path).AssertRefused("not built for browsers", "src/Gjk.Web");
        Assert.False(File.Exists(directory.File("page.html")));
    }

    [Fact]
    public void ThePageAllowsItsOwnScriptsOnly()
    {
        using var directory = new TempDirectory();
        string page = directory.File("a.html");
        DemoProcess.Run("play", "--scene", directory.Write("scene.json", TwoSpheres), "--out", page).AssertDone();
        string text = File.ReadAllText(page);
        string policy = Regex.Match(text, "Content-Security-Policy\" content=\"([^\"]*)\"").Groups[1].Value;
        Assert.StartsWith("default-src 'none'; script-src 'sha256-", policy);
        Assert.DoesNotContain("unsafe-inline", policy);
        string[] scripts = [.. Regex.Matches(text, "<script type=\"module\">(.*?)</script>", RegexOptions.Singleline)
            .Select(m => m.Groups[1].Value)];
        Assert.Equal(4, scripts.Length);
        Assert.All(scripts, script => Assert.Contains(Hash(script), policy));
        string style = Regex.Match(text, "<style>(.*?)</style>", RegexOptions.Singleline).Groups[1].Value;
        Assert.Contains(Hash(style), policy);
        Assert.Equal(6, Regex.Count(text, "<script"));
        Assert.Contains("<title>a &lt;b&gt; &amp; c: Gjk playground</title>", text);
    }

    [Fact]
    public void ThePageHoldsTheLibraryAndTheLicencesOfWhatIsInIt()
    {
        using var directory = new TempDirectory();
        string page = directory.File("a.html");
        DemoProcess.Run("play", "--out", page).AssertDone();
        string text = File.ReadAllText(page);
        string[] files = ["Gjk.Core.dll", "Gjk.Web.dll", "System.Private.CoreLib.dll", "dotnet.native.wasm"];
        foreach (string file in files)
            Assert.Contains($"\"{file}\":\"", text);
        foreach (string owner in new[] { ".NET Foundation and Contributors", "Emscripten authors", "three.js authors" })
            Assert.Contains(owner, text);
        Assert.Contains("License notice for zlib", text, StringComparison.OrdinalIgnoreCase);
        Assert.InRange(new FileInfo(page).Length, 1_000_000, 4_000_000);
    }

    [Theory]
    [InlineData("view a.json --live --svg a.svg", "--live needs --out")]
    [InlineData("view none.json --live --out a.html", "no such file")]
    public void ALivePageNeedsAPage(string args, string part) =>
        DemoRun.Of(args.Split(' ')).AssertRefused(part);

    [Fact]
    public void ALivePageHoldsTheLibraryAndALargeOneIsRefused()
    {
        using var directory = new TempDirectory();
        string scene = directory.Write("scene.json", TwoSpheres), page = directory.File("a.html");
        DemoRun.Of("view", directory.Write("many.json", Many(201)), "--live", "--out", page)
            .AssertRefused("many.json", "--live", "201 objects", "200");
        Assert.False(File.Exists(page));
        Assert.Equal(0, DemoProcess.Run("view", scene, "--live", "--out", page).ExitCode);
        string live = File.ReadAllText(page);
        Assert.Contains("script-src 'unsafe-inline' 'wasm-unsafe-eval'", live);
        Assert.Contains("\"Gjk.Core.dll\":\"", live);
        Assert.Contains("Emscripten authors", live);
        Assert.Equal(0, DemoRun.Of("view", scene, "--out", page).ExitCode);
        Assert.DoesNotContain("wasm", File.ReadAllText(page));
    }

    /// <summary>A page offers the bodies of a scene and of a file of meshes together, and says how many.</summary>
    [Fact]
    public void ASceneAndTheMeshesOfAGlbAreOfferedTogether()
    {
        using var directory = new TempDirectory();
        string scene = directory.Write("scene.json", TwoSpheres), page = directory.File("a.html");
        string mesh = directory.File("part.glb");
        File.WriteAllBytes(mesh, Glb());
        DemoRun run = DemoProcess.Run("play", "--scene", scene, "--mesh", mesh, "--out", page);
        Assert.Equal(0, run.ExitCode);
        Assert.Contains($"wrote the playground with 3 bodies to {page}", run.Error);
        Assert.Contains("\"names\":[\"one\",", File.ReadAllText(page));
        Assert.Contains(",\"wedge\"]", File.ReadAllText(page));
        DemoRun plain = DemoProcess.Run("play", "--out", page);
        Assert.Contains($"wrote the playground to {page}", plain.Error);
    }

    /// <summary>A binary glTF of one triangle.</summary>
    private static byte[] Glb()
    {
        string json = """
            {"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"name":"wedge","mesh":0}],
            "meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
            "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}],
            "bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"byteLength":36}]}
            """;
        byte[] text = Encoding.ASCII.GetBytes(json.PadRight((json.Length + 3) / 4 * 4));
        using var file = new MemoryStream();
        using var writer = new BinaryWriter(file);
        uint[] head = [0x46546C67, 2, (uint)(12 + 8 + text.Length + 8 + 36), (uint)text.Length, 0x4E4F534A];
        foreach (uint word in head) writer.Write(word);
        writer.Write(text);
        writer.Write(36u);
        writer.Write(0x004E4942u);
        foreach (float x in new[] { 0f, 0, 0, 1, 0, 0, 0, 1, 0 }) writer.Write(x);
        writer.Flush();
        return file.ToArray();
    }

    [Fact]
    public void PartsThatAreNotConvexGetAWarning()
    {
        using var directory = new TempDirectory();
        string mesh = directory.Write("part.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n");
        DemoRun run = DemoProcess.Run("play", "--mesh", mesh, "--out", directory.File("a.html"));
        Assert.Equal(0, run.ExitCode);
        Assert.Contains("has no faces", run.Error);
        Assert.True(File.Exists(directory.File("a.html")));
    }

    private static string Many(int count)
    {
        string objects = string.Join(",", Enumerable.Repeat("""{"shape":{"type":"point"}}""", count));
        return $$"""{"version":1,"objects":[{{objects}}]}""";
    }

    private static string Hash(string text) =>
        $"'sha256-{Convert.ToBase64String(SHA256.HashData(Encoding.UTF8.GetBytes(text)))}'";
}
