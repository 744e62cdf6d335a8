using Gjk.Demo.Fuzz;
using Gjk.Exact.Fuzz;
using Gjk.Exact.Fuzz.Families;
using Gjk.Exact.Fuzz.Promises;
using Gjk.Exact.Fuzz.Shrinking;

namespace Gjk.Demo.Tests.Fuzz;

/// <summary>Tests the search of <c>fuzz</c> from within: pairs are repeatable, wrong answers are noticed, and failing
/// pairs are shrunk and reported.</summary>
public sealed class FuzzSearchTests
{
    private static readonly ConvexShape Cube = ConvexShape.Mesh(Clouds.Box(new Vector3(-0.5f)));

    private static readonly RigidPose Right = new(new Vector3(2, 0.25f, 0.125f));

    [Fact]
    public void ASeedGivesTheSamePairs()
    {
        for (long i = 0; i < 500; i++)
        {
            string first = PairFamilies.Draw(9, i, out string family).Text;
            Assert.Equal(first, PairFamilies.Draw(9, i, out string again).Text);
            Assert.Equal(family, again);
            Assert.NotEqual(first, PairFamilies.Draw(10, i, out _).Text);
        }
    }

    [Fact]
    public void EveryFamilyIsDrawnAndBothAnswersOccur()
    {
        var families = new HashSet<string>();
        int overlaps = 0;
        const int Count = 2000;
        for (long i = 0; i < Count; i++)
        {
            overlaps += PairFamilies.Draw(1, i, out string family).Answer.IsOverlapping ? 1 : 0;
            families.Add(family);
        }

        Assert.Equal(PairFamilies.Names.Count, families.Count);
        Assert.InRange(overlaps, 0.3 * Count, 0.7 * Count);
    }

    /// <summary>The query's answer is replaced in turn by the answer of a pair that is so little further apart that
    /// only the bound shows it, of a pair a thousandth further apart, of the swapped pair, of an overlap, and of
    /// nothing.</summary>
    [Theory]
    [InlineData("bound", "lower bound|maximum")]
    [InlineData("further", "exact|planes|points|mirrors|bits|warm|maximum|repeated|unit|moving|check")]
    [InlineData("mirrored", "planes|points|check")]
    [InlineData("overlapping", "exact|plane|Overlaps|mirrors|check")]
    [InlineData("invalid", "ends|Overlaps|mirrors")]
    [InlineData("beyond", "ends|Overlaps|bits")]
    public void WrongAnswersAreNoticed(string lie, string names)
    {
        FuzzPair pair = Told(lie);
        string[] broken = [.. AllPromises.Make().Where(p => p.Broken(pair) is not null).Select(p => p.Name)];
        foreach (string name in names.Split('|'))
            Assert.Contains(broken, b => b.Contains(name, StringComparison.Ordinal));
    }

    [Fact]
    public void ARightAnswerBreaksNothing()
    {
        var pair = new FuzzPair(Cube, RigidPose.Identity, Cube, Right);
        foreach (Promise<FuzzPair> promise in AllPromises.Make()) Assert.Null(promise.Broken(pair));
    }

    /// <summary>Two points in the same place. One is a corner far from its own origin, the other is an ellipsoid of
    /// size zero. There is no scale here, but rotating a corner still rounds.</summary>
    [Fact]
    public void WhatHasNoExtentIsHeldToWhatArithmeticCanDo()
    {
        FuzzPair pair = Parse(
            "gjk1 mesh 1 0.215349019 -0.353724241 -0.519843936 @ 0 0.707106769 0 0.707106769 0 0 0 "
            + "ellipsoid 0 0 0 @ 0 0 0 1 -0.519843936 -0.353724241 -0.215349019");
        foreach (Promise<FuzzPair> promise in AllPromises.Make()) Assert.Null(promise.Broken(pair));
    }

    [Fact]
    public void APairIsShrunkToWhatThePromiseIsAbout()
    {
        FuzzPair pair = PairFamilies.Draw(3, 0, out _);
        for (long i = 1; pair.A.Hull is null || pair.B.Hull is null || Far.Broken(pair) is null; i++)
            pair = PairFamilies.Draw(3, i, out _);
        FuzzPair shrunk = Shrinker.Shrink(pair, Far, default);
        Assert.NotNull(Far.Broken(shrunk));
        Assert.True(shrunk.Text.Length < 90, shrunk.Text);
        Assert.Equal(ShapeKind.Point, shrunk.A.Kind);
        Assert.Equal(Quaternion.Identity, shrunk.PoseA.Rotation);
    }

    [Fact]
    public void ShrinkingKeepsThePromiseThatWasBroken()
    {
        FuzzPair shrunk = Shrinker.Shrink(
            new FuzzPair(Cube, RigidPose.Identity, Cube, Right), ManyCorners, default);
        Assert.Equal(5, shrunk.A.Hull!.VertexCount);
        Assert.Equal(ShapeKind.Point, shrunk.B.Kind);
    }

    [Fact]
    public void WhatIsFoundIsReportedWithExitCodeOne()
    {
        var run = new FuzzRun(
            new FuzzLength(TimeSpan.FromSeconds(60), null), 4,
            PairSources.Convex([new("answers", QueriesEndWithAnAnswer.Broken), Far]));
        BrokenPromise? broken = run.Search(_ => { }, CancellationToken.None);
        Assert.NotNull(broken);
        FuzzReport report = FuzzReport.Of(run, broken, cancelled: false);
        Assert.Equal(1, report.ExitCode);
        string[] lines = report.Text.Split('\n');
        Assert.Matches($@"^{run.Tried} pairs tried in \d+\.\d s, \d+ pairs per second, seed 4$", lines[0]);
        Assert.StartsWith($"pair {broken.Index} ({broken.Family}) breaks a promise: nothing is far: ", lines[1]);
        Assert.True(QueryRecord.TryParse(lines[2], out _, out string? reason), reason);
        Assert.NotNull(Far.Broken(Parse(lines[2])));
        Assert.Equal(run.Tried, broken.Index);
    }

    [Fact]
    public void ACancelledSearchEndsAtOnce()
    {
        var run = new FuzzRun(new FuzzLength(null, null), 4, PairSources.Convex(AllPromises.Make()));
        Assert.Null(run.Search(_ => { }, new CancellationToken(canceled: true)));
        Assert.Equal(130, FuzzReport.Of(run, null, cancelled: true).ExitCode);
        Assert.Equal(0, run.Tried);
    }

    private static FuzzPair Parse(string text)
    {
        Assert.True(FuzzPair.TryParse(text, out FuzzPair? pair), text);
        return pair;
    }

    private static FuzzPair Told(string lie)
    {
        DistanceResult right = ConvexQuery.Distance(Cube, RigidPose.Identity, Cube, Right);
        DistanceResult answer = lie switch
        {
            "further" => ConvexQuery.Distance(
                Cube, RigidPose.Identity, Cube, new RigidPose(Right.Position + new Vector3(1e-3f, 0, 0))),
            "bound" => ConvexQuery.Distance(Cube, new RigidPose(new Vector3(-1.195e-7f, 0, 0)), Cube, Right),
            "mirrored" => right.Swapped,
            "overlapping" => ConvexQuery.Distance(Cube, RigidPose.Identity, Cube, RigidPose.Identity),
            "beyond" => ConvexQuery.Distance(Cube, RigidPose.Identity, Cube, Right, 0.5f),
            _ => ConvexQuery.Distance(Cube, RigidPose.Identity, default(ConvexShape), Right),
        };
        return new FuzzPair(Cube, RigidPose.Identity, Cube, Right, answer);
    }

    private static readonly Promise<FuzzPair> Far = new(
        "nothing is far", pair => pair.Answer.Distance > 0.125f ? "it is" : null);

    private static readonly Promise<FuzzPair> ManyCorners = new(
        "hulls are small", pair => pair.A.Hull is { VertexCount: > 4 } ? "five corners" : null);
}
