using System.Text;

namespace Gjk.Demo.Tests.Scenes;

/// <summary>Every scene that is not exactly right gives exit code 2, one line with file, JSON path and reason, and no
/// other output.</summary>
public sealed class RefusalTests
{
    private const string Sphere = """{"shape":{"type":"sphere","radius":1}}""";

    public static TheoryData<string, string, string> BadScenes()
    {
        var data = new TheoryData<string, string, string>();
        foreach ((string json, string path, string reason) in Roots()) data.Add(json, path, reason);
        foreach ((string shape, string path, string reason) in Shapes())
            data.Add(WithObject($$"""{"shape":{{shape}}}"""), path, reason);
        foreach ((string fields, string path, string reason) in ObjectFields())
            data.Add(WithObject($$"""{"shape":{"type":"sphere","radius":1},{{fields}}}"""), path, reason);
        foreach ((string pairs, string path, string reason) in Pairs())
            data.Add($$"""{"version":1,"pairs":{{pairs}},"objects":[{{Sphere}},{{Sphere}}]}""", path, reason);
        return data;
    }

    [Theory]
    [MemberData(nameof(BadScenes))]
    public void RefusesWithPathAndReason(string json, string path, string reason)
    {
        using var directory = new TempDirectory();
        string scene = directory.Write("bad.json", json);
        DemoRun run = DemoRun.Of("query", scene, "--out", directory.File("out.csv"));
        run.AssertRefused($"{scene}: {path}: ", reason);
        Assert.Equal([scene], directory.Files);
    }

    [Fact]
    public void RefusesTextThatIsNotUnicode()
    {
        using var directory = new TempDirectory();
        string scene = directory.File("bad.json");
        byte[] json = Encoding.ASCII.GetBytes("""{"version":1,"name":"?","objects":[]}""");
        json[System.Array.IndexOf(json, (byte)0x3F)] = 0xFF;
        File.WriteAllBytes(scene, json);
        DemoRun.Of("query", scene).AssertRefused($"{scene}: $.name: ", "Unicode");
    }

    /// <summary>What has no end is asked, but not drawn.</summary>
    [Fact]
    public void AHalfSpaceIsNotDrawn()
    {
        using var directory = new TempDirectory();
        string scene = directory.Write(
            "s.json", WithObject("""{"shape":{"type":"halfspace","normal":[0,1,0],"offset":-3}}"""));
        DemoRun.Of("query", scene).AssertDone();
        DemoRun.Of("view", scene, "--out", directory.File("s.html")).AssertRefused(
            "$.objects[1]: a half-space has no end, so it cannot be drawn");
        DemoRun.Of("view", scene, "--live", "--out", directory.File("s.html")).AssertRefused(
            "$.objects[1].shape: --live takes convex shapes that end, not a half-space, which has no end");
    }

    [Fact]
    public void AControlCharacterInANameDoesNotBreakTheLine()
    {
        using var directory = new TempDirectory();
        string scene = directory.Write("bad.json", """{"version":1,"one\ntwo":3,"objects":[]}""");
        DemoRun.Of("query", scene).AssertRefused("$['one two']: unknown field");
    }

    [Fact]
    public void TimeRefusesBeforeTheFirstGoodSceneIsTimed()
    {
        using var directory = new TempDirectory();
        string good = directory.Write("good.json", """{"version":1,"objects":[]}""");
        string bad = directory.Write("bad.json", """{"version":2,"objects":[]}""");
        DemoRun.Of("time", good, bad, "--seconds", "0.1").AssertRefused($"{bad}: $.version: ");
    }

    private static string WithObject(string body) => $$"""{"version":1,"objects":[{{Sphere}},{{body}}]}""";

    private static IEnumerable<(string Json, string Path, string Reason)> Roots() =>
    [
        ("", "$", "not valid JSON at line 1, byte 1: it is empty"),
        ("[]", "$", "must be an object"),
        ("""{"version":1,"objects":[]} {}""", "$", "not valid JSON at line 1"),
        ("{\"version\":1,\n \"objects\":[{]}", "$.objects[0]", "not valid JSON at line 2, byte 14"),
        ("""{"version":1,"objects":[],}""", "$",
            "not valid JSON at line 1, byte 27: there is a comma behind the last field"),
        ("""{"version":1,"objects":[{},]}""", "$.objects[0].shape", "missing"),
        ("""{"version":1,"objects":[] // none""", "$", "not valid JSON"),
        ("""{"version":1,"objects":[""", "$.objects[0]",
            "not valid JSON at line 1, byte 25: it ends before an object or array is closed"),
        ("""{"version":1,"name":"ab""", "$.name", "it ends within a text"),
        ("""{"version":1,"name":""", "$.name", "not valid JSON at line 1, byte 21: it ends"),
        ("""{"version":1,"name":tru""", "$.name", "not valid JSON at line 1"),
        ("""{"objects":[]}""", "$.version", "missing"),
        ("""{"version":2,"objects":[]}""", "$.version", "version 2 is not known"),
        ("""{"version":1.5,"objects":[]}""", "$.version", "must be the number 1"),
        ("""{"version":"1","objects":[]}""", "$.version", "must be the number 1, but is a string"),
        ("""{"version":1}""", "$.objects", "missing"),
        ("""{"version":1,"objects":{}}""", "$.objects", "must be an array of objects, but is an object"),
        ("""{"version":1,"objects":[7]}""", "$.objects[0]", "must be an object with a \"shape\", but is a number"),
        ("""{"version":1,"version":1,"objects":[]}""", "$.version", "appears twice"),
        ("""{"version":1,"objects":[],"gravity":9}""", "$.gravity", "unknown field"),
        ("""{"version":1,"Objects":[]}""", "$.Objects", "unknown field"),
        ("""{"version":1,"objects":[],"my field":{}}""", "$['my field']", "unknown field"),
        ("""{"version":1,"objects":[],"name":null}""", "$.name", "must be a string, but is null"),
        ("""{"version":1,"objects":[],"frames":0}""", "$.frames", "at least 1"),
        ("""{"version":1,"objects":[],"frames":1.5}""", "$.frames", "whole number"),
        ("""{"version":1,"objects":[],"meshes":[]}""", "$.meshes", "must be an object"),
        ("""{"version":1,"objects":[],"meshes":{"m":[]}}""", "$.meshes.m", "at least one vertex"),
        ("""{"version":1,"objects":[],"meshes":{"m":[[0,0,0]],"m":[[0,0,0]]}}""", "$.meshes.m", "appears twice"),
        ("""{"version":1,"objects":[],"meshes":{"m":[[0,0,0],[1,2]]}}""", "$.meshes.m[1]", "has 2 elements"),
        ("""{"version":1,"objects":[],"meshes":{"m":[[0,0,0,0]]}}""", "$.meshes.m[0]", "has more elements"),
        ("""{"version":1,"objects":[],"meshes":{"m":[[0,0,1e39]]}}""", "$.meshes.m[0][2]", "too large for a float"),
        ("""{"version":1,"objects":[],"meshes":{"m":[[0,NaN,0]]}}""", "$.meshes.m[0][1]", "not valid JSON"),
        ("""{"version":1,"objects":[],"meshes":{"m":[[0,"NaN",0]]}}""", "$.meshes.m[0][1]",
            "must be a number, but is a string"),
        ("""{"version":1,"objects":[{}]}""", "$.objects[0].shape", "missing"),
    ];

    private static IEnumerable<(string Shape, string Path, string Reason)> Shapes() =>
    [
        ("""{"type":"point","rounding":-1}""", "$.objects[1].shape.rounding", "must not be negative, but is -1"),
        ("""{"type":"point","rotation":[0,0,0,2]}""", "$.objects[1].shape.rotation",
            "the quaternion's length must be within 1e-3 of 1"),
        ("""{"type":"point","position":[0,0]}""", "$.objects[1].shape.position", "must be three numbers [x, y, z]"),
        ("""{"type":"torus"}""", "$.objects[1].shape.type", "unknown type \"torus\""),
        ("""{"type":"Sphere","radius":1}""", "$.objects[1].shape.type", "unknown type"),
        ("""{"radius":1}""", "$.objects[1].shape.type", "missing"),
        ("""{"type":"sphere"}""", "$.objects[1].shape.radius", "missing"),
        ("""{"type":"sphere","radius":-1}""", "$.objects[1].shape.radius", "must not be negative, but is -1"),
        ("""{"type":"sphere","radius":null}""", "$.objects[1].shape.radius", "must be a number, but is null"),
        ("""{"type":"sphere","radius":1e39}""", "$.objects[1].shape.radius", "too large for a float"),
        ("""{"type":"sphere","radius":3.4028236e38}""", "$.objects[1].shape.radius", "too large for a float"),
        ("""{"type":"sphere","radius":1e99999999999}""", "$.objects[1].shape.radius", "too large for a float"),
        ("""{"type":"sphere","radius":1,"radius":1}""", "$.objects[1].shape.radius", "appears twice"),
        ("""{"type":"sphere","radius":1,"halfHeight":1}""", "$.objects[1].shape.halfHeight",
            "unknown field for the type \"sphere\""),
        ("""{"type":"point","colour":"red"}""", "$.objects[1].shape.colour", "unknown field"),
        ("""{"type":"capsule","radius":1}""", "$.objects[1].shape.halfHeight", "missing"),
        ("""{"type":"cylinder","radius":1,"halfHeight":-2}""", "$.objects[1].shape.halfHeight", "must not be negative"),
        ("""{"type":"box","halfExtents":[1,-1,1]}""", "$.objects[1].shape.halfExtents[1]", "must not be negative"),
        ("""{"type":"box","halfExtents":1}""", "$.objects[1].shape.halfExtents",
            "must be three numbers [x, y, z], but is a number"),
        ("""{"type":"ellipsoid","radii":[1,1]}""", "$.objects[1].shape.radii", "has 2 elements"),
        ("""{"type":"segment","a":[0,0,0]}""", "$.objects[1].shape.b", "missing"),
        ("""{"type":"triangle","a":[0,0,0],"b":[1,0,0],"c":[0,1]}""", "$.objects[1].shape.c", "has 2 elements"),
        ("""{"type":"mesh","mesh":"nope"}""", "$.objects[1].shape.mesh", "there is no mesh \"nope\""),
        ("""{"type":"mesh"}""", "$.objects[1].shape.mesh", "missing"),
        ("""{"type":"halfspace","normal":[0,1,0]}""", "$.objects[1].shape.offset", "missing"),
        ("""{"type":"halfspace","normal":[0,0,0],"offset":1}""", "$.objects[1].shape.normal",
            "must not be [0, 0, 0]"),
        ("""{"type":"halfspace","normal":[0,1,0],"offset":1e39}""", "$.objects[1].shape.offset",
            "too large for a float"),
        ("""{"type":"compound","parts":[{"shape":{"type":"halfspace","normal":[0,1,0],"offset":1}}]}""",
            "$.objects[1].shape.parts[0].shape.type", "a part of a compound cannot be a half-space"),
        ("7", "$.objects[1].shape", "must be an object"),
    ];

    private static IEnumerable<(string Fields, string Path, string Reason)> ObjectFields() =>
    [
        ("\"mass\":1", "$.objects[1].mass", "unknown field"),
        ("\"shape\":{\"type\":\"point\"}", "$.objects[1].shape", "appears twice"),
        ("\"name\":1", "$.objects[1].name", "must be a string"),
        ("\"position\":[0,0]", "$.objects[1].position", "has 2 elements"),
        ("\"position\":[0,0,-1e39]", "$.objects[1].position[2]", "too large for a float"),
        ("\"rotation\":[0,0,0,0]", "$.objects[1].rotation", "within 1e-3 of 1, but is 0"),
        ("\"rotation\":[0,0,0,1.0011]", "$.objects[1].rotation", "within 1e-3 of 1"),
        ("\"rotation\":[0,0,1]", "$.objects[1].rotation", "has 3 elements"),
        ("\"rotation\":[0,0,0,0,1]", "$.objects[1].rotation", "has more elements"),
        ("\"scale\":0", "$.objects[1].scale", "must not be 0"),
        ("\"scale\":[1,0,1]", "$.objects[1].scale[1]", "must not be 0"),
        ("\"scale\":[1,1e-60,1]", "$.objects[1].scale[1]", "must not be 0 as a float"),
        ("\"scale\":\"2\"", "$.objects[1].scale", "must be a number"),
        ("\"velocity\":[0,true,0]", "$.objects[1].velocity[1]", "must be a number, but is true or false"),
        ("\"angularVelocity\":{}", "$.objects[1].angularVelocity", "must be three numbers"),
    ];

    private static IEnumerable<(string Pairs, string Path, string Reason)> Pairs() =>
    [
        ("{}", "$.pairs", "must be an array of pairs"),
        ("[0,1]", "$.pairs[0]", "must be two object indices"),
        ("[[0,1],[0]]", "$.pairs[1]", "has 1 element"),
        ("[[0,1,1]]", "$.pairs[0]", "has more elements"),
        ("[[0,1],[1,1]]", "$.pairs[1]", "pairs object 1 with itself"),
        ("[[0,2]]", "$.pairs[0][1]", "there is no object 2: the scene has 2 objects"),
        ("[[-1,0]]", "$.pairs[0][0]", "there is no object -1"),
        ("[[0.5,1]]", "$.pairs[0][0]", "whole number"),
        ("[[0,99999999999]]", "$.pairs[0][1]", "whole number"),
        ("[[\"0\",1]]", "$.pairs[0][0]", "but is a string"),
    ];
}
