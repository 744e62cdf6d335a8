using System.Text;

namespace Gjk.Demo.Tests.Scenes;

/// <summary>The meaning of a valid scene: every shape, every optional field, and numbers that are rounded
/// once.</summary>
public sealed class SceneTests
{
    /// <summary>Relative. The answers are exact up to their rounding to float, and these expectations are rounded
    /// too.</summary>
    private const double Tolerance = 1e-6;

    /// <summary>The shape, more fields of its object, and its distance to the point (10, 0, 0).</summary>
    public static TheoryData<string, string, double> Distances() => new()
    {
        { """{"type":"point"}""", "", 10 },
        { """{"type":"segment","a":[0,-1,0],"b":[2,3,0]}""", "", Math.Sqrt(64 + 9) },
        { """{"type":"triangle","a":[0,-1,-1],"b":[3,0,0],"c":[0,1,-1]}""", "", 7 },
        { """{"radius":2.5,"type":"sphere"}""", "", 7.5 },
        { """{"type":"capsule","radius":0.5,"halfHeight":2}""", "", 9.5 },
        { """{"type":"capsule","radius":0.5,"halfHeight":2}""", ""","rotation":[0,0,0.70710678,0.70710678]""", 7.5 },
        { """{"type":"box","halfExtents":[1,2,3]}""", "", 9 },
        { """{"type":"box","halfExtents":[1,2,3]}""", ""","rotation":[0,0.70710678,0,0.70710678]""", 7 },
        { """{"type":"box","halfExtents":[1,2,3]}""", ""","scale":[2,1,1]""", 8 },
        { """{"type":"box","halfExtents":[1,2,3]}""", ""","scale":-3,"position":[1,0,0]""", 6 },
        { """{"type":"cylinder","radius":1.5,"halfHeight":2}""", "", 8.5 },
        {
            """{"type":"taperedCapsule","topRadius":2,"bottomRadius":1,"halfHeight":1}""", ""","position":[0,-1,0]""", 8
        },
        { """{"type":"cone","radius":2,"halfHeight":1}""", ""","position":[0,1,0]""", 8 },
        { """{"type":"cone","radius":2,"halfHeight":1}""", ""","rotation":[0,0,-0.70710678,0.70710678]""", 9 },
        { """{"type":"ellipsoid","radii":[4,1,1]}""", "", 6 },
        { """{"type":"sphere","radius":1}""", ""","scale":[4,1,1]""", 6 },
        { """{"type":"halfspace","normal":[2,0,0],"offset":4}""", "", 8 },
        { """{"type":"halfspace","normal":[2,0,0],"offset":4,"rounding":1}""", ""","scale":[2,3,4]""", 4 },
        { """{"type":"mesh","mesh":"the hull"}""", "", 7 },
        { """{"type":"mesh","mesh":"the hull"}""", ""","scale":[-2,1,1]""", 8 },
        { """{"rounding":0.5,"type":"box","halfExtents":[1,2,3]}""", "", 8.5 },
        { """{"type":"box","halfExtents":[1,2,3],"rounding":0.5,"position":[2,0,0]}""", "", 6.5 },
        { """{"type":"box","halfExtents":[1,2,3],"rounding":0.5,"position":[2,0,0]}""", ""","scale":2""", 3 },
        { """{"type":"box","halfExtents":[1,2,3],"rotation":[0,0.70710678,0,0.70710678]}""", "", 7 },
        {
            """{"type":"capsule","radius":0.5,"halfHeight":2,"rotation":[0,0,0.70710678,0.70710678]}""",
            ""","scale":[1,5,5]""",
            7.5
        },
        { """{"type":"mesh","mesh":"the hull","rounding":1,"position":[1,0,0]}""", ""","position":[1,0,0]""", 4 },
        {
            """{"type":"point"}""",
            ""","name":"p","velocity":[1,2,3],"angularVelocity":[0,0,1],"position":[10,0,4]""",
            4
        },
    };

    [Theory]
    [MemberData(nameof(Distances))]
    public void EveryShapeHasItsDistance(string shape, string fields, double expected)
    {
        using var directory = new TempDirectory();
        string scene = directory.Write("scene.json", $$"""
            { "objects": [ {"shape":{{shape}}{{fields}} }, {"position":[10,0,0],"shape":{"type":"point"} } ],
              "version": 1.0, "name": "one", "frames": 3,
              "meshes": { "the hull": [[3,0,0],[3,1,0],[3,-1,0],[0,0,1],[-1,0,0],[0,0,0],[3,0,0]],
                          "unused": [[0,0,0]] } }
            """);
        CsvRow row = Assert.Single(Query(scene));
        Assert.Equal("Separated", row.Status);
        Assert.InRange(row.Distance, expected * (1 - Tolerance), expected * (1 + Tolerance));
        Assert.InRange(row.LowerBound, expected * (1 - 2 * Tolerance), row.Distance);
        Assert.InRange(
            Vector3.Distance(row.PointA, row.PointB), expected * (1 - 2 * Tolerance), expected * (1 + 2 * Tolerance));
        Assert.InRange(
            Vector3.Dot(row.Normal, row.PointB - row.PointA),
            expected * (1 - 2 * Tolerance),
            expected * (1 + 2 * Tolerance));
    }

    /// <summary>Decimals just above and below the middle of two floats. Reading them through double would round twice,
    /// to the even neighbour.</summary>
    [Theory]
    [InlineData("1.00000005960464477540", 1.0000001f)]
    [InlineData("1.0000001788139343261", 1.0000001f)]
    [InlineData("3.4028235677973365e38", float.MaxValue)]
    [InlineData("0.1", 0.1f)]
    [InlineData("1e-45", float.Epsilon)]
    [InlineData("16777217.0000000001", 16777218f)]
    [InlineData("-5E+2", -500f)]
    public void NumbersAreRoundedOnce(string text, float expected)
    {
        using var directory = new TempDirectory();
        string scene = directory.Write("scene.json", $$"""
            {"version":1,"objects":[{"shape":{"type":"point"},"position":[{{text}},0,0]},
              {"shape":{"type":"point"},"position":[0,2,0]}]}
            """);
        CsvRow row = Assert.Single(Query(scene));
        Assert.Equal(BitConverter.SingleToInt32Bits(expected), BitConverter.SingleToInt32Bits(row.PointA.X));
    }

    [Fact]
    public void WithoutPairsAllAreAskedInOrder()
    {
        using var directory = new TempDirectory();
        List<CsvRow> rows = Query(directory.Write("scene.json", Points(4, pairs: "")));
        Assert.Equal([(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)], rows.Select(r => (r.A, r.B)));
    }

    [Fact]
    public void ListedPairsKeepTheirOrderRepeatsIncluded()
    {
        using var directory = new TempDirectory();
        List<CsvRow> rows = Query(
            directory.Write("scene.json", Points(4, ""","pairs":[[3,1],[0,1],[1,3],[3,1],[2,0]]""")));
        Assert.Equal([(3, 1), (0, 1), (1, 3), (3, 1), (2, 0)], rows.Select(r => (r.A, r.B)));
        Assert.Equal(rows[0], rows[3]);
        Assert.Equal(rows[0].Distance, rows[2].Distance);
        Assert.Equal(rows[0].PointA, rows[2].PointB);
    }

    [Theory]
    [InlineData(0, "")]
    [InlineData(1, "")]
    [InlineData(3, ""","pairs":[]""")]
    public void NoPairsGiveOnlyTheHeading(int objects, string pairs)
    {
        using var directory = new TempDirectory();
        Assert.Empty(Query(directory.Write("scene.json", Points(objects, pairs))));
    }

    [Fact]
    public void AByteOrderMarkIsSkipped()
    {
        using var directory = new TempDirectory();
        string scene = directory.File("scene.json");
        File.WriteAllText(scene, Points(2, ""), new UTF8Encoding(encoderShouldEmitUTF8Identifier: true));
        Assert.Single(Query(scene));
    }

    internal static string Points(int count, string pairs)
    {
        IEnumerable<string> objects = Enumerable.Range(0, count)
            .Select(i => FormattableString.Invariant(
                $$"""{"shape":{"type":"point"},"position":[{{i * i}},{{i % 7}},{{i % 11}}]}"""));
        return $$"""{"version":1,"objects":[{{string.Join(",", objects)}}]{{pairs}}}""";
    }

    private static List<CsvRow> Query(string scene)
    {
        DemoRun run = DemoRun.Of("query", scene);
        run.AssertDone();
        return CsvRow.Parse(run.Out);
    }
}
