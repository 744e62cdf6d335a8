namespace Gjk.Core;

/// <summary>Fits a tree to parts that have moved: the same leaves and nodes, with new boxes.</summary>
internal sealed class PartTreeRefit
{
    private readonly PartTree _tree;
    private readonly BoxFit _fit;

    private PartTreeRefit(IPartSource source, PartTree like)
    {
        _fit = new BoxFit(source, new PartItem[like.Order.Length], like.Order);
        _tree = new PartTree((float[])like.Boxes.Clone(), like.Children, like.Order);
        _fit.WriteFrame(_tree);
    }

    /// <summary>A tree of the same form as another.</summary>
    /// <param name="source">The parts, as many as the other's.</param>
    /// <param name="like">The other tree, which stays as it is.</param>
    public static PartTree Fit(IPartSource source, PartTree like)
    {
        var refit = new PartTreeRefit(source, like);
        refit.Place(0, 0, out _, out _);
        return refit._tree;
    }

    /// <summary>Writes a lane's box, after those below it, and gives the range of its parts.</summary>
    private void Place(int node, int lane, out int begin, out int end)
    {
        int child = _tree.Children[node * PartTree.Lanes + lane];
        if (child < 0)
        {
            begin = PartTree.FirstOf(child);
            end = begin + PartTree.CountOf(child);
        }
        else
        {
            (begin, end) = (int.MaxValue, 0);
            for (int i = 0; i < PartTree.Lanes; i++)
            {
                if (_tree.Children[child * PartTree.Lanes + i] == PartTree.Empty) continue;
                Place(child, i, out int first, out int last);
                begin = Math.Min(begin, first);
                end = Math.Max(end, last);
            }
        }

        _fit.Measure(begin, end);
        _fit.Write(_tree.Boxes, node * PartTree.Stride + lane);
    }
}
