using System.Xml.Linq;
using Gjk.Demo.Output;
using Gjk.Import;

namespace Gjk.Demo.Tests.Output;

/// <summary>Mistakes of a user that once looked like errors of the program. Each is one line and exit code 2.</summary>
public sealed class UserErrorTests
{
    private const string Scene = """{"version":1,"objects":[{"shape":{"type":"point"}},{"shape":{"type":"point"}}]}""";

    [LinuxFact]
    public void AnInputWithoutAnEndIsRefused()
    {
        DemoRun run = DemoProcess.Shell("demo query - < /dev/zero");
        run.AssertRefused("standard input: cannot be read: it has more than 536870912 bytes");
        var file = Assert.Throws<ImportException>(() => WholeFile.Read("/dev/zero", 100_000, CancellationToken.None));
        Assert.Equal("/dev/zero: cannot be read: it has more than 100000 bytes", file.Message);
    }

    [UnixFact]
    public void AFileThatIsTooLargeIsRefusedBeforeItIsRead()
    {
        using var directory = new TempDirectory();
        string large = directory.File("large.json");
        using (FileStream file = File.Create(large)) file.SetLength(1L << 40);
        DemoRun.Of("query", large).AssertRefused(large, "more than 536870912 bytes");
    }

    [UnixTheory]
    [InlineData("query scene.json", "scene.json: cannot be read: the working directory was removed")]
    [InlineData("query \"$2\" --out o.csv", "o.csv: cannot be written: the working directory was removed")]
    [InlineData("replay --seconds 60 --json o.json", "o.json: cannot be written: the working directory was removed")]
    [InlineData("view --builtin cubes --svg o.svg", "o.svg: cannot be written: the working directory was removed")]
    [InlineData("import o.obj", "o.obj: cannot be read")]
    public void ARemovedWorkingDirectoryIsNamed(string call, string part)
    {
        using var directory = new TempDirectory();
        string scene = directory.Write("scene.json", Scene), gone = directory.File("gone");
        DemoProcess.Shell($"mkdir \"$1\"; cd \"$1\"; rmdir \"$1\"; demo {call}", gone, scene).AssertRefused(part);
    }

    [UnixFact]
    public void AnOutputDirectoryThatIsRemovedMeanwhileIsNamed()
    {
        using var directory = new TempDirectory();
        string target = directory.File("there/scene.json");
        const string script = """
            mkdir "$1/there"; mkfifo "$1/in.obj"
            { while ! ls -A "$1/there" | grep -q tmp; do :; done; rm -r "$1/there"; echo v 1 2 3; } > "$1/in.obj" &
            demo import "$1/in.obj" --out "$2"
            """;
        DemoProcess.Shell(script, directory.Path, target).AssertRefused(target, "cannot be written");
        Assert.False(Directory.Exists(directory.File("there")));
    }

    [Theory]
    [InlineData("import", "the file that is imported")]
    [InlineData("query", "the scene")]
    public void TheMessageSaysWhatWouldBeOverwritten(string command, string what)
    {
        using var directory = new TempDirectory();
        string input = directory.Write("a.obj", "v 0 0 0\n");
        DemoRun.Of(command, input, "--out", input).AssertRefused($"--out would overwrite {what}");
    }

    [Fact]
    public void ControlCharactersOfAFileDoNotReachTheTerminal()
    {
        using var directory = new TempDirectory();
        string scene = directory.Write("s.json", """{"version":1,"objects":[],"a\u001b[31m\u009b\u202eb":1}""");
        DemoRun run = DemoRun.Of("query", scene);
        run.AssertRefused("""a\u001b[31m\u009b\u202eb""");
        Assert.DoesNotContain(run.Error.TrimEnd('\n'), char.IsControl);
    }

    [Fact]
    public void ControlCharactersOfNamesLeaveThePictureValid()
    {
        using var directory = new TempDirectory();
        string scene = directory.Write(
            "s.json",
            """
            {"version":1,"name":"a\u0000b\uffff<&","objects":[
              {"name":"\u001bone","shape":{"type":"sphere","radius":1}},
              {"name":"two\u0008","shape":{"type":"sphere","radius":1},"position":[1,0,0]}]}
            """);
        string picture = directory.File("s.svg"), page = directory.File("s.html");
        DemoRun.Of("view", scene, "--svg", picture, "--out", page).AssertDone();
        XDocument svg = XDocument.Load(picture);
        string[] titles = [.. svg.Descendants().Where(e => e.Name.LocalName == "title").Select(e => e.Value)];
        Assert.StartsWith("""a\u0000b\uffff<&: 2 objects""", titles[0]);
        Assert.Contains(titles, t => t.StartsWith("""\u001bone – two\u0008: depth""", StringComparison.Ordinal));
        Assert.DoesNotContain(File.ReadAllText(page), c => c is '\0' or '\u001b');
    }

    [Theory]
    [InlineData("plain", "plain")]
    [InlineData("a,b", "\"a,b\"")]
    [InlineData("say \"hi\"", "\"say \"\"hi\"\"\"")]
    [InlineData("two\nlines", "two\\u000alines")]
    [InlineData("", "")]
    public void AFieldOfCsvIsOneFieldOnOneLine(string text, string field) =>
        Assert.Equal(field, PlainText.CsvField(text));
}
