namespace Gjk.Core;

/// <summary>Fits the boxes of a <see cref="HullTree"/>: from the root down, each node's vertices are cut in two along
/// its longest axis.</summary>
internal sealed class HullTreeBuilder
{
    /// <summary>Steps of a float at the node's largest coordinate: a node that is thinner than this along its parent's
    /// normal keeps that normal. The vertices of a tilted face are rounded to floats; normals fitted to that roughness
    /// would differ from node to node, and the bounds with them.</summary>
    private const double Roughness = 4;

    /// <summary>Stretched units: the most that counts as roughness, for meshes so far from their local origin that
    /// floats are coarse.</summary>
    private const double MostRoughness = 1.0 / 64;

    /// <summary>Relative to the size of a node: what its box is enlarged by on each side. Fitting rounds by less than
    /// 128 u, u = 2^-53, of that size: offsets, three axes that are not quite orthogonal, and sums. This is 256
    /// u.</summary>
    private const double Enlargement = 1.0 / (1L << 45);

    private readonly HullVertices _hull;
    private readonly double[] _x, _y, _z, _keys;
    private readonly int _firstBlock;
    private int _used = 1;

    /// <param name="hull">Its coordinates are read.</param>
    /// <param name="stretch">What directions are stretched by.</param>
    /// <param name="firstBlock">Where the blocks of the leaves will be.</param>
    public HullTreeBuilder(HullVertices hull, in Double3 stretch, int firstBlock)
    {
        int count = hull.Count;
        _hull = hull;
        _firstBlock = firstBlock;
        Inverse = new Double3(InversePower(stretch.X), InversePower(stretch.Y), InversePower(stretch.Z));
        _x = Multiplied(hull.X, Inverse.X, count);
        _y = Multiplied(hull.Y, Inverse.Y, count);
        _z = Multiplied(hull.Z, Inverse.Z, count);
        _keys = new double[count];
        Order = new int[count];
        for (int i = 0; i < count; i++) Order[i] = i;
        int leaves = (count + HullTree.LeafVertices - 1) / HullTree.LeafVertices;
        Nodes = new HullTreeNode[2 * leaves - 1];
        Build(0, 0, leaves, new Double3(0, 0, 1));
    }

    /// <summary>What coordinates are multiplied by in the nodes: powers of two, which round nothing; 0 for an axis
    /// without extent.</summary>
    public Double3 Inverse { get; }

    /// <summary>The root first.</summary>
    public HullTreeNode[] Nodes { get; }

    /// <summary>The ids of the vertices in the order of the leaves, the same number in each but the last; they ascend
    /// in a leaf.</summary>
    public int[] Order { get; }

    private static double InversePower(double stretch) => stretch > 0 ? 1 / PowerOfTwo.AtMost(stretch) : 0;

    private static double[] Multiplied(float[] coordinates, double inverse, int count)
    {
        double[] scaled = new double[count];
        for (int i = 0; i < count; i++) scaled[i] = coordinates[i] * inverse;
        return scaled;
    }

    /// <summary>What the rounding of the vertices in a node to floats can make of a plane.</summary>
    private double RoughnessOf(in HullTreeNode node)
    {
        Double3 origin = _hull.Origin;
        double x = Step(node.MinX + origin.X, node.MaxX + origin.X) * Inverse.X;
        double y = Step(node.MinY + origin.Y, node.MaxY + origin.Y) * Inverse.Y;
        double z = Step(node.MinZ + origin.Z, node.MaxZ + origin.Z) * Inverse.Z;
        return Math.Min(Roughness * Math.Max(x, Math.Max(y, z)), MostRoughness);
    }

    /// <summary>The relative step of a float is 2^-23.</summary>
    private static double Step(double min, double max) => Math.Max(Math.Abs(min), Math.Abs(max)) / (1 << 23);

    private void Build(int node, int leaf, int leaves, in Double3 parentNormal)
    {
        int from = leaf * HullTree.LeafVertices, to = Math.Min(from + leaves * HullTree.LeafVertices, Order.Length);
        SetBox(ref Nodes[node], from, to);
        Double3 normal = FitNormal(from, to, RoughnessOf(Nodes[node]), parentNormal, out Double3 chord);
        Double3 longest = SetTurnedBox(ref Nodes[node], from, to, chord, normal);
        if (leaves == 1)
        {
            Array.Sort(Order, from, to - from);
            Nodes[node].Next = ~(_firstBlock + from / HullCells.Lanes);
            return;
        }

        int half = leaves / 2, next = _used;
        for (int k = from; k < to; k++) _keys[k] = Along(longest, Order[from], Order[k]);
        Array.Sort(_keys, Order, from, to - from);
        Nodes[node].Next = next;
        _used += 2;
        Build(next, leaf, half, normal);
        Build(next + 1, leaf + half, leaves - half, normal);
    }

    /// <summary>The box along a chord, a normal, and across; gives the axis of its longest side.</summary>
    private Double3 SetTurnedBox(ref HullTreeNode node, int from, int to, in Double3 chord, in Double3 normal)
    {
        // Offsets from a vertex of the node are as small as the node is, and so is their rounding.
        Double3 across = Double3.Cross(normal, chord);
        Extent(chord, from, to, out double middle1, out double half1);
        Extent(normal, from, to, out double middle2, out double half2);
        Extent(across, from, to, out double middle3, out double half3);
        Double3 longest = half1 >= half2 && half1 >= half3 ? chord : half2 >= half3 ? normal : across;
        double more = half1 + half2 + half3 + Math.Abs(middle1) + Math.Abs(middle2) + Math.Abs(middle3);
        more *= Enlargement;
        int origin = Order[from];
        Double3 middle = chord * middle1 + normal * middle2 + across * middle3;
        Double3 center = new Double3(_x[origin], _y[origin], _z[origin]) + middle;
        Double3 first = chord * (half1 + more), second = normal * (half2 + more), third = across * (half3 + more);
        (node.CenterX, node.FirstX, node.SecondX, node.ThirdX) = (center.X, first.X, second.X, third.X);
        (node.CenterY, node.FirstY, node.SecondY, node.ThirdY) = (center.Y, first.Y, second.Y, third.Y);
        (node.CenterZ, node.FirstZ, node.SecondZ, node.ThirdZ) = (center.Z, first.Z, second.Z, third.Z);
        return longest;
    }

    /// <summary>A unit vector along the longest chord found, and a unit normal of the plane that the vertices lie
    /// near.</summary>
    private Double3 FitNormal(int from, int to, double roughness, in Double3 parentNormal, out Double3 chord)
    {
        Extreme(from, to, out int a, out int b);
        chord = Unit(Offset(a, b), new Double3(1, 0, 0));
        Extent(parentNormal, from, to, out _, out double thickness);
        Double3 normal = parentNormal;
        if (2 * thickness > roughness)
        {
            double most = 0;
            for (int k = from; k < to; k++)
            {
                Double3 cross = Double3.Cross(chord, Offset(a, Order[k]));
                if (!(cross.LengthSquared > most)) continue;
                most = cross.LengthSquared;
                normal = cross;
            }
        }

        // The chord and the normal are made orthogonal, the normal being the one that is kept.
        normal = Unit(normal, parentNormal);
        Double3 inPlane = chord - normal * Double3.Dot(normal, chord);
        Double3 other = Math.Abs(normal.X) < 0.6 ? new Double3(1, 0, 0) : new Double3(0, 1, 0);
        chord = inPlane.LengthSquared > 0.01 ? Unit(inPlane, other) : Unit(Double3.Cross(normal, other), other);
        chord = Unit(chord - normal * Double3.Dot(normal, chord), chord);
        return normal;
    }

    /// <summary>The two ends along the coordinate axis that is longest.</summary>
    private void Extreme(int from, int to, out int a, out int b)
    {
        (a, b) = (Order[from], Order[from]);
        double most = -1;
        foreach (double[] axis in new[] { _x, _y, _z })
        {
            int low = Order[from], high = low;
            for (int k = from; k < to; k++)
            {
                int i = Order[k];
                if (axis[i] < axis[low]) low = i;
                if (axis[i] > axis[high]) high = i;
            }

            if (!(axis[high] - axis[low] > most)) continue;
            most = axis[high] - axis[low];
            (a, b) = (low, high);
        }
    }

    private void Extent(in Double3 axis, int from, int to, out double middle, out double half)
    {
        double least = double.PositiveInfinity, most = double.NegativeInfinity;
        for (int k = from; k < to; k++)
        {
            double along = Along(axis, Order[from], Order[k]);
            least = Math.Min(least, along);
            most = Math.Max(most, along);
        }

        middle = 0.5 * (least + most);
        half = 0.5 * (most - least);
    }

    private void SetBox(ref HullTreeNode node, int from, int to)
    {
        Range(_hull.X, from, to, out node.MinX, out node.MaxX);
        Range(_hull.Y, from, to, out node.MinY, out node.MaxY);
        Range(_hull.Z, from, to, out node.MinZ, out node.MaxZ);
        node.LeastId = int.MaxValue;
        for (int k = from; k < to; k++) node.LeastId = Math.Min(node.LeastId, Order[k]);
    }

    private void Range(float[] coordinates, int from, int to, out float min, out float max)
    {
        (min, max) = (float.PositiveInfinity, float.NegativeInfinity);
        for (int k = from; k < to; k++)
        {
            min = Math.Min(min, coordinates[Order[k]]);
            max = Math.Max(max, coordinates[Order[k]]);
        }
    }

    private Double3 Offset(int from, int to) => new(_x[to] - _x[from], _y[to] - _y[from], _z[to] - _z[from]);

    /// <summary>How far a vertex lies from another along an axis.</summary>
    private double Along(in Double3 axis, int origin, int i) => Double3.Dot(axis, Offset(origin, i));

    private static Double3 Unit(in Double3 v, in Double3 otherwise)
    {
        double length = v.Length;
        return length > 1e-100 ? v * (1 / length) : otherwise;
    }
}
