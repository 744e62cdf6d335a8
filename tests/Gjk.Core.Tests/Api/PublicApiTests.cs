using System;
using System.IO;

namespace Gjk.Core.Tests.Api;

/// <summary>The public surface is what PublicApi.txt says: a change to it must be meant.</summary>
public class PublicApiTests
{
    private const string UpdateVariable = "GJK_UPDATE_API";

    [Fact]
    public void TheSurfaceIsTheSnapshot()
    {
        // One snapshot, of the modern build; that the others have no member less is the package validation's to say.
        if (!BuildUnderTest.IsModern) return;
        string actual = ApiText.Of(BuildUnderTest.Library);
        if (Environment.GetEnvironmentVariable(UpdateVariable) == "1")
        {
            File.WriteAllText(SnapshotPath(), actual);
            return;
        }

        using Stream stream = typeof(PublicApiTests).Assembly.GetManifestResourceStream("PublicApi.txt")!;
        using var reader = new StreamReader(stream);
        string snapshot = reader.ReadToEnd().Replace("\r", "");
        Assert.True(
            snapshot == actual,
            $"The public surface differs from PublicApi.txt: {FirstDifference(snapshot, actual)}\nIf the change "
            + $"is meant: run the tests once with {UpdateVariable}=1, build again, and read the diff.");
    }

    [Fact]
    public void NoNameClashesWithUnitys() =>
        Assert.All(
            ["Collider", "BoxCollider", "MeshCollider", "Ray", "Plane", "Pose", "Bounds", "Transform"],
            name => Assert.Null(BuildUnderTest.Library.GetType("Gjk.Core." + name)));

    [Fact]
    public void EveryPublicTypeLivesInTheOneNamespace() =>
        Assert.All(BuildUnderTest.Library.GetExportedTypes(), t => Assert.Equal("Gjk.Core", t.Namespace));

    private static string FirstDifference(string snapshot, string actual)
    {
        string[] old = snapshot.Split('\n'), now = actual.Split('\n');
        for (int i = 0; i < Math.Max(old.Length, now.Length); i++)
        {
            string was = i < old.Length ? old[i] : "(end)", isNow = i < now.Length ? now[i] : "(end)";
            if (was != isNow) return $"line {i + 1} was '{was}', is '{isNow}'";
        }

        return "line ends only";
    }

    /// <summary>In the sources: up from the output to the folder that holds the solution.</summary>
    private static string SnapshotPath()
    {
        string folder = AppContext.BaseDirectory;
        while (!File.Exists(Path.Combine(folder, "Gjk.sln")))
            folder = Path.GetDirectoryName(folder) ?? throw new FileNotFoundException("Gjk.sln");
        return Path.Combine(folder, "tests", "Gjk.Core.Tests", "PublicApi.txt");
    }
}
