namespace Gjk.Core;

/// <summary>Any of the library's shapes whose core is a segment or a point: a segment, a capsule, a point or a
/// sphere.</summary>
internal struct SegmentCore : ISupportMap, ILibraryShape
{
    /// <summary>The ends, measured from the centre.</summary>
    private LaneVector _first, _second;

    /// <summary>From the second end to the first.</summary>
    private Double3 _toFirst;

    private Double3 _center;
    private double _margin, _radius;
    private int _count;

    /// <summary>Written where it is to be, without a copy.</summary>
    /// <param name="first">One end; or the point.</param>
    /// <param name="second">The other end.</param>
    /// <param name="count">How many vertices there are, 1 or 2.</param>
    /// <param name="center">The middle.</param>
    /// <param name="radius">The bounding radius.</param>
    /// <param name="margin">The margin.</param>
    /// <param name="core">The segment.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Make(
        in Double3 first, in Double3 second, int count, in Double3 center, double radius, double margin,
        out SegmentCore core)
    {
        LaneVector.Between(center, first, out core._first);
        LaneVector.Between(center, second, out core._second);
        Double3.Write(first.X - second.X, first.Y - second.Y, first.Z - second.Z, out core._toFirst);
        Double3.Write(center.X, center.Y, center.Z, out core._center);
        core._margin = margin;
        core._radius = radius;
        core._count = count;
    }

    public readonly Double3 Center => _center;

    public readonly double Margin => _margin;

    public readonly double BoundingRadius => _radius;

    readonly object ILibraryShape.MakeTraits() => new LibraryTraits<SegmentCore>();

    public readonly bool TryGetForm(out ShapeForm form) =>
        ShapeForm.Capsule(_first.Xyz, _second.Xyz, default, _margin, out form);

    /// <summary>Both ends, or the point, whichever the direction.</summary>
    public readonly void GetFace(in Double3 direction, ref FaceCorners corners)
    {
        corners.Add(_first.Xyz, 0);
        if (_count == 2) corners.Add(_second.Xyz, 1);
    }

    public readonly int Support(in Double3 direction, out Double3 point)
    {
        int id = SupportId(direction);
        TryGetVertex(id, out point);
        return id;
    }

    public readonly bool TryGetVertex(int id, out Double3 point)
    {
        if (id == 0) Double3.Write(_first.Xyz.X, _first.Xyz.Y, _first.Xyz.Z, out point);
        else Double3.Write(_second.Xyz.X, _second.Xyz.Y, _second.Xyz.Z, out point);
        return (uint)id < (uint)_count;
    }

    /// <summary>How many vertices there are, 1 or 2.</summary>
    public readonly int Count => _count;

    /// <summary>Which end of a segment is furthest: 0, also where they are level, or 1.</summary>
    /// <param name="toFirst">From the second end to the first: by it a segment far from its local origin is asked as
    /// exactly as one at it.</param>
    /// <param name="direction">Any.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int FurthestEnd(in Double3 toFirst, in Double3 direction)
    {
        double dot = Double3.Dot(direction, toFirst);
        return BranchFree.IsNegative(DirectionRange.IsSafe(dot) ? dot : UnitDot(toFirst, direction));
    }

    /// <summary>The dot product with the direction brought to unit size. By value: callers keep registers.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static double UnitDot(Double3 toFirst, Double3 direction) =>
        Double3.Dot(DirectionRange.ToUnit(direction), toFirst);

    /// <summary>The id of the furthest end.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly int SupportId(in Double3 direction)
    {
        double dot = Double3.Dot(direction, _toFirst);
        return DirectionRange.IsSafe(dot) ? BranchFree.IsNegative(dot)
            : _count == 1 ? 0
            : BranchFree.IsNegative(UnitDot(_toFirst, direction));
    }

#if NET
    /// <summary>From the second end to the first, and a 0.</summary>
    public readonly Vector256<double> ToFirst => Vector256.Create(_toFirst.X, _toFirst.Y, _toFirst.Z, 0);

    /// <summary>An end, measured from the centre, and a 0.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly Vector256<double> Lanes(int id) => (id & 1) == 0 ? _first.Lanes : _second.Lanes;
#endif
}
