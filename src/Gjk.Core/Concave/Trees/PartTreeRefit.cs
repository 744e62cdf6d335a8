namespace Gjk.Core;

/// <summary>Fits a tree to parts that have moved: the same leaves and nodes, with new boxes.</summary>
internal static class PartTreeRefit
{
    /// <summary>A tree of the same form as another.</summary>
    public static PartTree Fit(IPartSource source, PartTree like)
    {
        var fit = new BoxFit(source, new PartItem[like.Order.Length], like.Order);
        var tree = new PartTree((float[])like.Boxes.Clone(), like.Children, like.Order);
        fit.WriteFrame(tree);
        RefitBox(fit, tree, 0, out _, out _);
        return tree;
    }

    /// <summary>Writes a box after those below it, and returns the range of its parts.</summary>
    private static void RefitBox(BoxFit fit, PartTree tree, int box, out int begin, out int end)
    {
        int child = tree.Children[box];
        (begin, end) = (int.MaxValue, 0);
        if (child < 0) (begin, end) = (PartTree.FirstOf(child), PartTree.FirstOf(child) + PartTree.CountOf(child));
        for (int i = PartTree.Lanes * child; child >= 0 && i < PartTree.Lanes * (child + 1); i++)
        {
            if (tree.Children[i] == PartTree.Empty) continue;
            RefitBox(fit, tree, i, out int first, out int last);
            (begin, end) = (Math.Min(begin, first), Math.Max(end, last));
        }

        fit.Measure(begin, end);
        fit.Write(tree.Boxes, PartTree.At(box));
    }
}
