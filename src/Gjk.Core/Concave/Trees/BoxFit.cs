namespace Gjk.Core;

/// <summary>Fits the box of a range of parts: along the axes, or along the spread of triangles, whichever has less
/// surface.</summary>
/// <remarks>A box is written in float and still holds its parts: the axes are rounded first, and the parts are then
/// measured along the rounded axes, in double, from the rounded centre. <see cref="Outward"/> covers what double loses
/// then and the rounding of the half side.</remarks>
internal sealed class BoxFit
{
    /// <summary>Ratio to the half side and to the radius: 2^-23, twice the rounding to float; double's own errors,
    /// below 2^-49 of the radius, are within that. With less a part's corner is lost, as BoxLanesTests shows; four
    /// times as much costs time only.</summary>
    private const double Outward = 1.0 / (1 << 23);

    /// <summary>Ratio to the origin's distance: 2^-50, eight times what measuring from it rounds away.</summary>
    private const double FromFar = 1.0 / (1L << 50);

    private readonly IPartSource _source;

    /// <summary>Memory for the parts that are measured together, with their boxes in the tree's frame.</summary>
    private readonly PartItem[] _items;
    private double _inverse;
    private Double3 _u, _v, _w, _center, _half;

    /// <summary>Fits boxes to all parts, in a frame around them.</summary>
    /// <param name="source">The parts.</param>
    /// <param name="items">Room for as many; gets them.</param>
    /// <param name="order">The part of each item; null for the parts as they come.</param>
    public BoxFit(IPartSource source, PartItem[] items, int[]? order = null)
    {
        (_source, _items) = (source, items);
        for (int i = 0; i < items.Length; i++) items[i] = new PartItem(source, order is null ? i : order[i]);
        SetFrame(PartRange.Over(items, 0, items.Length).Box);
        ToFrame(items.Length);
    }

    /// <param name="source">The parts.</param>
    /// <param name="items">Room for those that are measured together; see <see cref="ToFrame"/>.</param>
    /// <param name="tree">Has the frame.</param>
    public BoxFit(IPartSource source, PartItem[] items, PartTree tree)
    {
        (_source, _items) = (source, items);
        (Origin, Unit, Radius, _inverse) = (tree.Origin, tree.Unit, tree.Radius, 1 / tree.Unit);
    }

    public Double3 Origin { get; private set; }

    public double Unit { get; private set; }

    public double Radius { get; private set; }

    /// <summary>Puts the tree's frame into the middle of a box.</summary>
    /// <param name="all">Of all parts, in the shape's frame.</param>
    public void SetFrame(in PartBox all)
    {
        Origin = (all.Min + all.Max) * 0.5;
        Double3 half = (all.Max - all.Min) * 0.5;
        Unit = PartTree.UnitOf(half.SumOfMagnitudes);
        _inverse = 1 / Unit;

        // In tree units, where no square leaves the range of double.
        Radius = (half * _inverse).Length * (1 + Outward) * Unit;
    }

    /// <summary>The distance of a box's furthest point from the frame's origin, in the shape's units.</summary>
    public double RadiusTo(in PartBox box)
    {
        PartBox local = Local(box);
        var far = new Double3(
            Math.Max(-local.MinX, local.MaxX), Math.Max(-local.MinY, local.MaxY), Math.Max(-local.MinZ, local.MaxZ));
        return far.Length * (1 + Outward) * Unit;
    }

    /// <summary>Lets the frame hold parts that are further from its origin.</summary>
    public void Widen(double radius) => Radius = Math.Max(Radius, radius);

    /// <summary>Brings the first items' boxes from the shape's frame to the tree's.</summary>
    public void ToFrame(int count)
    {
        for (int i = 0; i < count; i++)
        {
            ref PartBox box = ref _items[i].Box;
            box = Local(box);
        }
    }

    public PartBox Local(in PartBox box) => new(Local(box.Min), Local(box.Max));

    /// <summary>A copy with the same parts and frame, for another thread.</summary>
    public BoxFit Copy() => (BoxFit)MemberwiseClone();

    /// <summary>Writes the frame to a tree.</summary>
    public void WriteFrame(PartTree tree) => (tree.Origin, tree.Unit, tree.Radius) = (Origin, Unit, Radius);

    /// <summary>Finds the box of a range.</summary>
    public void Measure(int begin, int end) => Measure(PartRange.Over(_items, begin, end));

    /// <inheritdoc cref="Measure(int, int)"/>
    public void Measure(in PartRange range)
    {
        (int begin, int end) = (range.Begin, range.End);
        SetBox(new Double3(1, 0, 0), new Double3(0, 1, 0), new Double3(0, 0, 1), range.Box);
        if (!TryGetSpread(begin, end, out Double3 u, out Double3 v, out Double3 w)) return;
        (u, v, w) = (ToFloats(u), ToFloats(v), ToFloats(w));
        PartBox along = MeasureAlong(begin, end, u, v, w);
        if (along.Area < range.Box.Area) SetBox(u, v, w, along);
    }

    /// <summary>Takes a box of axes that are floats.</summary>
    /// <param name="u">An axis, of unit length but for rounding.</param>
    /// <param name="v">The second.</param>
    /// <param name="w">The third.</param>
    /// <param name="box">The extent along the axes, in tree units.</param>
    public void SetBox(in Double3 u, in Double3 v, in Double3 w, in PartBox box)
    {
        Double3 middle = (box.Min + box.Max) * 0.5;
        Double3 center = ToFloats(u * middle.X + v * middle.Y + w * middle.Z);
        Double3 along = Along(center, u, v, w);
        (_u, _v, _w, _center) = (u, v, w, center);
        _half = Widened(box.Max - along, along - box.Min);
    }

    /// <summary>Writes the box to a lane.</summary>
    public void Write(float[] boxes, int at)
    {
        Write(boxes, at, _center);
        Write(boxes, at + PartTree.Halves, _half);
        Write(boxes, at + PartTree.Axes, _u);
        Write(boxes, at + PartTree.Axes + 3 * PartTree.Lanes, _v);
        Write(boxes, at + PartTree.Axes + 6 * PartTree.Lanes, _w);
    }

    private static void Write(float[] boxes, int at, in Double3 v)
    {
        boxes[at] = (float)v.X;
        boxes[at + PartTree.Lanes] = (float)v.Y;
        boxes[at + 2 * PartTree.Lanes] = (float)v.Z;
    }

    private bool TryGetSpread(int begin, int end, out Double3 u, out Double3 v, out Double3 w)
    {
        BoxSpread spread = default;
        for (int i = begin; i < end; i++)
        {
            if (!_source.TryGetTriangle(_items[i].Part, out Double3 a, out Double3 b, out Double3 c))
            {
                u = v = w = default;
                return false;
            }

            spread.Add(Local(a) - _center, Local(b) - _center, Local(c) - _center);
        }

        return spread.TryGetAxes(out u, out v, out w);
    }

    private PartBox MeasureAlong(int begin, int end, in Double3 u, in Double3 v, in Double3 w)
    {
        PartBox box = PartBox.Nothing;
        for (int i = begin; i < end; i++)
        {
            _source.TryGetTriangle(_items[i].Part, out Double3 a, out Double3 b, out Double3 c);
            box.Add(Along(Local(a), u, v, w));
            box.Add(Along(Local(b), u, v, w));
            box.Add(Along(Local(c), u, v, w));
        }

        return box;
    }

    public static Double3 Along(in Double3 p, in Double3 u, in Double3 v, in Double3 w) =>
        new(Double3.Dot(p, u), Double3.Dot(p, v), Double3.Dot(p, w));

    private Double3 Local(in Double3 p) => (p - Origin) * _inverse;

    private static Double3 ToFloats(in Double3 v) => new((float)v.X, (float)v.Y, (float)v.Z);

    /// <summary>The larger reach along each axis, and a little more.</summary>
    private Double3 Widened(in Double3 up, in Double3 down)
    {
        double radius = Radius * _inverse * (Outward / 2) + Origin.SumOfMagnitudes * _inverse * FromFar;
        return new Double3(
            Math.Max(up.X, down.X) * (1 + Outward) + radius, Math.Max(up.Y, down.Y) * (1 + Outward) + radius,
            Math.Max(up.Z, down.Z) * (1 + Outward) + radius);
    }
}
