using Gjk.Demo.View;

namespace Gjk.Demo.Tests.View;

/// <summary>Tests the contact points of a page: an entry for each overlapping pair, and four numbers for each
/// point.</summary>
public sealed class ContactPointTests
{
    private const string Box = "\"shape\":{\"type\":\"box\",\"halfExtents\":[1,1,1]}";

    /// <summary>Two boxes reach 0.5 into each other, two only touch, and the pair that is apart has no entry.</summary>
    [Fact]
    public void OverlappingAndTouchingPairsHaveThem()
    {
        PageText page = View($"{{{Box}}},{{{Box},\"position\":[1.5,0.25,0]}},{{{Box},\"position\":[-2,0,0]}}");
        Assert.Equal([4, 4], page.Column<byte>("contactCounts"));
        float[] points = page.Column<float>("contactPoints");
        Assert.Equal(
            [(1, -0.75f, -1, -0.5f), (1, -0.75f, 1, -0.5f), (1, 1, -1, -0.5f), (1, 1, 1, -0.5f)],
            Sorted(points.AsSpan(0, 16)));
        Assert.Equal([(-1, -1, -1, 0), (-1, -1, 1, 0), (-1, 1, -1, 0), (-1, 1, 1, 0)], Sorted(points.AsSpan(16)));
    }

    [Fact]
    public void TheyFollowTheFrames()
    {
        PageText page = View(
            $"{{{Box}}},{{{Box},\"position\":[3,0,0],\"velocity\":[-0.75,0,0]}}", "\"frames\":4,");
        Assert.Equal([0, 0, 1, 1], page.Column<int>("overlapping"));
        Assert.Equal([4, 4], page.Column<byte>("contactCounts"));
        float[] gaps = [.. page.Column<float>("contactPoints").Where((_, i) => i % 4 == 3)];
        Assert.Equal([-0.5f, -0.5f, -0.5f, -0.5f, -1.25f, -1.25f, -1.25f, -1.25f], gaps);
    }

    /// <summary>A gap may be a hundredth of the smaller radius, which is √3 here. A wider one is open.</summary>
    [Theory]
    [InlineData(0.4, 4)]
    [InlineData(2, 2)]
    public void ATiltedBoxLosesThePointsThatAreOpen(double degrees, int count)
    {
        (double sin, double cos) = Math.SinCos(degrees / 2 * Math.PI / 180);
        FormattableString tilted = $"{{{Box},\"position\":[2,0,0],\"rotation\":[0,0,{sin:R},{cos:R}]}}";
        PageText page = View($"{{{Box}}},{FormattableString.Invariant(tilted)}");
        Assert.Equal([(byte)count], page.Column<byte>("contactCounts"));
        float[] gaps = [.. page.Column<float>("contactPoints").Where((_, i) => i % 4 == 3)];
        Assert.Equal(page.Column<float>("distance")[0], gaps.Min(), 1e-6f);
        Assert.Equal(count == 4, gaps.Max() > 0);
    }

    [Fact]
    public void PointsBeyondWhatAPageHoldsAreLeftOut()
    {
        ContactManifold manifold = default;
        var box = new BoxShape(Vector3.One);
        ConvexQuery.Contacts(box, RigidPose.Identity, box, new RigidPose(Vector3.UnitX), 0, out manifold);
        Assert.Equal(4, manifold.Count);
        var contacts = new SceneContacts();
        for (int pair = 0; pair <= 250_000; pair++) contacts.Add(manifold);
        Assert.Equal(4, contacts.Counts[^2]);
        Assert.Equal(SceneContacts.LeftOut, contacts.Counts[^1]);
        Assert.Equal(1_000_000 * SceneContacts.PointSize, contacts.Points.Length);
    }

    private static PageText View(string objects, string frames = "")
    {
        using var directory = new TempDirectory();
        string scene = directory.Write("scene.json", $"{{\"version\":1,{frames}\"objects\":[{objects}]}}");
        DemoRun.Of("view", scene, "--out", directory.File("a.html")).AssertDone();
        return new PageText(directory.File("a.html"));
    }

    private static (float X, float Y, float Z, float Gap)[] Sorted(ReadOnlySpan<float> points)
    {
        var result = new (float, float, float, float)[points.Length / 4];
        for (int i = 0; i < result.Length; i++)
            result[i] = (points[4 * i], points[4 * i + 1], points[4 * i + 2], points[4 * i + 3]);
        Array.Sort(result);
        return result;
    }
}
