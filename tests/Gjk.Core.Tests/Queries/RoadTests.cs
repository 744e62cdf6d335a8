using System.Diagnostics;
using Gjk.Core.Tests.Support;

namespace Gjk.Core.Tests.Queries;

/// <summary>The road of a query, from the verb down to the loop, is short and has no way back. A support of the test
/// walks the stack that it is asked on.</summary>
public class RoadTests
{
    /// <summary>Frames from the verb to what asks a core for its support, both included, without any inlining: seven to
    /// the loop, two from there.</summary>
    private const int MostFrames = 9;

    /// <summary>The types on the road, each in the file of its name, top to bottom.</summary>
    private static readonly string[] Road =
    [
        "ConvexQuery", "PairQuery", "DistanceSolver", "ProvedDistance", "GjkDistance", "MinkowskiDifference",
        "XyzSupport",
    ];

    [Fact]
    public void ADistanceGoesDownTheRoadAndNeverBack()
    {
        var stacks = new List<string[]>();
        var probe = new Probe(stacks);
        DistanceResult result = ConvexQuery.Distance(
            probe, RigidPose.Identity, probe, new RigidPose(new Vector3(3, 0.4f, 0.2f)));
        Assert.Equal(GjkStatus.Separated, result.Status);
        Assert.True(stacks.Count >= 4, $"only {stacks.Count} supports");
        foreach (string[] types in stacks)
        {
            string message = string.Join(" < ", types);
            Assert.True(types.Length is > 2 and <= MostFrames, message);
            Assert.Contains("GjkDistance", types);
            int place = 0;
            foreach (string type in types.Reverse())
            {
                int next = Array.IndexOf(Road, type);
                Assert.True(next >= place, message);
                place = next;
            }
        }
    }

    [Fact]
    public void TheGuideForContributorsDrawsTheRoadInOrder()
    {
        string guide = File.ReadAllText(Path.Combine(ProjectFolder.Root, "CONTRIBUTING.md"));
        int begin = guide.IndexOf("Queries/ConvexQuery.Distance.cs", StringComparison.Ordinal);
        Assert.True(begin >= 0, "there is no road");
        foreach (string type in Road)
        {
            string file = type == "ConvexQuery" ? "ConvexQuery.Distance.cs" : type + ".cs";
            int next = guide.IndexOf("/" + file, begin, StringComparison.Ordinal);
            Assert.True(next >= begin, file);
            Assert.Single(ProjectFolder.Sources("src/Gjk.Core"), f => Path.GetFileName(f) == file);
            begin = next;
        }
    }

    /// <summary>A cube that notes the types below its caller, down to the verb.</summary>
    private readonly struct Probe(List<string[]> stacks) : ISupportMap
    {
        public Double3 Center => default;

        public double Margin => 0;

        public double BoundingRadius => 1.8;

        public int Support(in Double3 direction, out Double3 point)
        {
            string[] all =
            [
                .. new StackTrace(1).GetFrames().Select(f => f.GetMethod()?.DeclaringType)
                    .Select(t => t?.Name.Split('`')[0] ?? "").SkipWhile(t => t == nameof(Probe))
                    .TakeWhile(t => t != nameof(RoadTests)),
            ];
            stacks.Add(all);
            point = new Double3(direction.X < 0 ? -1 : 1, direction.Y < 0 ? -1 : 1, direction.Z < 0 ? -1 : 1);
            return (direction.X < 0 ? 1 : 0) + (direction.Y < 0 ? 2 : 0) + (direction.Z < 0 ? 4 : 0);
        }

        public void GetFace(in Double3 direction, ref FaceCorners corners)
        {
        }

        public bool TryGetVertex(int id, out Double3 point)
        {
            point = new Double3((id & 1) != 0 ? -1 : 1, (id & 2) != 0 ? -1 : 1, (id & 4) != 0 ? -1 : 1);
            return true;
        }
    }
}
