namespace Gjk.Core;

/// <summary>A tree over the parts of a shape: nodes of eight oriented boxes in float, leaves of a few parts. Each box
/// holds its parts for certain: a part's points p have |(p - centre) · axis| &lt;= half side along each of the three
/// axes as they are stored, which are perpendicular and of unit length but for float's rounding.</summary>
/// <remarks>Lengths are in units of a power of two, and measured from <see cref="Origin"/>, so that no square of one
/// leaves the range of float. Lane 0 of node 0 is the whole. Immutable once built, but for the tree of a single
/// part and that of a height field.</remarks>
internal sealed class PartTree
{
    /// <summary>How many boxes a node has.</summary>
    public const int Lanes = 8;

    /// <summary>Floats per node: centre (3), half sides (3) and axes (9), eight of each.</summary>
    public const int Stride = 15 * Lanes;

    /// <summary>The first half side and the first axis in a node.</summary>
    public const int Halves = 3 * Lanes, Axes = 6 * Lanes;

    /// <summary>A lane without a box.</summary>
    public const int Empty = int.MinValue;

    /// <summary>Ratio to half sides: 2^-20, how far axes rounded to float are from perpendicular. Each of their nine
    /// numbers is off by 2^-24 at most, so the inverse rotation is off by 6 * 2^-24. More costs time only.</summary>
    private const double Skew = 1.0 / (1 << 20);

    /// <summary>Ratio: 2^-22, more than rounding the half side of a single part to float takes.</summary>
    private const double Outward = 1 + 1.0 / (1 << 22);

    public readonly float[] Boxes;

    /// <summary>Per lane: a node (at least 0), a leaf (see <see cref="Leaf"/>), or <see cref="Empty"/>.</summary>
    public readonly int[] Children;

    /// <summary>The parts in the order of the leaves.</summary>
    public readonly int[] Order;

    /// <summary>The frame's origin in the shape's own frame.</summary>
    public Double3 Origin;

    /// <summary>The shape's units per tree unit: a power of two.</summary>
    public double Unit = 1;

    /// <summary>In the shape's units: no point of the parts is further from the origin.</summary>
    public double Radius;

    public PartTree(float[] boxes, int[] children, int[] order) => (Boxes, Children, Order) = (boxes, children, order);

    /// <summary>The tree of a convex shape, which is one part to the searches. Its box is set later.</summary>
    public static PartTree Single()
    {
        var tree = new PartTree(new float[Stride], new int[Lanes], new int[1]);
        WriteEmpty(tree.Boxes, tree.Children, 0);
        tree.Children[0] = Leaf(0, 1);
        return tree;
    }

    /// <summary>Writes a node without boxes, but with axes.</summary>
    public static void WriteEmpty(float[] boxes, int[] children, int node)
    {
        for (int lane = node * Lanes; lane < (node + 1) * Lanes; lane++)
        {
            children[lane] = Empty;
            for (int axis = 0; axis < 3; axis++) boxes[At(lane) + Axes + 4 * axis * Lanes] = 1;
        }
    }

    /// <summary>Writes the box of a single part.</summary>
    public void SetSingle(in Double3 min, in Double3 max)
    {
        Origin = (min + max) * 0.5;
        Double3 half = (max - min) * (0.5 * Outward);
        Unit = UnitOf(half.SumOfMagnitudes);
        half *= 1 / Unit;
        Radius = half.Length * Unit * Outward;
        Boxes[Halves] = (float)half.X;
        Boxes[Halves + Lanes] = (float)half.Y;
        Boxes[Halves + 2 * Lanes] = (float)half.Z;
    }

    /// <summary>The power of two that is the unit of lengths with such a sum.</summary>
    public static double UnitOf(double most) =>
        most > 0 ? PowerOfTwo.AtMost(Math.Max(most, float.Epsilon)) : 1;

    /// <summary>Where the floats of a box begin.</summary>
    /// <param name="box">A node times <see cref="Lanes"/>, and its lane.</param>
    public static int At(int box) => box / Lanes * Stride + box % Lanes;

    /// <summary>Three numbers of a lane: the centre, the half sides or an axis.</summary>
    public Double3 Read(int at) => new(Boxes[at], Boxes[at + Lanes], Boxes[at + 2 * Lanes]);

    /// <summary>How far a box reaches from its centre along the frame's axes, at most; in tree units.</summary>
    public Double3 ReachOf(int at) =>
        ReachOf(at, new Double3(1, 0, 0), new Double3(0, 1, 0), new Double3(0, 0, 1));

    /// <summary>How far a box reaches from its centre along three directions of unit length, at most; in tree
    /// units.</summary>
    public Double3 ReachOf(int at, in Double3 u, in Double3 v, in Double3 w)
    {
        Double3 reach = default;
        for (int i = 0; i < 3; i++)
        {
            Double3 along = BoxFit.Along(Read(at + Axes + 3 * i * Lanes), u, v, w);
            reach += new Double3(Math.Abs(along.X) + Skew, Math.Abs(along.Y) + Skew, Math.Abs(along.Z) + Skew)
                * Boxes[at + Halves + i * Lanes];
        }

        return reach;
    }

    /// <summary>Lists the parts whose leaves' boxes may be within a distance of a point.</summary>
    /// <param name="node">Those below a node.</param>
    /// <param name="point">In tree units, from the origin.</param>
    /// <param name="distance">In tree units.</param>
    /// <param name="parts">Gets the parts.</param>
    public void FindNear(int node, in Double3 point, double distance, List<int> parts)
    {
        for (int lane = node * Lanes; lane < (node + 1) * Lanes; lane++)
        {
            int child = Children[lane];
            if (child == Empty || IsBeyond(At(lane), point, distance)) continue;
            if (child >= 0) FindNear(child, point, distance, parts);
            else for (int i = 0; i < CountOf(child); i++) parts.Add(Order[FirstOf(child) + i]);
        }
    }

    /// <summary>Whether a box is further from a point than a distance, for certain.</summary>
    private bool IsBeyond(int at, in Double3 point, double distance)
    {
        Double3 to = Read(at) - point;
        double room = distance + Skew * (distance + to.SumOfMagnitudes);
        for (int i = 0; i < 3; i++)
        {
            double along = Double3.Dot(Read(at + Axes + 3 * i * Lanes), to);
            if (Math.Abs(along) - Boxes[at + Halves + i * Lanes] > room) return true;
        }

        return false;
    }

    /// <summary>A leaf with so many parts, from the first.</summary>
    public static int Leaf(int first, int count) => ~(first * Lanes + count);

    public static int FirstOf(int leaf) => ~leaf / Lanes;

    public static int CountOf(int leaf) => ~leaf % Lanes;
}
