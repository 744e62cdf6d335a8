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

    /// <summary>Count: from so many parts on, what is below the root is built in branches, on several threads where
    /// there are some. The tree is the same. A matter of speed only.</summary>
    private const int LeastToShare = 4096;

    private readonly int _leafSize, _mostInLeaf;
    private readonly PartItem[] _items;
    private readonly int[] _binCounts = new int[Bins];
    private readonly PartBox[] _binBoxes = new PartBox[Bins];
    private readonly double[] _binCosts = new double[Bins];

    /// <summary>By level: eight ranges that a range was cut into.</summary>
    private readonly List<PartRange[]> _ranges = [];
    private readonly BoxFit _fit;
    private readonly Workers? _workers;
    private float[] _boxes = [];
    private int[] _children = [];
    private int _nodes;

    private PartTreeBuilder(IPartSource source, int leafSize, int mostInLeaf, Workers? workers)
    {
        (_leafSize, _mostInLeaf, _workers) = (leafSize, mostInLeaf, workers);
        int count = source.Count;
        _items = new PartItem[count];
        _fit = new BoxFit(source, _items);
        Reserve(count < LeastToShare ? count : 0);
    }

    /// <summary>Of a branch of another's tree, with nodes of its own.</summary>
    private PartTreeBuilder(PartTreeBuilder tree, int count)
    {
        (_leafSize, _mostInLeaf, _items) = (tree._leafSize, tree._mostInLeaf, tree._items);
        _fit = tree._fit.Copy();
        Reserve(count);
    }

    /// <param name="source">The parts.</param>
    /// <param name="leafSize">Ranges of no more parts are not cut.</param>
    /// <param name="mostInLeaf">Nor become ranges of no more parts a node of their own; below 8.</param>
    /// <param name="workers">The threads to use; null for the caller's own.</param>
    public static PartTree Build(IPartSource source, int leafSize, int mostInLeaf, Workers? workers = null)
    {
        var builder = new PartTreeBuilder(source, leafSize, mostInLeaf, workers);
        int root = builder.NewNode();
        builder.WriteLane(root, 0, PartRange.Over(builder._items, 0, builder._items.Length), 1);
        Array.Resize(ref builder._boxes, builder._nodes * PartTree.Stride);
        Array.Resize(ref builder._children, builder._nodes * PartTree.Lanes);
        int[] order = Array.ConvertAll(builder._items, item => item.Part);
        var tree = new PartTree(builder._boxes, builder._children, order);
        builder._fit.WriteFrame(tree);
        return tree;
    }

    private void Reserve(int count)
    {
        int room = Math.Max(2, count / (2 * _leafSize));
        _boxes = new float[room * PartTree.Stride];
        _children = new int[room * PartTree.Lanes];
    }

    private int NewNode()
    {
        if ((_nodes + 1) * PartTree.Stride > _boxes.Length)
        {
            Array.Resize(ref _boxes, 2 * _boxes.Length);
            Array.Resize(ref _children, 2 * _children.Length);
        }

        PartTree.WriteEmpty(_boxes, _children, _nodes);
        return _nodes++;
    }

    /// <summary>Writes a lane: the box of a range, and what is below it.</summary>
    private void WriteLane(int node, int lane, in PartRange range, int depth)
    {
        int child = range.Count <= _mostInLeaf ? PartTree.Leaf(range.Begin, range.Count) : Split(range, depth);
        _fit.Measure(range);
        _fit.Write(_boxes, node * PartTree.Stride + lane);
        _children[node * PartTree.Lanes + lane] = child;
    }

    /// <summary>A node over a range, which is cut until there are eight parts of it, or until what is left fills a node
    /// each: a node with few boxes takes as much memory as a full one.</summary>
    private int Split(in PartRange range, int depth)
    {
        while (_ranges.Count < depth) _ranges.Add(new PartRange[PartTree.Lanes]);
        PartRange[] ranges = _ranges[depth - 1];
        int count = 1;
        ranges[0] = range;
        bool isLast = range.Count <= PartTree.Lanes * _mostInLeaf;
        int least = isLast ? _leafSize : PartTree.Lanes * _leafSize;
        while (count < PartTree.Lanes)
        {
            int best = -1;
            for (int i = 0; i < count; i++)
                if (ranges[i].Count > least && (best < 0 || ranges[i].Weight > ranges[best].Weight)) best = i;
            if (best < 0) break;
            Cut(ref ranges[best], depth > MostUneven, out ranges[count++]);
        }

        int node = NewNode();
        if (depth == 1 && range.Count >= LeastToShare)
        {
            Graft(node, ranges, count);
            return node;
        }

        for (int i = 0; i < count; i++) WriteLane(node, i, ranges[i], depth + 1);
        return node;
    }

    /// <summary>Builds what is below the lanes of the root's node, each lane by a builder of its own, and takes the
    /// nodes over in the order in which this builder would have made them.</summary>
    private void Graft(int node, PartRange[] ranges, int count)
    {
        var branches = new PartTreeBuilder[count];
        for (int i = 0; i < count; i++) branches[i] = new PartTreeBuilder(this, ranges[i].Count);
        Workers.Run(_workers, new BranchJob(branches, ranges), count, 1);
        int nodes = _nodes;
        foreach (PartTreeBuilder branch in branches) nodes += branch._nodes - 1;
        Array.Resize(ref _boxes, nodes * PartTree.Stride);
        Array.Resize(ref _children, nodes * PartTree.Lanes);
        for (int lane = 0; lane < count; lane++)
        {
            PartTreeBuilder branch = branches[lane];
            int shift = _nodes - 1, first = _nodes * PartTree.Lanes;
            for (int i = 0; i < PartTree.Stride; i += PartTree.Lanes)
                _boxes[node * PartTree.Stride + i + lane] = branch._boxes[i];
            _children[node * PartTree.Lanes + lane] = Shifted(branch._children[0], shift);
            int floats = (branch._nodes - 1) * PartTree.Stride, lanes = (branch._nodes - 1) * PartTree.Lanes;
            Array.Copy(branch._boxes, PartTree.Stride, _boxes, _nodes * PartTree.Stride, floats);
            for (int i = 0; i < lanes; i++)
                _children[first + i] = Shifted(branch._children[PartTree.Lanes + i], shift);
            _nodes += branch._nodes - 1;
        }
    }

    /// <summary>Leaves and empty lanes stay.</summary>
    private static int Shifted(int child, int shift) => child < 0 ? child : child + shift;

    /// <summary>Builds branches, whose first lane is the lane of the tree that they grow from.</summary>
    private readonly struct BranchJob(PartTreeBuilder[] branches, PartRange[] ranges) : IShareJob
    {
        public void Run(int begin, int end)
        {
            for (int i = begin; i < end; i++) branches[i].WriteLane(branches[i].NewNode(), 0, ranges[i], 2);
        }
    }

    /// <summary>Puts the parts on one side of the best cut first; they are the range then, and the others the
    /// rest.</summary>
    private void Cut(ref PartRange range, bool isDeep, out PartRange rest)
    {
        int begin = range.Begin, end = range.End, axis = LongestAxis(begin, end, out double low, out double length);
        double scale = Bins * 0.9999 / length;
        int cut = isDeep || !(length > 0) || !Guard.IsFinite(scale) ? -1 : BestCut(begin, end, axis, low, scale);
        if (cut < 0)
        {
            int middle = begin + range.Count / 2;
            (range, rest) = (PartRange.Over(_items, begin, middle), PartRange.Over(_items, middle, end));
            return;
        }

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

        (range, rest) = (new PartRange(begin, left, BoxOf(0, cut)), new PartRange(left, end, BoxOf(cut + 1, Bins - 1)));
    }

    /// <summary>The box of the parts in some of the bins.</summary>
    private PartBox BoxOf(int first, int last)
    {
        PartBox box = PartBox.Nothing;
        for (int i = first; i <= last; i++) box.Add(_binBoxes[i]);
        return box;
    }

    /// <summary>The axis along which the middles are furthest apart.</summary>
    private int LongestAxis(int begin, int end, out double low, out double length)
    {
        PartBox middles = PartBox.Nothing;
        for (int i = begin; i < end; i++) middles.Add(_items[i].Box.Min + _items[i].Box.Max);
        Double3 size = middles.Max - middles.Min;
        int axis = size.X >= size.Y && size.X >= size.Z ? 0 : size.Y >= size.Z ? 1 : 2;
        low = axis == 0 ? middles.MinX : axis == 1 ? middles.MinY : middles.MinZ;
        length = axis == 0 ? size.X : axis == 1 ? size.Y : size.Z;
        return axis;
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
