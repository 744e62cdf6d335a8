using System.Text.Json.Nodes;
using System.Text.RegularExpressions;
using Gjk.Demo.Scenes;

namespace Gjk.Demo.Tests.Scenes;

/// <summary>The schema, the page about the format and the example say what the reader does.</summary>
public sealed class SceneFormatTests
{
    private static readonly JsonSchema Schema =
        new(File.ReadAllText(Repository.File("docs/scene.schema.json")));

    /// <summary>What has no end, and cannot be drawn.</summary>
    private const string Endless = "halfspace";

    private static readonly string[] ConvexTypes =
    [
        .. Enum.GetNames<ShapeKind>()
            .Except([nameof(ShapeKind.None), nameof(ShapeKind.Custom)])
            .Select(kind => kind == nameof(ShapeKind.HalfSpace)
                ? Endless
                : char.ToLowerInvariant(kind[0]) + kind[1..]),
    ];

    private static readonly string[] ShapeTypes = [.. ConvexTypes, "surface", "compound"];

    private static string Example => File.ReadAllText(Repository.File("docs/example.scene.json"));

    public static TheoryData<string, string> Blocks()
    {
        var blocks = new TheoryData<string, string>();
        string page = File.ReadAllText(Repository.File("docs/scene-format.md"));
        foreach (Match block in Regex.Matches(page, "```json\n(.*?)```.*?```csv\n(.*?)```", RegexOptions.Singleline))
            blocks.Add(block.Groups[1].Value, block.Groups[2].Value);
        return blocks;
    }

    [Fact]
    public void TheSchemaHasTheFieldsOfTheReader()
    {
        AssertFields(SceneFile.Fields, Schema.Root);
        AssertFields(ObjectDraft.Fields, Schema.Definition("object"));
        string[] types = [.. Schema.Definition("shape")["oneOf"]!.AsArray()
            .Select(one => one!["$ref"]!.GetValue<string>().Replace("#/$defs/", ""))];
        Assert.Equal(ShapeTypes.Order(), types.Order());
        foreach (string type in types)
        {
            JsonObject shape = Schema.Definition(type);
            string[] needed = ["type", .. ShapeReader.FieldsOf(type)!];
            Assert.Equal(type, shape["properties"]!["type"]!["const"]!.GetValue<string>());
            Assert.Equal(needed, shape["required"]!.AsArray().Select(name => name!.GetValue<string>()));
            AssertFields([.. needed, .. ShapeReader.OptionalOf(type)], shape);
        }
    }

    [Theory]
    [MemberData(nameof(SceneTests.Distances), MemberType = typeof(SceneTests))]
    public void TheSchemaAcceptsWhatTheReaderAccepts(string shape, string more, double distance)
    {
        Assert.True(distance > 0);
        Assert.True(Schema.Accepts(
            $$"""
            {"$schema":"x","version":1,"name":"n","frames":2,"pairs":[[0,1]],"meshes":{"the hull":[[0,0,0]]},
              "objects":[{"shape":{{shape}}{{more}} },{"shape":{"type":"point"} }]}
            """));
    }

    /// <summary>The reader refuses these too, which is asserted here as well.</summary>
    [Theory]
    [InlineData("""{"objects":[]}""")]
    [InlineData("""{"version":1}""")]
    [InlineData("""{"version":2,"objects":[]}""")]
    [InlineData("""{"version":1,"objects":[],"more":1}""")]
    [InlineData("""{"version":1,"objects":[],"$schema":1}""")]
    [InlineData("""{"version":1,"objects":[],"frames":0}""")]
    [InlineData("""{"version":1,"objects":[],"frames":1.5}""")]
    [InlineData("""{"version":1,"objects":[],"frames":2147483648}""")]
    [InlineData("""{"version":1,"objects":[],"meshes":{"m":[]}}""")]
    [InlineData("""{"version":1,"objects":[],"pairs":[[0]]}""")]
    [InlineData("""{"version":1,"objects":[],"pairs":[[-1,0]]}""")]
    [InlineData("""{"version":1,"objects":[{}]}""")]
    [InlineData("""{"version":1,"objects":[{"shape":{}}]}""")]
    [InlineData("""{"version":1,"objects":[{"shape":{"type":"blob"}}]}""")]
    [InlineData("""{"version":1,"objects":[{"shape":{"type":"sphere"}}]}""")]
    [InlineData("""{"version":1,"objects":[{"shape":{"type":"sphere","radius":-1}}]}""")]
    [InlineData("""{"version":1,"objects":[{"shape":{"type":"sphere","radius":1,"radii":[1,1,1]}}]}""")]
    [InlineData("""{"version":1,"objects":[{"shape":{"type":"box","halfExtents":[1,1]}}]}""")]
    [InlineData("""{"version":1,"objects":[{"shape":{"type":"point"},"position":[1e39,0,0]}]}""")]
    [InlineData("""{"version":1,"objects":[{"shape":{"type":"point"},"scale":0}]}""")]
    [InlineData("""{"version":1,"objects":[{"shape":{"type":"point"},"scale":[1,0,1]}]}""")]
    [InlineData("""{"version":1,"objects":[{"shape":{"type":"point"},"rotation":[0,0,1]}]}""")]
    [InlineData("""{"version":1,"objects":[{"shape":{"type":"point"},"colour":"red"}]}""")]
    public void TheSchemaRefusesWhatTheReaderRefuses(string scene)
    {
        Assert.False(Schema.Accepts(scene));
        using var directory = new TempDirectory();
        Assert.Throws<RefusedException>(() => SceneFile.Load(directory.Write("s.json", scene), default));
    }

    [Theory]
    [MemberData(nameof(Blocks))]
    public void ThePageShowsWhatTheDemoAnswers(string scene, string answer)
    {
        Assert.True(Schema.Accepts(scene));
        using var directory = new TempDirectory();
        string file = directory.Write("s.json", scene);
        string[] columns = answer.Split('\n')[0].Split(',');
        string command = columns.Contains("fraction") ? "cast" : "query";
        string[] names = columns.Contains("a_name") ? ["--names"] : [];
        DemoRun run = DemoRun.Of([command, file, .. names]);
        run.AssertDone();
        Assert.Equal(Told(answer), Told(run.Out));

        // The last digit of a bound and the number of iterations are the solver's business.
        static List<string> Told(string csv)
        {
            string[][] rows = [.. csv.TrimEnd('\n').Split('\n').Select(line => line.Split(','))];
            return
            [
                .. rows.Select(row => string.Join(
                    ',', row.Where((_, i) => rows[0][i] is not ("lower_bound" or "iterations")))),
            ];
        }
    }

    [Fact]
    public void ThePageHasExamples() => Assert.True(Blocks().Count >= 3);

    [Fact]
    public void ThePageNamesEveryFieldAndShape()
    {
        string page = File.ReadAllText(Repository.File("docs/scene-format.md"));
        IEnumerable<string> fields = SceneFile.Fields.Where(field => field != "$schema")
            .Concat(ObjectDraft.Fields).Concat(ShapeReader.Decorations).Concat(ShapeTypes)
            .Concat(ShapeTypes.SelectMany(type => ShapeReader.FieldsOf(type)!));
        foreach (string field in fields) Assert.Contains($"`{field}`", page);
    }

    [Fact]
    public void TheExampleHasEveryConvexShapeAndField()
    {
        using var directory = new TempDirectory();
        DemoRun run = DemoRun.Of("example");
        run.AssertDone();
        Assert.Equal(Example, run.Out);
        Assert.True(Schema.Accepts(run.Out));
        string[] kinds = [.. Regex.Matches(run.Out, "\"type\": \"(.*?)\"").Select(m => m.Groups[1].Value).Distinct()];
        Assert.Equal(ConvexTypes.Except([Endless]).Order(), kinds.Order());
        foreach (string field in ObjectDraft.Fields.Concat(ShapeReader.Decorations))
            Assert.Contains($"\"{field}\"", run.Out);

        string scene = directory.File("scene.json");
        DemoRun written = DemoRun.Of("example", "--out", scene);
        written.AssertDone();
        Assert.Equal($"gjk-demo: wrote 1 scene to {scene}\n", written.Error);
        Assert.Equal(Example, File.ReadAllText(scene));
        DemoRun query = DemoRun.Of("query", scene);
        query.AssertDone();
        Assert.Single(CsvRow.Parse(query.Out), row => row.Overlap);
        DemoRun.Of("view", scene, "--out", directory.File("s.html")).AssertDone();
    }

    [Fact]
    public void TheExampleIsNotWrittenWhereItCannotBe()
    {
        using var directory = new TempDirectory();
        DemoRun.Of("example", "--out", directory.Path).AssertRefused(directory.Path, "directory");
        DemoRun.Of("example", "more").AssertRefused("more");
    }

    private static void AssertFields(IEnumerable<string> fields, JsonObject schema)
    {
        Assert.Equal(fields.Order(), schema["properties"]!.AsObject().Select(field => field.Key).Order());
        Assert.False(schema["additionalProperties"]!.GetValue<bool>());
    }
}
