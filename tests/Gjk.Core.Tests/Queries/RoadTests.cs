using System.Diagnostics;
using System.Reflection;
using Gjk.Core.Tests.Api;

namespace Gjk.Core.Tests.Queries;

/// <summary>The roads of the queries, from the verb down to the loop, are short and have no way back, and are drawn for
/// contributors. A shape or a trace of the test walks the stack that it is asked on.</summary>
public class RoadTests
{
    /// <summary>The types on each road, top to bottom, each in the file of its name.</summary>
    private static readonly string[] Pair =
    [
        "ConvexQuery", "PairQuery", "DistanceSolver", "GjkDistance", "MinkowskiDifference", "XyzSupport",
    ];

    private static readonly string[] Parts = ["ConcaveQuery", "PartPairSearch", "PartQuery"];

    private static readonly string[] Scene = ["CollisionScene", "Workers", "SceneDistanceJob"];

    private static readonly RigidPose Away = new(new Vector3(4, 0.4f, 0.2f));

    private static readonly Vector3[] Corners = [default, Vector3.UnitX, Vector3.UnitY, Vector3.UnitZ];

    /// <summary>Frames from the verb to what asks a core for its support, both included, without any inlining: six to
    /// the loop, two from there.</summary>
    [Fact]
    public void ADistanceGoesDownTheRoadAndNeverBack()
    {
        var stacks = new List<MethodBase[]>();
        var probe = new Probe(stacks);
        DistanceResult result = ConvexQuery.Distance(probe, RigidPose.Identity, probe, Away);
        Assert.Equal(GjkStatus.Separated, result.Status);
        Hold(stacks, 8, Pair);
    }

    /// <summary>What is unwrapped to cores has two frames more, of which compilers that optimize leave none.</summary>
    [Fact]
    public unsafe void ADistanceOfHullsGoesBySolveCores()
    {
        var stacks = new List<MethodBase[]>();
        ConvexShape hull = ConvexShape.Mesh(Corners);
        var solver = new DistanceSolver<Walker>(float.PositiveInfinity) { Trace = new Walker(stacks) };
        PairQuery.Run(hull, RigidPose.Identity, hull, Away, ref solver, out DistanceResult result);
        Assert.Equal(GjkStatus.Separated, result.Status);
        Hold(stacks, 8, Pair);
        Assert.All(stacks, stack => Assert.Contains(stack, method => method.Name == "SolveCores"));
    }

    /// <summary>Seven frames from the verb to the loop. A triangle of a mesh has nothing that could walk the stack, so
    /// the calls are read. A point is asked by another verb, one frame above.</summary>
    [Theory]
    [InlineData(nameof(ConcaveQuery.Distance))]
    [InlineData(nameof(ConcaveQuery.SignedDistance))]
    public void ADistanceOfMeshesCallsTheLoopInSevenFrames(string verb)
    {
        (Type Type, string Method)[] road =
        [
            (typeof(ConcaveQuery), verb), (typeof(PartPairSearch), nameof(PartPairSearch.Run)),
            (typeof(PartPairSearch), "MeasureTriangles"), (typeof(PartQuery), nameof(PartQuery.TriangleDistance)),
            (typeof(PairQuery<,,,>), "Solve"), (typeof(DistanceSolver<>), "Gjk.Core.ICoreSolver.Solve"),
            (typeof(GjkDistance), nameof(GjkDistance.Solve)),
        ];
        const BindingFlags all = BindingFlags.Static | BindingFlags.Instance | BindingFlags.Public
            | BindingFlags.NonPublic;
        for (int i = 1; i < road.Length; i++)
        {
            MethodInfo[] callers = [.. road[i - 1].Type.GetMethods(all).Where(
                m => m.Name == road[i - 1].Method && m.GetParameters().All(p => p.ParameterType != typeof(Vector3)))];
            Assert.NotEmpty(callers);
            string next = $"{road[i].Type.Name}.{road[i].Method}".Replace("DistanceSolver`1.Gjk.Core.", "");
            Assert.All(callers, caller => Assert.Contains(
                IntermediateCode.Calls(caller), called => $"{called.DeclaringType!.Name}.{called.Name}" == next));
        }
    }

    [Fact]
    public void ADistanceOfCompoundsGoesDownToThatOfParts()
    {
        var stacks = new List<MethodBase[]>();
        PairDistance found = ConcaveQuery.Distance(
            Compound(stacks), RigidPose.Identity, Compound(stacks), Away, new ConcaveScratch());
        Assert.Equal(GjkStatus.Separated, found.Result.Status);
        Hold(stacks, 16, [.. Parts, .. Pair, "ConvexShape"]);
    }

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void AScenesPairsGoDownToThatOfShapesOrOfParts(bool isCompound)
    {
        var stacks = new List<MethodBase[]>();
        AnyShape shape = isCompound ? Compound(stacks) : AnyShape.Of(ConvexShape.Custom(new Probe(stacks)));
        var scene = new CollisionScene();
        scene.Add(shape, RigidPose.Identity);
        scene.Add(shape, Away);
        var pairs = new List<PairDistance>();
        stacks.Clear();
        scene.FindPairsWithin(9, pairs);
        Assert.Single(pairs);
        string[] below = isCompound ? ["ScenePartQueries", .. Parts] : ["WideBatch", "WideDistances"];
        Hold(stacks, 24, [.. Scene, .. below, .. Pair, "ConvexShape"]);
    }

    [Fact]
    public void TheGuideForContributorsDrawsTheRoadsInOrder()
    {
        string guide = File.ReadAllText(Path.Combine(ProjectFolder.Root, "CONTRIBUTING.md"));
        foreach ((string verb, string[] road) in new[]
        {
            ("Queries/ConvexQuery.Distance.cs", Pair), ("Concave/ConcaveQuery.cs", Parts),
            ("World/CollisionScene.Queries.cs", Scene),
        })
        {
            int begin = guide.IndexOf("\n" + verb, StringComparison.Ordinal);
            Assert.True(begin >= 0, $"there is no road from {verb}");
            int end = guide.IndexOf("```", begin, StringComparison.Ordinal);
            string[] drawn = [.. guide[begin..end].Split('\n').Select(line => line.Trim().Split(' ')[0])
                .Where(file => file.EndsWith(".cs", StringComparison.Ordinal))];
            Assert.All(drawn, file => Assert.True(
                File.Exists(Path.Combine(ProjectFolder.Root, "src", "Gjk.Core", file)), file));
            string[] types = [.. drawn.Select(file => Path.GetFileName(file).Split('.')[0])];
            Assert.Equal(road.Where(type => type != "SceneDistanceJob"), types.Where(road.Contains));
        }
    }

    [Fact]
    public void TheGuideForContributorsNamesAllThatAQueryIs()
    {
        string guide = File.ReadAllText(Path.Combine(ProjectFolder.Root, "CONTRIBUTING.md"));
        Assert.All(
            typeof(IPairSolver<>).GetMethods().Concat(typeof(ICoreSolver).GetMethods()),
            method => Assert.Contains($"`{method.Name}`", guide));
    }

    private static AnyShape Compound(List<MethodBase[]> stacks)
    {
        var probe = ConvexShape.Custom(new Probe(stacks));
        AnyShape compound = AnyShape.Of(new CompoundShape(
            [new CompoundPart(probe, RigidPose.Identity), new CompoundPart(probe, new RigidPose(-Vector3.UnitX))]));
        stacks.Clear();
        return compound;
    }

    private static void Hold(List<MethodBase[]> stacks, int mostFrames, string[] road)
    {
        Assert.True(stacks.Count >= 2, $"only {stacks.Count} supports");
        foreach (MethodBase[] stack in stacks)
        {
            string[] types = [.. stack.Select(NameOf)];
            string message = string.Join(" < ", types);
            Assert.True(types.Length is > 2 && types.Length <= mostFrames, message);
            Assert.Contains("GjkDistance", types);
            int place = 0;
            foreach (string type in types.Reverse())
            {
                int next = Array.IndexOf(road, type);
                Assert.True(next >= place, message);
                place = next;
            }
        }
    }

    private static void Note(List<MethodBase[]> stacks) => stacks.Add(
    [
        .. new StackTrace(2).GetFrames().Select(f => f.GetMethod()).OfType<MethodBase>()
            .SkipWhile(m => m.DeclaringType!.DeclaringType == typeof(RoadTests))
            .TakeWhile(m => m.DeclaringType != typeof(RoadTests)),
    ]);

    private static string NameOf(MethodBase method) => method.DeclaringType!.Name.Split('`')[0];

    /// <summary>A trace that notes the methods below its caller, down to the verb.</summary>
    private readonly struct Walker(List<MethodBase[]> stacks) : IGjkTrace
    {
        public bool IsOn => true;

        public void OnSupport(in TracedSupport support) => Note(stacks);

        public void OnReduced(in TracedSimplex simplex)
        {
        }
    }

    /// <summary>A cube that does the same.</summary>
    private readonly struct Probe(List<MethodBase[]> stacks) : ISupportMap
    {
        public Double3 Center => default;

        public double Margin => 0;

        public double BoundingRadius => 1.8;

        public int Support(in Double3 direction, out Double3 point)
        {
            Note(stacks);
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
