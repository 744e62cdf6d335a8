namespace Gjk.Core;

/// <summary>Any of the library's shapes that is a triangle, with or without a margin.</summary>
internal struct TriangleCore : ISupportMap, ILibraryShape
{
    /// <summary>The corners, measured from the centre.</summary>
    private LaneVector _first, _second, _third;

    /// <summary>From the first corner to the others.</summary>
    private Double3 _toSecond, _toThird;

    private Double3 _center;
    private double _margin, _radius;

    /// <summary>Written where it is to be, without a copy.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Make(
        in Double3 first, in Double3 second, in Double3 third, in Double3 center, double radius, double margin,
        out TriangleCore core)
    {
        LaneVector.Between(center, first, out core._first);
        LaneVector.Between(center, second, out core._second);
        LaneVector.Between(center, third, out core._third);
        Double3.Write(second.X - first.X, second.Y - first.Y, second.Z - first.Z, out core._toSecond);
        Double3.Write(third.X - first.X, third.Y - first.Y, third.Z - first.Z, out core._toThird);
        Double3.Write(center.X, center.Y, center.Z, out core._center);
        core._margin = margin;
        core._radius = radius;
    }

    public readonly Double3 Center => _center;

    public readonly double Margin => _margin;

    public readonly double BoundingRadius => _radius;

    readonly object ILibraryShape.MakeTraits() => new LibraryTraits<TriangleCore>();

    public readonly bool TryGetForm(out ShapeForm form) =>
        ShapeForm.Triangle(_first.Xyz, _second.Xyz, _third.Xyz, default, out form);

    public readonly void GetFace(in Double3 direction, ref FaceCorners corners) =>
        Face(_first.Xyz, _second.Xyz, _third.Xyz, direction, ref corners);

    public readonly int Support(in Double3 direction, out Double3 point)
    {
        int id = SupportId(direction);
        TryGetVertex(id, out point);
        return id;
    }

    public readonly bool TryGetVertex(int id, out Double3 point)
    {
        ref readonly Double3 corner = ref Corner(_first, id).Xyz;
        Double3.Write(corner.X, corner.Y, corner.Z, out point);
        return HasVertex(id);
    }

    /// <summary>Whether there is a corner with the id.</summary>
    public static bool HasVertex(int id) => (uint)id < 3u;

    /// <summary>One of three corners that follow each other; the first where there is none with the id. No branch: ids
    /// are unpredictable.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static ref readonly T Corner<T>(in T first, int id)
        where T : struct => ref UnsafeRef.At(first, HasVertex(id) ? id : 0);

    /// <summary>The id of the furthest corner.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly int SupportId(in Double3 direction) => Furthest(_toSecond, _toThird, direction);

    /// <summary>Which corner is furthest: 0 to 2, of level ones the first.</summary>
    /// <param name="toSecond">From the first corner to the second: by it a triangle far from its local origin is asked
    /// as exactly as one at it.</param>
    /// <param name="toThird">From the first corner to the third.</param>
    /// <param name="direction">Any.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int Furthest(in Double3 toSecond, in Double3 toThird, in Double3 direction) =>
        Furthest(toSecond.X, toSecond.Y, toSecond.Z, toThird.X, toThird.Y, toThird.Z, direction);

    /// <summary>The same in numbers, u to the second corner and v to the third.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int Furthest(double ux, double uy, double uz, double vx, double vy, double vz, in Double3 direction)
    {
        double second = direction.X * ux + direction.Y * uy + direction.Z * uz;
        double third = direction.X * vx + direction.Y * vy + direction.Z * vz;
        return DirectionRange.IsSafe(second) && DirectionRange.IsSafe(third)
            ? Furthest(second, third)
            : FurthestInUnits(ux, uy, uz, vx, vy, vz, direction);
    }

    /// <summary>By the dot products with the direction; branchless, because their signs are unpredictable.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static int Furthest(double second, double third)
    {
        int isThird = BranchFree.IsNegative(second - third) & BranchFree.IsNegative(-third);
        return (isThird << 1) | (BranchFree.IsNegative(-second) & ~isThird);
    }

    /// <summary>With the direction brought to unit size. By value: callers keep registers.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static int FurthestInUnits(
        double ux, double uy, double uz, double vx, double vy, double vz, Double3 direction)
    {
        Double3 unit = DirectionRange.ToUnit(direction);
        return Furthest(Double3.Dot(unit, new(ux, uy, uz)), Double3.Dot(unit, new(vx, vy, vz)));
    }

    /// <summary>A triangle, from either side, or one of its edges or corners.</summary>
    public static void Face(in Double3 a, in Double3 b, in Double3 c, in Double3 direction, ref FaceCorners corners)
    {
        Double3 normal = Double3.Cross(b - a, c - a);
        if (FaceTilt.IsLevelFace(normal, direction, corners) || FaceTilt.IsLevelFace(-normal, direction, corners))
        {
            corners.Add(a, 0);
            corners.Add(b, 1);
            corners.Add(c, 2);
            return;
        }

        // The more level of the two edges at the furthest corner, as for a hull.
        int id = Furthest(b - a, c - a, direction);
        Double3 point = id == 0 ? a : id == 1 ? b : c;
        Double3 next = corners.ToOuter((id == 0 ? b : id == 1 ? c : a) - point), up = corners.OuterDirection(direction);
        Double3 last = corners.ToOuter((id == 0 ? c : id == 1 ? a : b) - point);
        bool isNext = FaceTilt.Rise(next, up) <= FaceTilt.Rise(last, up);
        bool isEdge = FaceTilt.IsLevelEdge(isNext ? next : last, up);
        int end = !isEdge ? id : isNext ? (id + 1) % 3 : (id + 2) % 3;
        if (id == 0 || end == 0) corners.Add(a, 0);
        if (id == 1 || end == 1) corners.Add(b, 1);
        if (id == 2 || end == 2) corners.Add(c, 2);
    }

#if NET
    /// <summary>From the first corner to the second, and a 0.</summary>
    public readonly Vector256<double> ToSecond => Vector256.Create(_toSecond.X, _toSecond.Y, _toSecond.Z, 0);

    /// <summary>From the first corner to the third, and a 0.</summary>
    public readonly Vector256<double> ToThird => Vector256.Create(_toThird.X, _toThird.Y, _toThird.Z, 0);

    /// <summary>A corner, measured from the centre, and a 0.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly Vector256<double> Lanes(int id) =>
        id == 0 ? _first.Lanes : id == 1 ? _second.Lanes : _third.Lanes;
#endif
}
