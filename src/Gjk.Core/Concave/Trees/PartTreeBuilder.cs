namespace Gjk.Core;

/// <summary>Builds a <see cref="PartTree"/> from the top: a range of parts is halved, the one with the largest surface
/// times count first, until a node has eight. A cut is where surface times count is least, of 16 bins along the longest
/// axis of the middles (Wald, "On fast construction of SAH-based bounding volume hierarchies", 2007).</summary>
/// <remarks>Cost: each level looks at each part a few times. Bins say nothing about equal middles, and about some
/// sequences split off one part at a time; below <see cref="MostUneven"/> levels ranges are halved by their count, so
/// that the depth is at most that and the logarithm of the count. Everything that decides is double, so that the tree
/// is the same on every target.</remarks>
internal sealed class PartTreeBuilder
{
    private const int Bins = 16;

    /// <summary>Levels: a tree of a billion parts that is cut in halves has ten. More only costs time.</summary>
    private const int MostUneven = 16;

    private readonly int _leafSize, _mostInLeaf;
    private readonly PartItem[] _items;
    private readonly int[] _binCounts = new int[Bins];
    private readonly PartBox[] _binBoxes = new PartBox[Bins];
    private readonly double[] _binCosts = new double[Bins];
    private readonly BoxFit _fit;
    private float[] _boxes;
    private int[] _children;
    private int _nodes;

    private PartTreeBuilder(IPartSource source, int leafSize, int mostInLeaf)
    {
        (_leafSize, _mostInLeaf) = (leafSize, mostInLeaf);
        int count = source.Count;
        _items = new PartItem[count];
        PartBox all = PartBox.Nothing;
        for (int i = 0; i < count; i++)
        {
            source.GetBox(i, out Double3 min, out Double3 max);
            _items[i] = new PartItem { Box = new PartBox(min, max), Part = i };
            all.Add(_items[i].Box);
        }

        _fit = new BoxFit(source, _items, all);
        int room = Math.Max(2, count / (2 * leafSize));
        _boxes = new float[room * PartTree.Stride];
        _children = new int[room * PartTree.Lanes];
    }

    /// <param name="source">The parts.</param>
    /// <param name="leafSize">Ranges of no more parts are not cut.</param>
    /// <param name="mostInLeaf">Nor become ranges of no more parts a node of their own; below 8.</param>
    public static PartTree Build(IPartSource source, int leafSize, int mostInLeaf)
    {
        var builder = new PartTreeBuilder(source, leafSize, mostInLeaf);
        int root = builder.NewNode();
        builder.Place(root, 0, 0, builder._items.Length, 1);
        Array.Resize(ref builder._boxes, builder._nodes * PartTree.Stride);
        Array.Resize(ref builder._children, builder._nodes * PartTree.Lanes);
        int[] order = Array.ConvertAll(builder._items, item => item.Part);
        var tree = new PartTree(builder._boxes, builder._children, order);
        builder._fit.WriteFrame(tree);
        return tree;
    }

    private int NewNode()
    {
        if ((_nodes + 1) * PartTree.Stride > _boxes.Length)
        {
            Array.Resize(ref _boxes, 2 * _boxes.Length);
            Array.Resize(ref _children, 2 * _children.Length);
        }

        for (int i = 0; i < PartTree.Lanes; i++)
        {
            _children[_nodes * PartTree.Lanes + i] = PartTree.Empty;
            for (int axis = 0; axis < 3; axis++)
                _boxes[_nodes * PartTree.Stride + PartTree.Axes + 4 * axis * PartTree.Lanes + i] = 1;
        }

        return _nodes++;
    }

    /// <summary>Writes a lane: the box of a range, and what is below it.</summary>
    private void Place(int node, int lane, int begin, int end, int depth)
    {
        int child = end - begin <= _mostInLeaf ? PartTree.Leaf(begin, end - begin) : Split(begin, end, depth);
        _fit.Measure(begin, end);
        _fit.Write(_boxes, node * PartTree.Stride + lane);
        _children[node * PartTree.Lanes + lane] = child;
    }

    /// <summary>A node over a range, which is cut until there are eight parts of it, or until what is left fills a node
    /// each: a node with few boxes takes as much memory as a full one.</summary>
    private int Split(int begin, int end, int depth)
    {
        int[] starts = new int[PartTree.Lanes], ends = new int[PartTree.Lanes];
        double[] weights = new double[PartTree.Lanes];
        int ranges = 1;
        (starts[0], ends[0]) = (begin, end);
        bool isLast = end - begin <= PartTree.Lanes * _mostInLeaf;
        int least = isLast ? _leafSize : PartTree.Lanes * _leafSize;
        while (ranges < PartTree.Lanes)
        {
            int best = -1;
            for (int i = 0; i < ranges; i++)
                if (ends[i] - starts[i] > least && (best < 0 || weights[i] > weights[best])) best = i;
            if (best < 0) break;
            int middle = Partition(starts[best], ends[best], depth > MostUneven);
            (starts[ranges], ends[ranges], ends[best]) = (middle, ends[best], middle);
            weights[best] = Weight(starts[best], middle);
            weights[ranges] = Weight(middle, ends[ranges]);
            ranges++;
        }

        int node = NewNode();
        for (int i = 0; i < ranges; i++) Place(node, i, starts[i], ends[i], depth + 1);
        return node;
    }

    private double Weight(int begin, int end)
    {
        PartBox box = PartBox.Nothing;
        for (int i = begin; i < end; i++) box.Add(_items[i].Box);
        return box.Area * (end - begin);
    }

    /// <summary>Puts the parts on one side of the best cut first; gives where the others begin.</summary>
    private int Partition(int begin, int end, bool isDeep)
    {
        int middle = begin + (end - begin) / 2;
        int axis = LongestAxis(begin, end, out double low, out double length);
        double scale = Bins * 0.9999 / length;
        if (isDeep || !(length > 0) || !Guard.IsFinite(scale)) return middle;
        int cut = BestCut(begin, end, axis, low, scale);
        if (cut < 0) return middle;
        int left = begin, right = end - 1;
        while (left <= right)
        {
            if ((int)((_items[left].Box.Middle(axis) - low) * scale) <= cut)
            {
                left++;
                continue;
            }

            (_items[left], _items[right]) = (_items[right], _items[left]);
            right--;
        }

        return left;
    }

    private int LongestAxis(int begin, int end, out double low, out double length)
    {
        int best = 0;
        (low, length) = (0, -1);
        for (int axis = 0; axis < 3; axis++)
        {
            double min = _items[begin].Box.Middle(axis), max = min;
            for (int i = begin + 1; i < end; i++)
            {
                double x = _items[i].Box.Middle(axis);
                if (x < min) min = x;
                if (x > max) max = x;
            }

            if (max - min > length) (best, low, length) = (axis, min, max - min);
        }

        return best;
    }

    /// <summary>The last bin of the left side; -1 where all parts are in one bin.</summary>
    private int BestCut(int begin, int end, int axis, double low, double scale)
    {
        for (int i = 0; i < Bins; i++) (_binCounts[i], _binBoxes[i]) = (0, PartBox.Nothing);
        for (int i = begin; i < end; i++)
        {
            int bin = (int)((_items[i].Box.Middle(axis) - low) * scale);
            _binCounts[bin]++;
            _binBoxes[bin].Add(_items[i].Box);
        }

        PartBox box = PartBox.Nothing;
        int sum = 0;
        for (int i = Bins - 1; i > 0; i--)
        {
            box.Add(_binBoxes[i]);
            sum += _binCounts[i];
            _binCosts[i] = sum == 0 ? 0 : box.Area * sum;
        }

        box = PartBox.Nothing;
        (int cut, double least) = (-1, double.PositiveInfinity);
        sum = 0;
        for (int i = 0; i < Bins - 1; i++)
        {
            box.Add(_binBoxes[i]);
            sum += _binCounts[i];
            if (sum == 0 || sum == end - begin) continue;
            double cost = box.Area * sum + _binCosts[i + 1];
            if (cut < 0 || cost < least) (least, cut) = (cost, i);
        }

        return cut;
    }
}
