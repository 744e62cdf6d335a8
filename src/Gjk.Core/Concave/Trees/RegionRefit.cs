namespace Gjk.Core;

/// <summary>Fits a tree, in place, to parts that have moved within a region. The rest of the tree stays.</summary>
/// <remarks>A leaf's box is measured from its parts. A box above is measured from the boxes below it, along its old
/// axes: no part outside the region is read, and the box is a little larger than its parts. Boxes change the speed, not
/// the answer. Allocates nothing.</remarks>
internal sealed class RegionRefit
{
    /// <summary>Ratio of the radius to the tree's unit, below 2 in a new tree. If parts grow beyond it, the frame and
    /// all boxes are made anew, at most once for each doubling. More only costs precision of the boxes'
    /// floats.</summary>
    private const double MostGrown = 4;

    private readonly IPartSource _source;
    private readonly PartTree _tree;
    private readonly PartItem[] _items = new PartItem[PartTree.Lanes - 1];
    private readonly BoxFit _fit;
    private PartBox _region;

    /// <param name="source">The parts.</param>
    /// <param name="tree">The tree of the parts; it is changed.</param>
    public RegionRefit(IPartSource source, PartTree tree)
    {
        (_source, _tree) = (source, tree);
        _fit = new BoxFit(source, _items, tree);
    }

    /// <summary>Fits the boxes that may hold a part in a region, before or after it has moved.</summary>
    /// <param name="region">In the shape's frame.</param>
    /// <param name="moved">A box of the points that have moved, at their new places.</param>
    public void Fit(in PartBox region, in PartBox moved)
    {
        double radius = _fit.RadiusTo(moved);
        if (radius > MostGrown * _fit.Unit)
        {
            FitAll();
            return;
        }

        _fit.Widen(radius);
        _fit.WriteFrame(_tree);
        _region = _fit.Local(region);
        RefitBox(0);
    }

    /// <summary>Fits the frame and all boxes; the form of the tree stays.</summary>
    public void FitAll()
    {
        _fit.SetFrame(PartBox.Around(_source));
        _fit.WriteFrame(_tree);
        _region = PartBox.Everything;
        RefitBox(0);
    }

    /// <summary>Writes a lane's box, after those below it, if it may hold a part of the region.</summary>
    /// <param name="box">A node times <see cref="PartTree.Lanes"/>, and its lane.</param>
    private void RefitBox(int box)
    {
        int child = _tree.Children[box], at = PartTree.At(box);
        if (child == PartTree.Empty || !MeetsRegion(at)) return;
        if (child < 0) Measure(PartTree.FirstOf(child), PartTree.CountOf(child));
        else
        {
            for (int i = 0; i < PartTree.Lanes; i++) RefitBox(PartTree.Lanes * child + i);
            Surround(child, at);
        }

        _fit.Write(_tree.Boxes, at);
    }

    private bool MeetsRegion(int at)
    {
        Double3 center = _tree.Read(at), reach = _tree.ReachOf(at);
        Double3 low = center - reach, high = center + reach;
        return low.X <= _region.MaxX && low.Y <= _region.MaxY && low.Z <= _region.MaxZ
            && high.X >= _region.MinX && high.Y >= _region.MinY && high.Z >= _region.MinZ;
    }

    private void Measure(int first, int count)
    {
        for (int i = 0; i < count; i++) _items[i] = new PartItem(_source, _tree.Order[first + i]);
        _fit.ToFrame(count);
        _fit.Measure(0, count);
    }

    /// <summary>Measures the boxes of a node along the axes of the box around them.</summary>
    private void Surround(int node, int at)
    {
        Double3 u = _tree.Read(at + PartTree.Axes), v = _tree.Read(at + PartTree.Axes + 3 * PartTree.Lanes);
        Double3 w = _tree.Read(at + PartTree.Axes + 6 * PartTree.Lanes);
        PartBox box = PartBox.Nothing;
        for (int i = PartTree.Lanes * node; i < PartTree.Lanes * (node + 1); i++)
        {
            if (_tree.Children[i] == PartTree.Empty) continue;
            Double3 center = BoxFit.Along(_tree.Read(PartTree.At(i)), u, v, w);
            Double3 reach = _tree.ReachOf(PartTree.At(i), u, v, w);
            box.Add(new PartBox(center - reach, center + reach));
        }

        _fit.SetBox(u, v, w, box);
    }
}
