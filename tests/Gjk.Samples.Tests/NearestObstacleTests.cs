using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Numerics;
using System.Text.RegularExpressions;
using Gjk.Core;
using NearestObstacle;
using Xunit;

namespace Gjk.Samples.Tests;

public partial class NearestObstacleTests
{
    private const string Sample = "NearestObstacle";
    private const int Steps = 50;

    /// <summary>Half of the last digit that is printed, and what rounding adds.</summary>
    private const float DistanceSlack = 0.51e-4f, PointSlack = 2e-3f;

    private static readonly SampleRun Run = SampleProcess.Run(Sample, $"{Steps}");

    [Fact]
    public void EachStepIsTheNearestOfAllPairs()
    {
        Run.AssertDone();
        var scene = new CollisionScene();
        var arm = new RobotArm(scene);
        Obstacles.AddTo(scene, Program.ObstacleCount, Program.Seed);
        Row[] rows = [.. Run.Lines[1..^1].Select(Row.Read)];
        Assert.Equal(Steps, rows.Length);
        for (int step = 0; step < Steps; step++)
        {
            arm.MoveTo(step * Program.StepTime);
            Dictionary<(string, string), float> all = AllDistances(scene, arm);
            float least = all.Values.Min();
            Row row = rows[step];
            Assert.Equal(step, row.Step);
            Assert.Equal(least, row.Distance, DistanceSlack);
            Assert.Equal(least, all[(row.Link, row.Other)]);
            Assert.Equal(least, Vector3.Distance(row.PointA, row.PointB), PointSlack);
        }

        // The motion is worth a test: the arm touches some obstacles, and is well away from all at other times.
        Assert.InRange(rows.Count(r => r.Distance == 0), 1, Steps / 2);
        Assert.Contains(rows, r => r.Distance > 0.1f);
        Assert.True(rows.Select(r => r.Link).Distinct().Count() >= 3);
        Assert.True(rows.Select(r => r.Other).Distinct().Count() >= 10);
    }

    [Fact]
    public void NeighboursAreNotTestedAndAllOthersAre()
    {
        var scene = new CollisionScene();
        var arm = new RobotArm(scene);
        Obstacles.AddTo(scene, 1, Program.Seed);
        int obstacle = arm.Links.Max() + 1;
        for (int i = 0; i < arm.Links.Count; i++)
        {
            ObjectSettings link = scene.GetSettings(arm.Links[i]);
            Assert.True(ObjectSettings.AreTested(link, scene.GetSettings(obstacle)));
            for (int j = 0; j < i; j++)
                Assert.Equal(i - j > 1, ObjectSettings.AreTested(link, scene.GetSettings(arm.Links[j])));
        }

        // Neighbours do touch, so the masks matter.
        var (first, second) = (arm.Links[1], arm.Links[2]);
        Assert.True(scene.Distance(first, second).IsOverlapping);
    }

    [Theory]
    [InlineData("0")]
    [InlineData("-1")]
    [InlineData("many")]
    [InlineData("1", "2")]
    public void WrongArgumentsAreRefused(params string[] args) =>
        SampleProcess.Run(Sample, args).AssertRefused("usage: NearestObstacle [STEPS]");

    [Fact]
    public void TheReadmeShowsTheOutput() =>
        Readme.AssertShows(Sample, Run.Lines, l => Regex.Replace(l, @"\d+\.\d$|median .* us", ""));

    private static Dictionary<(string, string), float> AllDistances(CollisionScene scene, RobotArm arm)
    {
        var all = new Dictionary<(string, string), float>();
        foreach (int link in arm.Links)
        {
            for (int other = 0; other < scene.Count; other++)
            {
                bool isTested = link != other
                    && ObjectSettings.AreTested(scene.GetSettings(link), scene.GetSettings(other));
                if (!isTested) continue;
                DistanceResult result = ConvexQuery.Distance(
                    scene.GetShape(link), scene.GetPose(link), scene.GetShape(other), scene.GetPose(other));
                all[(arm.NameOf(link), arm.NameOf(other))] = result.Distance;
            }
        }

        return all;
    }

    private sealed record Row(int Step, string Link, string Other, float Distance, Vector3 PointA, Vector3 PointB)
    {
        public static Row Read(string line)
        {
            Match m = Columns().Match(line);
            Assert.True(m.Success, line);
            return new Row(
                int.Parse(m.Groups["step"].Value), m.Groups["link"].Value, m.Groups["other"].Value,
                Number(m.Groups["distance"].Value), Point(m.Groups["a"].Value), Point(m.Groups["b"].Value));
        }

        private static Vector3 Point(string text)
        {
            float[] numbers = [.. text.Split(", ").Select(Number)];
            return new Vector3(numbers[0], numbers[1], numbers[2]);
        }

        private static float Number(string text) => float.Parse(text, CultureInfo.InvariantCulture);
    }

    [GeneratedRegex(
        @"^ *(?<step>\d+)  (?<link>\S+( \S+)?) +(?<other>\S+( \S+)?) +(?<distance>\S+)  \((?<a>.*?)\) +\((?<b>.*?)\)")]
    private static partial Regex Columns();
}
