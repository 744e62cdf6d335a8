namespace Gjk.Core;

/// <summary>The vertex of a hull that is furthest in a direction: the lowest id among those whose dot product, in
/// double, is largest; of a box the corner that the signs of the direction name, which is the furthest without
/// rounding.</summary>
/// <remarks>The definition is a scan of all vertices: of their coordinates from the hull's origin
/// (<see cref="HullOrigin"/>), with the direction prepared (<see cref="HullDirection"/>). <see cref="Find"/> gets the
/// same vertex from the direction's cell for a large hull (<see cref="HullCells"/>), and by such a scan for a small
/// one. HullLookupTests compare the two.</remarks>
internal static class HullSupport
{
    /// <summary>The furthest vertex of a hull.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int Find(HullCells cells, in Double3 direction, out Double3 point)
    {
        double dx = direction.X, dy = direction.Y, dz = direction.Z;
        if (cells.Kind == HullCells.LookupKind.Box)
        {
            return HullBlocks.Read(cells.Points, cells.Corners.Id(Signs(dx, dy, dz)), out point);
        }

        if (cells.Kind == HullCells.LookupKind.Scan)
        {
#if NET
            int id = FindByScan(cells, direction);
#else
            int id = HullDirection.IsSafe(Math.Abs(dx) + Math.Abs(dy) + Math.Abs(dz))
                ? HullBlocks.Best(cells.Coordinates, 0, cells.BlockCount, direction)
                : FindRarely(cells, dx, dy, dz);
#endif
            return HullBlocks.Read(cells.Points, id, out point);
        }

        return FindInCell(cells, direction, out point);
    }

    /// <summary>The same for hulls that are neither boxes nor scanned as a whole.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int FindInCell(HullCells cells, in Double3 direction, out Double3 point)
    {
        double dx = direction.X, dy = direction.Y, dz = direction.Z;
        int cell = cells.Kind == HullCells.LookupKind.Cells ? CubeCell(cells, dx, dy, dz) : cells.NoCell;
        int start = cells.Runs[2 * cell], end = cells.Runs[2 * cell + 1];
        int slot = end > start
            ? HullBlocks.Best(cells.Coordinates, start, end, direction)
            : FindRarely(cells, dx, dy, dz);
        return cells.Ids[HullBlocks.Read(cells.Points, slot, out point)];
    }

#if NET
    /// <summary>The id of the furthest vertex of a hull that is scanned as a whole.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int FindByScan(HullCells cells, in Double3 d) =>
        HullDirection.IsSafe(Math.Abs(d.X) + Math.Abs(d.Y) + Math.Abs(d.Z))
            ? HullScan.Best(cells.ScanBlocks, d.X, d.Y, d.Z)
            : FindRarely(cells, d.X, d.Y, d.Z);
#endif

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static int Signs(double x, double y, double z) =>
        BranchFree.IsNegative(x) | (BranchFree.IsNegative(y) << 1) | (BranchFree.IsNegative(z) << 2);

    /// <summary>The slot of the furthest vertex where <see cref="Find"/> has no short cut: flat hulls, cells without a
    /// list, directions of extreme length.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static int FindRarely(HullCells cells, double dx, double dy, double dz)
    {
        var d = new Double3(dx, dy, dz);
        if (!cells.Direction.TryPrepare(ref d)) return cells.FirstSlot;
        if (cells.Side == 0) return HullBlocks.Best(cells.Coordinates, 0, cells.BlockCount, d);
        int cell = cells.Direction.IsPlanar ? SquareCell(cells, d) : CubeCell(cells, d.X, d.Y, d.Z);
        int start = cells.Runs[2 * cell], end = cells.Runs[2 * cell + 1];
        return end > start
            ? HullBlocks.Best(cells.Coordinates, start, end, d)
            : cells.Tree!.Find(cells, d, start, out _);
    }

    /// <summary>The cube's face by the largest stretched component, then the cell by the other two over it. A direction
    /// of extreme length has the cell after the last, which is empty.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static int CubeCell(HullCells cells, double dx, double dy, double dz)
    {
        double x = dx * cells.Stretch.X, y = dy * cells.Stretch.Y, z = dz * cells.Stretch.Z;
        if (!HullDirection.IsSafe(Math.Abs(dx) + Math.Abs(dy) + Math.Abs(dz))) return cells.NoCell;
#if NET
        // Which component is the largest is a guess that a processor would lose every other time.
        Vector128<double> sx = Vector128.CreateScalarUnsafe(x), sy = Vector128.CreateScalarUnsafe(y);
        Vector128<double> sz = Vector128.CreateScalarUnsafe(z), lx = Vector128.Abs(sx), ly = Vector128.Abs(sy);
        Vector128<double> lz = Vector128.Abs(sz);
        Vector128<double> isX = Vector128.GreaterThanOrEqual(lx, ly) & Vector128.GreaterThanOrEqual(lx, lz);
        Vector128<double> isY = Vector128.AndNot(Vector128.GreaterThanOrEqual(ly, lz), isX);
        Vector128<double> main = Vector128.ConditionalSelect(isX, sx, Vector128.ConditionalSelect(isY, sy, sz));
        double u = Vector128.ConditionalSelect(isX, sy, sx).ToScalar();
        double v = Vector128.ConditionalSelect(isX | isY, sz, sy).ToScalar();
        double w = Vector128.Abs(main).ToScalar();
        int face = (int)(4 + 4 * isX.AsInt64().ToScalar() + 2 * isY.AsInt64().ToScalar())
            + BranchFree.IsNegative(main.ToScalar());
#else
        double ax = Math.Abs(x), ay = Math.Abs(y), az = Math.Abs(z);
        bool isX = ax >= ay && ax >= az, isY = !isX && ay >= az;
        double u = isX ? y : x, v = isX || isY ? z : y, w = isX ? ax : isY ? ay : az;
        int face = isX ? BranchFree.IsNegative(x) : isY ? 2 + BranchFree.IsNegative(y) : 4 + BranchFree.IsNegative(z);
#endif
        int side = cells.Side;
        double middle = cells.HalfSide, scale = middle / w;
        return (face * side + Index(v * scale + middle, side)) * side + Index(u * scale + middle, side);
    }

    /// <summary>The same on the sides of a square, for a flat hull, with the two components that matter.</summary>
    private static int SquareCell(HullCells cells, in Double3 direction)
    {
        Double3 stretch = cells.Direction.Stretch, s = Double3.Multiply(direction, stretch);
        double a = stretch.X > 0 ? s.X : s.Y, b = stretch.Z > 0 ? s.Z : s.Y;
        bool isA = Math.Abs(a) >= Math.Abs(b);
        double u = isA ? b : a, w = isA ? a : b;
        int face = (isA ? 0 : 2) + (w < 0 ? 1 : 0), side = cells.Side;
        return face * side + Index(u * (cells.HalfSide / Math.Abs(w)) + cells.HalfSide, side);
    }

    /// <summary>The integer part of a position from 0 to side, held below side.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static int Index(double position, int side)
    {
#if NET
        // A cast would also care for positions that are no int.
        int index = double.ConvertToIntegerNative<int>(position);
#else
        int index = (int)position;
#endif
        return index < side ? index : side - 1;
    }
}
