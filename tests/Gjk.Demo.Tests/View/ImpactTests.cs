using System.Text.RegularExpressions;

namespace Gjk.Demo.Tests.View;

/// <summary>Tests what a page and a picture say of moving objects: their paths, and where they first touch.</summary>
public sealed class ImpactTests
{
    private const string Box = "\"shape\":{\"type\":\"box\",\"halfExtents\":[1,1,1]}", Impact = "#ffb86b";

    private const string Comes = $"{{{Box},\"position\":[6,0.5,0],\"velocity\":[-8,0,0]}}";

    private const string Passes = $"{{{Box},\"position\":[6,4,0],\"velocity\":[-8,0,0]}}";

    /// <summary>The second box meets the first after half of the way, and the third never does.</summary>
    [Fact]
    public void PairsThatMeetHaveAnEntry()
    {
        PageText page = View($"{{{Box}}},{Comes},{Passes}", out string svg);
        Assert.Equal([0], page.Column<int>("castIndices"));
        float[] entry = page.Column<float>("casts");
        Assert.Equal(0.5f, entry[0]);
        Assert.Equal(1, entry[1]);
        Assert.InRange(entry[2], -0.5f, 1);
        Assert.Equal([1, 0, 0], entry[4..]);
        Assert.Equal([0, 0, 0, -8, 0, 0, -8, 0, 0], page.Column<float>("velocities"));

        Assert.Equal(2, Regex.Match(svg, $"stroke=\"{Impact}\"[^>]*stroke-dasharray[^>]*d=\"([^\"]*)\"")
            .Groups[1].Value.Count(c => c is 'M' or 'm'));
        Assert.Contains("#0 – #1: meet after 0.5 of the frame", System.Net.WebUtility.HtmlDecode(svg));
        Assert.Single(Regex.Matches(svg, $"<circle [^>]*fill=\"{Impact}\""));
        PictureTests.AssertSound(svg);
    }

    /// <summary>In the second frame the box is half of a way nearer, and in the third they overlap.</summary>
    [Fact]
    public void TheyFollowTheFrames()
    {
        string slower = Comes.Replace("[-8,0,0]", "[-2,0,0]");
        PageText page = View($"{{{Box}}},{slower}", out _, "\"frames\":4,");
        Assert.Equal([1, 2], page.Column<int>("castIndices"));
        Assert.Equal(1, page.Column<float>("casts")[0]);
        Assert.Equal([0, 0, 1, 1], page.Column<int>("overlapping"));
    }

    [Theory]
    [InlineData("")]
    [InlineData(",\"velocity\":[-8,0,0],\"angularVelocity\":[0,0,1]")]
    public void WhatRestsOrTurnsHasNone(string motion)
    {
        PageText page = View($"{{{Box}}},{{{Box},\"position\":[6,0,0]{motion}}}", out string svg);
        Assert.DoesNotContain("<circle", svg);
        if (motion.Length == 0)
        {
            Assert.DoesNotContain(Impact, svg);
            Assert.False(page.Data.TryGetProperty("velocities", out _));
            return;
        }

        Assert.Empty(page.Column<int>("castIndices"));
        Assert.Equal([0, 1], page.Column<byte>("turns"));
    }

    private static PageText View(string objects, out string svg, string frames = "")
    {
        using var directory = new TempDirectory();
        string scene = directory.Write("scene.json", $"{{\"version\":1,{frames}\"objects\":[{objects}]}}");
        DemoRun run = DemoRun.Of(
            "view", scene, "--out", directory.File("a.html"), "--svg", directory.File("a.svg"));
        run.AssertDone();
        svg = File.ReadAllText(directory.File("a.svg"));
        return new PageText(directory.File("a.html"));
    }
}
