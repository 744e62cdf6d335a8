using Gjk.Core.Tests.BroadPhase;

namespace Gjk.Core.Tests.Regression;

/// <summary>A tree that grew by a few objects at a time was as deep as it had leaves where surfaces say nothing: points
/// on a line, identical and nested boxes, boxes whose surface is infinite.</summary>
public class DeepTreeTests
{
    private const int Objects = 2000;

    /// <summary>Objects added between two questions: few enough to be inserted one by one.</summary>
    private const int Step = 30;

    public static TheoryData<string> Kinds => [.. WorstBoxes.Deep];

    [Theory]
    [MemberData(nameof(Kinds))]
    public void ItIsNeverDeep(string kind)
    {
        var boxes = new WorstBoxes(kind, Objects, 5);
        var phase = new DynamicAabbTree();
        AabbTree tree = phase.Leaves.Tree;
        List<int> ids = [];
        int deepest = 0;
        for (int i = 0; i < Objects; i++)
        {
            phase.Add(i, boxes.Box(i));
            if (i % Step != 0) continue;
            phase.CollectInBox(default, ids);
            if (i % (10 * Step) == 0) deepest = Math.Max(deepest, TreeDepth.Of(tree));
        }

        // The same by motion: each object is taken out and put back.
        for (int i = 0; i < Objects; i++)
        {
            phase.Move(i, new Aabb(new Vector3(-1e6f), new Vector3(-1e6f)));
            if (i % 2 == 0) phase.CollectInBox(default, ids);
            phase.Move(i, boxes.Box(i));
            if (i % Step != 0) continue;
            phase.CollectInBox(default, ids);
            if (i % (10 * Step) == 0) deepest = Math.Max(deepest, TreeDepth.Of(tree));
        }

        Assert.InRange(deepest, 10, AabbTree.MaxDepth);
        phase.CollectInBox(new Aabb(new Vector3(-float.MaxValue), new Vector3(float.MaxValue)), ids);
        Assert.Equal(Objects, ids.Count);
    }

    /// <summary>A built tree leaves room for insertions below its leaves.</summary>
    [Fact]
    public void ABuiltTreeIsHalfAsDeepAtMost()
    {
        var phase = new DynamicAabbTree();
        for (int i = 0; i < Objects; i++)
        {
            // 280 points on the powers of two along each axis, and all others between the last of them.
            float at = (float)Math.Pow(2, i < 840 ? 127 - i / 3 : -149);
            phase.Add(i, PointAt(i % 3 == 0 ? at : 0, i % 3 == 1 ? at : 0, i % 3 == 2 ? at : 0));
        }

        phase.CollectPairs(0, []);
        Assert.InRange(TreeDepth.Of(phase.Leaves.Tree), 30, AabbTree.MaxDepth / 2);
    }

    private static Aabb PointAt(float x, float y, float z) => new(new Vector3(x, y, z), new Vector3(x, y, z));
}
