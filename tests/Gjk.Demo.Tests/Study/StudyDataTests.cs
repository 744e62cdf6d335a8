namespace Gjk.Demo.Tests.Study;

/// <summary>Bad data and bad plans are refused in one line, and nothing is written.</summary>
public sealed class StudyDataTests : IDisposable
{
    private const string Header = "plan,participant,trial,task,kind,pair,start,gap,distance,answer\n";

    private const string Row = "p,anna,1,constant,trial,box,,0.1,0.1,1\n";

    private readonly TempDirectory _directory = new();

    public void Dispose() => _directory.Dispose();

    [Theory]
    [InlineData("", "it is empty")]
    [InlineData(Header, "it has no trials")]
    [InlineData("plan,participant,trial,task,kind,pair,start,gap,answer\n", "line 1: the column distance is missing")]
    [InlineData(
        Header + "p,anna,1,constant,trial,box,,0.1,NaN,1\n", "line 2: column distance: \"NaN\" is not a finite number")]
    [InlineData(Header + "p,anna,1,constant,trial,box,,0.1,0.1,2\n", "line 2: column answer: \"2\" must be 0 or 1")]
    [InlineData(
        Header + "p,anna,1,constant,trial,box,,0.1,1e60,1\n",
            "line 2: column distance: \"1e60\" is not a finite number")]
    [InlineData(Header + "p,,1,constant,trial,box,,0.1,0.1,1\n", "line 2: column participant: is empty")]
    [InlineData(Header + "p,anna,1,guess,trial,box,,0.1,0.1,1\n", "line 2: column task: \"guess\" must be")]
    [InlineData(Header + "p,anna,1\n", "line 2: it has 3 fields, but there are 10 columns")]
    [InlineData(Header + Row + "q,anna,2,constant,trial,box,,0.1,0.1,1\n", "line 3: its plan q is not the plan p of")]
    [InlineData(Header + Row + Row, "line 3: trial 1 of anna is there already")]
    [InlineData(Header + Row, "condition box: all 1 answers are \"touching\", so there is no threshold")]
    [InlineData(Header + "p,anna,1,constant,practice,box,,0.1,0.1,1\n", "no trials are left")]
    [InlineData(Header + "p,\"anna,1\n", "line 2: a quote is not closed")]
    [InlineData("{", "not valid JSON at line 1")]
    [InlineData("{\"trials\":[]}", "it has no trials")]
    [InlineData("{\"trials\":3}", "$.trials: must be an array")]
    [InlineData("{\"trials\":[{\"plan\":\"p\"}]}", "$.trials[0].participant: missing")]
    public void BadDataAreRefusedWithoutOutput(string text, string reason)
    {
        string data = _directory.File("data.csv");
        File.WriteAllText(data, text);
        DemoRun run = DemoRun.Of(
            "study", "fit", data, "--out", _directory.File("o.csv"), "--page", _directory.File("o.html"));
        run.AssertRefused("data.csv", reason);
        Assert.Equal([data], _directory.Files);
    }

    [Fact]
    public void ADistanceThatIsNotTheLibrarysAnswerIsRefused()
    {
        string data = _directory.File("data.csv"), bad = _directory.File("bad.csv");
        DemoRun.Of("study", "simulate", "--people", "2", "--out", data).AssertDone();
        string text = File.ReadAllText(data);
        string distance = text.Split('\n')[1].Split(',')[10];
        File.WriteAllText(
            bad, text.Replace(
                "," + distance + ",", "," + MathF.BitIncrement(float.Parse(distance)).ToString("R") + ","));
        DemoRun.Of("study", "fit", bad).AssertRefused("line 2: column distance", "is not the library's answer");
    }

    [Theory]
    [InlineData("\"seed\": 1", "\"seed\": -1", "$.seed: must be 0 to")]
    [InlineData("\"radius\": 0.4 } }", "\"radius\": -0.4 } }", "$.pairs[1].b.radius: must not be negative")]
    [InlineData(
        "\"mesh\": \"wedge\"", "\"mesh\": \"wege\"", "$.pairs[2].b.mesh: there is no mesh \"wege\" in \"meshes\"")]
    [InlineData(
        "\"gaps\": [-0.03, -0.015,", "\"gaps\": [-0.03, -0.03,", "$.constant.gaps[1]: the gap -0.03 is there already")]
    [InlineData(
        "\"camera\": \"fixed\"", "\"camera\": \"fix\"", "$.views[0].camera: must be fixed or random or turning")]
    [InlineData("\"#20262f\"", "\"red\"", "$.views[0].background: must be a colour as #rrggbb")]
    [InlineData("\"hull 12\"", "\"hull 2\"", "$.mismatch.colliders[2]: unknown collider \"hull 2\"")]
    [InlineData("\"practice\": 2", "\"practise\": 2", "$.practise: unknown field")]
    [InlineData("\"name\": \"nearly touching\"", "\"name\": \" \"", "$.name: must not be empty")]
    [InlineData("\"name\": \"box-sphere\"", "\"name\": \"box-box\"", "$.pairs[1]: there is a pair \"box-box\" already")]
    [InlineData("\"questions\": true", "\"questions\": 1", "$.questions: must be true or false, but is a number")]
    [InlineData("\"repeats\": 4", "\"repeats\": 1000", "$: 21027 trials for each person are more than 10000")]
    public void ABadPlanGetsItsPath(string good, string bad, string reason)
    {
        string plan = _directory.File("plan.json");
        DemoRun written = DemoRun.Of("study", "plan", "--out", plan);
        Assert.Equal((0, "", $"gjk-demo: wrote {plan}\n"), (written.ExitCode, written.Out, written.Error));
        string text = File.ReadAllText(plan);
        Assert.Contains(good, text);
        File.WriteAllText(plan, text.Replace(good, bad));
        DemoRun.Of("study", "plan", "--check", plan).AssertRefused("plan.json: " + reason);
    }

    [Fact]
    public void EveryFieldOfTheDefaultPlanIsExplained()
    {
        string[] lines = DemoRun.Of("study", "plan").Out.Split('\n');
        string[] fields =
            [.. lines.Where(l => l.StartsWith("  \"") && !l.StartsWith("  \"//")).Select(l => l.Split('"')[1])];
        Assert.True(fields.Length >= 16);
        foreach (string field in fields) Assert.Contains(lines, l => l.StartsWith($"  \"// {field}\": "));
    }

    [Fact]
    public void WhatWasSimulatedIsFound()
    {
        string data = _directory.File("data.csv"), page = _directory.File("o.html"), curves = _directory.File("c.svg");
        string thresholds = _directory.File("t.svg");
        DemoRun.Of(
            "study", "simulate", "--people", "20", "--bias", "0.01", "--difference", "0.01", "--out",
                data).AssertDone();
        DemoRun run =
            DemoRun.Of("study", "fit", data, "--page", page, "--curves", curves, "--thresholds", thresholds);
        Assert.Equal(0, run.ExitCode);
        string[][] rows = [.. run.Out.Split('\n').Select(l => l.Split(','))];
        string[] Row(string task, string condition, string measure) =>
            rows.Single(r => r.Length > 3 && r[0] == task && r[1] == condition && r[2] == "all" && r[3] == measure);
        Assert.Equal(0.01, double.Parse(Row("constant", "box-box", "pse")[4]), 0.004);
        Assert.Equal(0.03, double.Parse(Row("adjustment", "sphere-wedge", "mean")[4]), 0.006);
        string[] difference = Row("constant", "box-box - sphere-wedge", "difference of pse");
        Assert.True(double.Parse(difference[6]) < 0, string.Join(',', difference));
        Assert.True(double.Parse(difference[8]) < 0.01, string.Join(',', difference));
        Assert.Contains("Simulated observers: these are no data of people.", File.ReadAllText(page));
        foreach (string svg in (string[])[curves, thresholds]) System.Xml.Linq.XDocument.Load(svg);
    }

    [Fact]
    public void WhoFailsCatchTrialsIsLeftOutAndNamed()
    {
        string data = _directory.File("data.csv"), marked = _directory.File("marked.csv");
        DemoRun.Of("study", "simulate", "--people", "3", "--lapse", "0", "--out", data).AssertDone();
        string[] lines = File.ReadAllLines(data);
        for (int i = 0; i < lines.Length; i++)
        {
            string[] f = lines[i].Split(',');
            if (f[1] != "simulated-2" || f[4] != "catch") continue;
            f[11] = f[11] == "1" ? "0" : "1";
            lines[i] = string.Join(',', f);
        }

        File.WriteAllLines(marked, lines);
        DemoRun run = DemoRun.Of("study", "fit", marked);
        Assert.Contains("Excluded for failing more than 25 % of the catch trials: simulated-2.", run.Error);
        Assert.Contains("catch,,simulated-2,errors,1,,,6,,excluded", run.Out);
        Assert.DoesNotContain("constant,box-box,simulated-2", run.Out);
        Assert.Contains("constant,box-box,simulated-1", run.Out);
    }
}
