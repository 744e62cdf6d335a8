namespace Gjk.Core;

/// <summary>Fits a tree, in place, to parts that have moved within a region; the rest of it stays as it is.</summary>
/// <remarks>The box of a leaf is measured from its parts. A box above is measured from the boxes below it, along the
/// axes that it has: that asks no part outside the region, and makes it a little larger than its parts. Boxes change
/// how fast an answer is found, not what it is. Allocates nothing.</remarks>
internal sealed class RegionRefit
{
    /// <summary>Ratio of the radius to the tree's unit, below 2 in a new tree: where parts grow beyond it, the frame
    /// and all boxes are made anew, at most once for each doubling. More only takes bits of the boxes'
    /// floats.</summary>
    private const double MostGrown = 4;

    private readonly IPartSource _source;
    private readonly PartTree _tree;
    private readonly PartItem[] _items = new PartItem[PartTree.Lanes - 1];
    private readonly BoxFit _fit;
    private PartBox _region;

    /// <param name="source">The parts.</param>
    /// <param name="tree">Theirs; it is changed.</param>
    public RegionRefit(IPartSource source, PartTree tree)
    {
        (_source, _tree) = (source, tree);
        _fit = new BoxFit(source, _items, tree);
    }

    /// <summary>Fits what may hold a part that lies in a region, before or after it has moved.</summary>
    /// <param name="region">In the shape's frame.</param>
    /// <param name="moved">Holds the points that have moved, where they are now.</param>
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
        Place(0);
    }

    /// <summary>Fits the frame and all boxes, as far as a tree of this form can be.</summary>
    public void FitAll()
    {
        _fit.SetFrame(PartBox.Of(_source));
        _fit.WriteFrame(_tree);
        _region = PartBox.Everything;
        Place(0);
    }

    /// <summary>Writes a lane's box, after those below it, if it may hold a part of the region.</summary>
    /// <param name="box">A node times <see cref="PartTree.Lanes"/>, and its lane.</param>
    private void Place(int box)
    {
        int child = _tree.Children[box], at = PartTree.At(box);
        if (child == PartTree.Empty || !MeetsRegion(at)) return;
        if (child < 0) Measure(PartTree.FirstOf(child), PartTree.CountOf(child));
        else
        {
            for (int i = 0; i < PartTree.Lanes; i++) Place(PartTree.Lanes * child + i);
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

        _fit.Set(u, v, w, box);
    }
}
