using System.Globalization;
using Gjk.Demo.Scenes;
using Gjk.Demo.Study.Fit;
using Gjk.Demo.Study.Saves;
using Gjk.Demo.Study.Simulate;

namespace Gjk.Demo.Tests.Study;

public sealed class SavesTests
{
    private const string Figures = StudyRow.Header + "\n"
        + "constant,wide,all,pse,0.05,0.04,0.06,5,,\nconstant,narrow,all,pse,0.02,0.01,0.03,5,,\n"
        + "constant,wide,all,jnd,0.01,0.01,0.02,5,,\nconstant,narrow,all,jnd,0.01,0.01,0.02,5,,\n"
        + "constant,narrow,simulated-1,pse,0.02,0.01,0.03,5,,\n";

    [Theory]
    [InlineData(20)]
    [InlineData(300)]
    public void ToleranceSavesQueriesAndItsErrorsAreSmall(int objects)
    {
        Tolerance tolerance = Tolerance.Read("figures", Figures);
        Assert.Equal(("narrow", 0.02, true), (tolerance.Condition, tolerance.Curve.Pse, tolerance.IsSimulated));
        BuiltInScene spheres = BuiltInScenes.Spheres(objects);
        var saved = new SavedQueries(Scene.From(spheres), spheres.Room, speed: 0.02, tolerance, unit: 1);
        RuleCost Of(PairRule rule) => saved.Run(rule, 40, CancellationToken.None);
        RuleCost exact = Of(PairRule.Exact), proved = Of(PairRule.ProvedSpheres);
        RuleCost tolerant = Of(PairRule.TolerantSpheres), only = Of(PairRule.SpheresOnly);
        Assert.True(exact.Pairs > 0);
        Assert.Equal(exact.Pairs, exact.Queries);
        Assert.Equal((0, 0), (exact.Wrong, proved.Wrong));
        Assert.True(proved.Queries < exact.Queries);
        Assert.True(
            tolerant.Queries < proved.Queries || proved.Queries == 0, $"{tolerant.Queries} of {proved.Queries}");
        Assert.Equal(0, only.Queries);

        // Each of its errors is a gap below the threshold, which at most half of the people see.
        Assert.True(tolerant.Seen <= tolerant.Wrong / 2, $"{tolerant.Seen} of {tolerant.Wrong}");
        foreach (RuleCost cost in (RuleCost[])[exact, proved, tolerant, only])
        {
            Assert.Equal(exact.Pairs, cost.Pairs);
            Assert.True(cost.Seen <= cost.Wrong, $"{cost.Seen} of {cost.Wrong}");
        }
    }

    [Fact]
    public void ASceneFileHasItsOwnObjectsMoved()
    {
        string[] shapes =
            ["""{"type":"box","halfExtents":[0.5,0.2,0.3]}""", """{"type":"sphere","radius":0.4}"""];
        string objects = string.Join(",", Enumerable.Range(0, 12).Select(
            i => $$"""{"shape":{{shapes[i % 2]}},"position":[{{i % 3}},{{i / 3}},0]}"""));
        using var folder = new TempDirectory();
        string file = folder.Write("mixed.json", $$"""{"version":1,"name":"mixed","objects":[{{objects}}]}""");
        string[] rows = SavesCommand.Table(
            SavesCommand.Moving(file, default), Tolerance.Read("figures", Figures), 1, 30, default)
            .Split('\n', StringSplitOptions.RemoveEmptyEntries);
        Assert.Equal(5, rows.Length);
        double[][] rules = [.. rows.Skip(1).Select(r => r.Split(',')[5..].Select(
            x => double.Parse(x, CultureInfo.InvariantCulture)).ToArray())];
        Assert.All(rows.Skip(1), r => Assert.StartsWith("mixed,12,simulated,0.02,", r));
        Assert.Equal((rules[0][0], 0.0), (rules[0][1], rules[0][4]));
        Assert.True(rules[1][1] < rules[0][1] && rules[1][4] == 0, rows[2]);
        Assert.True(rules[2][1] <= rules[1][1], rows[3]);
    }

    [Theory]
    [InlineData("[]", "$.objects: at least two are needed")]
    [InlineData("""[{"shape":{"type":"sphere","radius":1},"position":[0,0,0]}]""", "at least two are needed")]
    public void ASceneOfFewerThanTwoObjectsIsRefused(string objects, string reason)
    {
        using var folder = new TempDirectory();
        string file = folder.Write("few.json", $$"""{"version":1,"name":"few","objects":{{objects}}}""");
        Assert.Contains(
            reason, Assert.Throws<RefusedException>(() => SavesCommand.Moving(file, default)).Message);
    }

    [Theory]
    [InlineData("", "must be the header of study fit")]
    [InlineData(StudyRow.Header + "\n", "no condition has a PSE above 0")]
    [InlineData(
        StudyRow.Header + "\nconstant,a,all,pse,-0.1,,,5,,\nconstant,a,all,jnd,0.1,,,5,,\n", "no condition has")]
    public void ThresholdsThatAreNoneAreRefused(string text, string reason) =>
        Assert.Contains(reason, Assert.Throws<RefusedException>(() => Tolerance.Read("figures", text)).Message);

    [Fact]
    public void PowerIsTheErrorRateWithoutADifferenceAndGrowsWithPeople()
    {
        float[] gaps = [-0.03f, -0.015f, 0, 0.01f, 0.02f, 0.035f, 0.05f];
        PowerPoint At(double difference, int people) =>
            new PowerSimulation(new Observer { Difference = difference }, gaps, 150, seed: 4).At(people, 8);
        Assert.InRange(At(0, 8).Power, 0, 0.11);
        double few = At(0.007, 4).Power, many = At(0.007, 12).Power;
        Assert.True(many > few + 0.1, $"{few} and {many}");
        Assert.True(At(0.02, 12).Power > 0.97);
    }
}
