namespace Gjk.Core.Tests.Support;

/// <summary>How deep a tree of boxes is.</summary>
internal static class TreeDepth
{
    /// <summary>The number of levels below the root.</summary>
    public static int Of(AabbTree tree)
    {
        var waiting = new Stack<(int Node, int Level)>();
        if (tree.Root >= 0) waiting.Push((tree.Root, 0));
        int deepest = 0;
        while (waiting.TryPop(out (int Node, int Level) at))
        {
            deepest = Math.Max(deepest, at.Level);
            if (at.Node < tree.Capacity) continue;
            AabbNode box = tree.Node(at.Node);
            waiting.Push((box.Left, at.Level + 1));
            waiting.Push((box.Right, at.Level + 1));
        }

        return deepest;
    }
}
