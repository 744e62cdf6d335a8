using System.Globalization;
using Gjk.Demo.Scenes;

namespace Gjk.Demo.Tests.Queries;

/// <summary>Surfaces, solids and compounds with proved answers.</summary>
public sealed class ConcaveCaseTests
{
    /// <summary>Ratios to the distance and to the scale: what an answer may be off by.</summary>
    private const double PerDistance = 1.2e-7, PerScale = 1e-14;

    /// <summary>Ratio to the scale: a flag may differ from the truth where no more separates the shapes.</summary>
    private const double Unclear = 1e-9;

    /// <summary>Ratio to the larger of scale and way: what a cast may be off by.</summary>
    private const double PerWay = 1e-7;

    private readonly ConcaveScratch _scratch = new();

    [Theory]
    [InlineData("near")]
    [InlineData("touch")]
    [InlineData("deep")]
    [InlineData("plates")]
    [InlineData("self")]
    [InlineData("slivers")]
    [InlineData("scales")]
    [InlineData("far")]
    [InlineData("convex_vs_surface")]
    [InlineData("solids")]
    public void DistancesAreRight(string name)
    {
        foreach ((SceneObject a, SceneObject b, string[] row) in Rows(name))
        {
            bool isOverlap = row[2] == "true";
            double truth = Number(row[3]), depth = Number(row[5]), scale = Number(row[6]);
            PairDistance found = ConcaveQuery.Distance(a.Any, a.Pose, b.Any, b.Pose, _scratch);
            string what = $"{string.Join(',', row)}: {found}";
            if (found.IsOverlapping != isOverlap)
                Assert.True((isOverlap ? depth : truth) <= Unclear * scale, what);
            if (found.IsOverlapping) continue;
            Assert.True(Math.Abs(found.Distance - truth) <= PerDistance * truth + PerScale * scale, what);
            Assert.True(found.Result.LowerBound <= truth * (1 + 1.0 / (1 << 24)) + float.Epsilon, what);
        }
    }

    [Theory]
    [InlineData("cast_surface")]
    [InlineData("cast_convex")]
    [InlineData("cast_inside")]
    [InlineData("cast_graze")]
    public void CastsAreRight(string name)
    {
        foreach ((SceneObject a, SceneObject b, string[] row) in Rows(name))
        {
            double truth = Number(row[3]), scale = Number(row[7]);
            CastHit found = ConcaveQuery.Cast(a.Any, a.Pose, a.Velocity, b.Any, b.Pose, b.Velocity, _scratch);
            string what = $"{string.Join(',', row)}: {found}";
            Assert.True(found.Status.ToString().ToLowerInvariant() == row[2].Replace("_", ""), what);
            double way = ((Double3)b.Velocity - a.Velocity).Length;
            if (found.Status == CastStatus.Hit)
                Assert.True(Math.Abs(found.Fraction - truth) * way <= PerWay * Math.Max(scale, truth * way), what);
        }
    }

    [Fact]
    public void PointsAreInsideOrOutside()
    {
        foreach ((SceneObject a, SceneObject b, string[] row) in Rows("points"))
        {
            double truth = Number(row[3]), scale = Number(row[6]);
            PairDistance found = ConcaveQuery.SignedDistance(a.Any, a.Pose, b.Any, b.Pose, _scratch);
            string what = $"{string.Join(',', row)}: {found}";
            Assert.True(Math.Abs(Math.Abs(found.Distance) - truth) <= PerDistance * truth + PerScale * scale, what);
            bool isClear = row[2] != "on" && truth > Unclear * scale;
            if (isClear) Assert.True(found.IsOverlapping == (row[2] == "true"), what);
        }
    }

    private static (SceneObject A, SceneObject B, string[] Row)[] Rows(string name)
    {
        string file = Repository.File($"tests/Cases/concave_{name}.json");
        Scene scene = SceneFile.Load(file, CancellationToken.None);
        string[] rows = File.ReadAllLines(file.Replace(".json", ".expected.csv"));
        return [.. rows.Skip(1).Select(row => row.Split(',')).Select(
            row => (scene.Objects[int.Parse(row[0], CultureInfo.InvariantCulture)],
                scene.Objects[int.Parse(row[1], CultureInfo.InvariantCulture)], row))];
    }

    private static double Number(string text) => double.Parse(text, CultureInfo.InvariantCulture);
}
