namespace Gjk.Demo.Tests.Judge;

/// <summary>The referee finds this library's answers right, every kind of wrong one wrong, and refuses bad
/// files.</summary>
public sealed class JudgeTests
{
    private const string Scene = """
        {"version":1,"meshes":{"two":{"vertices":[[0,0,0],[1,0,0],[0,1,0],[5,0,0],[6,0,0],[5,1,0]],
            "triangles":[[0,1,2],[3,4,5]]}},
         "objects":[
          {"shape":{"type":"box","halfExtents":[1,1,1]}},
          {"shape":{"type":"box","halfExtents":[1,1,1]},"position":[3,0,0],"velocity":[-4,0,0]},
          {"shape":{"type":"box","halfExtents":[1,1,1]},"position":[1.5,0.25,0]},
          {"shape":{"type":"surface","mesh":"two"},"position":[0,0,5]},
          {"shape":{"type":"point"},"position":[0.25,0.25,6]}],
         "pairs":[[0,1],[0,2]]}
        """;

    private const string Distances =
        "a,b,overlap,distance,depth,case\n0,1,false,1,0,box/apart\n0,2,true,0,0.5,box/deep\n";

    private const string Depths = "a,b,depth,nx,ny,nz,ties,case\n0,1,-1,1,0,0,1,box/apart\n0,2,0.5,1,0,0,1,box/deep\n";

    private const string Casts =
        "a,b,outcome,fraction,nx,ny,nz,ties,case\n0,1,hit,0.25,1,0,0,1,x\n0,2,overlapping_at_start,0,0,0,0,1,x\n";

    private const string Parts = "a,b,overlap,distance,case,depth_hint,scale\n3,4,false,1,surface,0,6\n";

    public static TheoryData<string> Families =>
        [.. Directory.GetFiles(Repository.File("tests/Cases"), "*.expected.csv")
            .Select(f => Path.GetFileName(f).Replace(".expected.csv", "")).Order(StringComparer.Ordinal)];

    [Theory]
    [MemberData(nameof(Families))]
    public void TheLibraryIsRight(string family)
    {
        using var directory = new TempDirectory();
        string scene = Repository.File($"tests/Cases/{family}.json"), answers = directory.File("answers.csv");
        string[] ask = family.Contains("cast_") ? ["cast"]
            : family.StartsWith("depth_") ? ["query", "--depth"]
            : family.StartsWith("concave_") ? ["query", "--depth", "--parts"] : ["query"];
        DemoRun.Of([.. ask, scene, "--out", answers]).AssertDone();
        DemoRun run = DemoRun.Of("judge", answers, scene, scene.Replace(".json", ".expected.csv"));
        run.AssertDone();
        int pairs = File.ReadLines(answers).Count() - 1;
        Assert.Matches($@"\| all +\| +{pairs} \| +0 \|", run.Out);
    }

    [Theory]
    [InlineData(Distances, "0,1,true,0", "overlap True, truly False", "flag")]
    [InlineData(Distances, "0,1,false,1.0000005", "distance 1.0000005, truly 1", "number")]
    [InlineData(Distances, "0,1,false,nan", "distance NaN", "no answer")]
    [InlineData(Distances, "0,1,false,1e39", "distance", "no answer")]
    [InlineData(Distances, "", "no row", "no row")]
    [InlineData(Depths, "0,2,true,-0.4999", "distance -0.4999, truly -0.5", "number")]
    [InlineData(Depths, "0,2,false,0", "overlap False, truly True", "flag")]
    public void WrongAnswersAreShown(string expected, string row, string line, string column)
    {
        string other = row.StartsWith("0,2") ? "0,1,false,1\n" : expected == Depths ? "" : "0,2,true,0\n";
        AssertWrong(Scene, expected, "a,b,overlap,distance\n" + row + "\n" + other, line, column);
    }

    [Theory]
    [InlineData("status,lower_bound", "IterationLimit,0", "status IterationLimit", "no answer")]
    [InlineData("status,lower_bound", "Separated,1.0000002", "lower bound 1.0000002", "bound")]
    public void StatusAndBoundAreJudgedWhereTheyAreGiven(string columns, string cells, string line, string column) =>
        AssertWrong(
            Scene, Distances,
            $"a,b,overlap,distance,{columns}\n0,1,false,1,{cells}\n0,2,true,0,Overlapping,0\n", line, column);

    [Theory]
    [InlineData("0,1,0", "the way out along the normal is 1.75, the shortest 0.5")]
    [InlineData("1.001,0,0", "the normal's length")]
    public void AWayOutIsJudgedByWhatItCosts(string normal, string line) => AssertWrong(
        Scene, Depths, $"a,b,overlap,distance,nx,ny,nz\n0,1,false,1,1,0,0\n0,2,true,-0.5,{normal}\n", line, "normal");

    [Theory]
    [InlineData("Miss,1,1,0,0", "miss, truly hit", "flag")]
    [InlineData("hit,0.2500003,1,0,0", "fraction 0.2500003, truly 0.25", "number")]
    [InlineData("failed,0,1,0,0", "status failed", "no answer")]
    [InlineData("Hit,0.25,0,1,0", "normal", "normal")]
    public void WrongCastsAreShown(string cells, string line, string column) => AssertWrong(
        Scene, Casts, $"a,b,status,fraction,nx,ny,nz\n0,1,{cells}\n0,2,OverlappingAtStart,0,,,\n", line, column);

    [Theory]
    [InlineData("1", "the named parts are 4.8541", "part")]
    [InlineData("2", "part_a 2: the object has 2 parts", "part")]
    public void NamedPartsMustBeTheNearestOnes(string part, string line, string column) => AssertWrong(
        Scene.Replace("[[0,1],[0,2]]", "[[3,4]]"), Parts,
        $"a,b,overlap,distance,part_a,part_b\n3,4,false,1,{part},\n", line, column);

    [Theory]
    [InlineData("a,b,overlap\n", "answers.csv: line 1: there is no column distance")]
    [InlineData("a,b,overlap,distance\n0,1,false\n", "answers.csv: line 2: has 3 fields, the heading 4")]
    [InlineData("a,b,overlap,distance\n\n0,1,perhaps,1\n", "line 3: column overlap: must be true or false")]
    [InlineData("a,b,overlap,distance\n0,1,false,one\n", "line 2: column distance: must be a number, but is \"one\"")]
    [InlineData("a,b,overlap,distance\n0,3,false,1\n", "line 2: column b: the scene has no pair 0,3")]
    [InlineData("a,b,overlap,distance\n0,1,false,1\n0,1,false,1\n", "line 3: column b: the pair 0,1 has a row already")]
    [InlineData("a,b,overlap,\"distance\n", "line 1: a quotation mark is not closed")]
    public void BadAnswersAreOneLine(string answers, string part) =>
        Judge(Scene, Distances, answers, run => run.AssertRefused(part));

    [Theory]
    [InlineData("a,b,case\n", "truth.csv: line 1: there is no column depth")]
    [InlineData("a,b,overlap,distance,depth,case\n0,2,true,0,0.5,x\n", "line 2: column b: the scene's next")]
    [InlineData("a,b,overlap,distance,depth,case\n0,1,false,1,0,x\n", "line 2: ends after 1 of the scene's 2 pairs")]
    public void TruthsMustBeThoseOfTheScene(string expected, string part) =>
        Judge(Scene, expected, "a,b,overlap,distance\n", run => run.AssertRefused(part));

    [Theory]
    [InlineData(Distances, "0,1,false,1.00001\n0,2,true,0\n", "1e-5", 0)]
    [InlineData(Distances, "0,1,false,1.00003\n0,2,true,0\n", "1e-5", 1)]
    [InlineData(Depths, "0,1,false,1\n0,2,true,-0.501\n", "1e-3", 0)]
    [InlineData(Depths, "0,1,false,\n0,2,true,-0.5\n", "0", 0)]
    public void AnEngineMayBeForgiven(string expected, string rows, string tolerance, int exitCode) => Judge(
        Scene, expected, "a,b,overlap,distance\n" + rows, run => Assert.Equal(exitCode, run.ExitCode),
        "--tolerance", tolerance);

    /// <summary>Other columns, quoted fields, CRLF and a byte order mark are what other programs write.</summary>
    [Fact]
    public void OtherProgramsTablesAreRead() => Judge(
        Scene, Distances,
        "\uFEFFname,a,b,distance,overlap\r\n\"one, \"\"two\"\"\",0,2,0,TRUE\r\n x ,0,1,1.00000000001,False\r\n",
        run => run.AssertDone());

    [Fact]
    public void OnlySoManyLinesAreShown() => Judge(
        Scene, Distances, "a,b,overlap,distance\n",
        run =>
        {
            Assert.Equal(1, run.ExitCode);
            Assert.StartsWith("0,1 box/apart: there is no row for the pair\nand 1 more\n| case", run.Out);
        },
        "--lines", "1");

    private static void AssertWrong(string scene, string expected, string answers, string line, string column) => Judge(
        scene, expected, answers,
        run =>
        {
            Assert.Equal((1, ""), (run.ExitCode, run.Error));
            string[] rows = run.Out.Split('\n');
            Assert.Contains(line, rows[0]);
            string[] titles = [.. rows.First(r => r.StartsWith("| case")).Split('|').Select(t => t.Trim())];
            string[] all = [.. rows.First(r => r.StartsWith("| all")).Split('|').Select(t => t.Trim())];
            Assert.True(int.Parse(all[Array.IndexOf(titles, column)]) > 0, run.Out);
        });

    private static void Judge(
        string scene, string expected, string answers, Action<DemoRun> check, params string[] options)
    {
        using var directory = new TempDirectory();
        check(DemoRun.Of([
            "judge", directory.Write("answers.csv", answers), directory.Write("scene.json", scene),
            directory.Write("truth.csv", expected), .. options]));
    }
}
