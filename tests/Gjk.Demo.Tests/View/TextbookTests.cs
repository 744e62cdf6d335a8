using System.Text.Json;
using Gjk.Demo.Scenes;
using Gjk.Demo.Trace;

namespace Gjk.Demo.Tests.View;

/// <summary>The textbook's GJK beside the exact one: right where nothing is close, and failing on the examples as the
/// page says.</summary>
public sealed class TextbookTests
{
    /// <summary>A loop that keeps going back is more than one that stands still: at least two steps repeat.</summary>
    private const int LeastCycle = 2;

    [Fact]
    public void TheLoopIsTheFirstOfItsSearch()
    {
        (int x, int z) = Search(
            TextbookExamples.Boxes,
            (run, _) => run.Ending == TextbookEnding.Repeats && run.Steps.Count - 1 - run.RepeatOf >= LeastCycle);
        AssertSame(TextbookExamples.Boxes(x, z), TextbookExamples.Loop);
    }

    [Fact]
    public void TheWrongAnswerIsTheFirstOfItsSearch()
    {
        (int x, int z) = Search(
            TextbookExamples.Triangles,
            (run, exact) => run.Ending == TextbookEnding.Encloses && exact.Status == GjkStatus.Separated);
        AssertSame(TextbookExamples.Triangles(x, z), TextbookExamples.Wrong);
    }

    /// <summary>The last simplex is the one of the step that it is said to repeat, corner by corner. Everything that
    /// the loop does next depends on it alone. On the way |v| rises, which the exact query's never does.</summary>
    [Fact]
    public void TheLoopComesBackToWhereItWas()
    {
        Scene scene = TextbookExamples.Loop;
        TextbookRun run = TextbookGjk.Run(scene.Objects[0], scene.Objects[1]);
        Vector3[] Corners(int step) => [.. run.Steps[step].After!.Select(i => run.Steps[i].Vertex.W)];
        Assert.Equal(TextbookEnding.Repeats, run.Ending);
        Assert.InRange(run.RepeatOf, 0, run.Steps.Count - 1 - LeastCycle);
        Assert.Equal(Corners(run.RepeatOf), Corners(run.Steps.Count - 1));
        Assert.True(run.Steps[^1].Nearest.Length() > run.Steps[^2].Nearest.Length());
        DistanceResult exact = Exact(scene.Objects[0], scene.Objects[1]);
        Assert.Equal((GjkStatus.Separated, TextbookExamples.Gap), (exact.Status, exact.Distance));
        Assert.InRange(exact.Iterations, 1, 10);
    }

    [Fact]
    public void TheWrongAnswerComesFromAFlatTetrahedron()
    {
        Scene scene = TextbookExamples.Wrong;
        TextbookRun run = TextbookGjk.Run(scene.Objects[0], scene.Objects[1]);
        Vector3[] corners = [.. run.Steps[^1].After!.Select(i => run.Steps[i].Vertex.W)];
        Assert.Equal(4, corners.Length);
        Assert.InRange(corners.Distinct().Count(), 1, 3);
        Assert.InRange(Exact(scene.Objects[0], scene.Objects[1]).Distance, 0.25f, 0.26f);
    }

    /// <summary>Where the textbook ends, it is right on nearly all pairs of the cubes: it is the algorithm, not a
    /// caricature.</summary>
    [Fact]
    public void OnOrdinaryPairsTheTextbookIsRight()
    {
        Scene scene = Scene.From(BuiltInScenes.Cubes());
        int right = 0;
        foreach ((int a, int b) in scene.Pairs)
        {
            TextbookRun run = TextbookGjk.Run(scene.Objects[a], scene.Objects[b]);
            DistanceResult exact = Exact(scene.Objects[a], scene.Objects[b]);
            bool isHit = run.Ending is TextbookEnding.Encloses or TextbookEnding.Touches;
            bool isApart = run.Ending == TextbookEnding.NoNearer && !exact.IsOverlapping
                && Math.Abs(run.Distance - exact.Distance) <= 1e-5f * exact.Distance;
            if (isApart || (isHit && exact.IsOverlapping)) right++;
            Assert.InRange(run.Steps.Count, 1, TextbookGjk.StepCap);
        }

        Assert.InRange(right, 185, 190);
    }

    [Theory]
    [InlineData("loop", "Repeats", 0.25)]
    [InlineData("wrong", "Encloses", 0.253969)]
    public void AnExampleIsTraced(string name, string ending, double distance)
    {
        using var directory = new TempDirectory();
        string file = directory.File("t.html");
        DemoRun.Of("trace", "--example", name, "--out", file).AssertDone();
        var page = new PageText(file);
        page.AssertSelfContained();
        JsonElement textbook = page.Data.GetProperty("textbook");
        Assert.Equal(ending, textbook.GetProperty("ending").GetString());
        Assert.Equal(distance, page.Data.GetProperty("result").GetProperty("distance").GetDouble(), 6);
        foreach (JsonElement step in textbook.GetProperty("steps").EnumerateArray())
        {
            double[] w = Numbers(step, "w"), onA = Numbers(step, "onA"), onB = Numbers(step, "onB");
            for (int axis = 0; axis < 3; axis++) Assert.Equal(w[axis], onA[axis] - onB[axis], 6);
        }
    }

    /// <summary>Float cannot square these sizes. The exact query can, and the page says what became of the
    /// other.</summary>
    [Theory]
    [InlineData(1e25f, "NotFinite")]
    [InlineData(1e-25f, "NoNearer")]
    public void SizesBeyondTheSquareRootOfFloatHaveNoRightAnswer(float size, string ending)
    {
        ConvexShape box = ConvexShape.Box(new Vector3(size));
        var a = new SceneObject(null, box, RigidPose.Identity, default, default);
        var b = new SceneObject(null, box, new RigidPose(new Vector3(4 * size, size, 0)), default, default);
        TextbookRun run = TextbookGjk.Run(a, b);
        Assert.Equal(ending, run.Ending.ToString());
        Assert.NotEqual(2 * size, run.Distance);
        Assert.Equal(2 * size, Exact(a, b).Distance);
    }

    /// <summary>Each line of the pseudo-code names a method that the file declares.</summary>
    [Fact]
    public void TheLinesOfTheLessonAreInTheSource()
    {
        foreach (IReadOnlyList<LessonLine> lines in new[] { Lesson.Exact, Lesson.Textbook })
        {
            Assert.Equal(lines.Count, lines.Select(line => line.Id).Distinct().Count());
            foreach (LessonLine line in lines)
            {
                string source = File.ReadAllText(Path.Combine(Root(), line.File));
                Assert.Matches($@"(public|private|internal) [\w<>\[\]?. ]*\b{line.Member}\b", source);
            }
        }
    }

    /// <summary>The first offset, by x and then by z, whose run is as asked.</summary>
    private static (int X, int Z) Search(
        Func<int, int, (SceneObject A, SceneObject B)> pair, Func<TextbookRun, DistanceResult, bool> isFound)
    {
        for (int x = 0; x <= TextbookExamples.Steps; x++)
        {
            for (int z = 0; z <= TextbookExamples.Steps; z++)
            {
                (SceneObject a, SceneObject b) = pair(x, z);
                if (isFound(TextbookGjk.Run(a, b), Exact(a, b))) return (x, z);
            }
        }

        throw new InvalidOperationException("Nothing was found.");
    }

    private static DistanceResult Exact(SceneObject a, SceneObject b) =>
        ConvexQuery.Distance(a.Shape, a.Pose, b.Shape, b.Pose);

    private static void AssertSame((SceneObject A, SceneObject B) found, Scene example)
    {
        Assert.Equal(found.A.Pose.Position, example.Objects[0].Pose.Position);
        Assert.Equal(found.B.Pose.Position, example.Objects[1].Pose.Position);
        Assert.Equal(found.B.Pose.Rotation, example.Objects[1].Pose.Rotation);
        Assert.Equal(found.B.Shape.Kind, example.Objects[1].Shape.Kind);
    }

    private static double[] Numbers(JsonElement step, string name) =>
        [.. step.GetProperty(name).EnumerateArray().Select(number => number.GetDouble())];

    private static string Root()
    {
        string? at = AppContext.BaseDirectory;
        while (at is not null && !File.Exists(Path.Combine(at, "Gjk.sln"))) at = Path.GetDirectoryName(at);
        return at ?? throw new DirectoryNotFoundException("The tests do not run inside the repository.");
    }
}
