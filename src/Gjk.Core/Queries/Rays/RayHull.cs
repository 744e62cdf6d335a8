namespace Gjk.Core;

/// <summary>A line against a hull: cut by the planes of its facets (Cyrus and Beck 1978; Ericson 2005, section 5.3.8).
/// Of planes that it enters through at the same parameter the first one gives the normal.</summary>
internal static class RayHull
{
    /// <summary>Stands for an entry that rounding would choose.</summary>
    private const int Along = -2;

    /// <summary>The line need not be measured from its foot, nor be of unit direction.</summary>
    /// <param name="foot">The line's point at the parameter 0, from the hull's centre.</param>
    /// <param name="direction">Its direction.</param>
    /// <param name="hull">The hull.</param>
    /// <param name="planes">Its planes.</param>
    /// <param name="span">The part of the line in the hull.</param>
    public static RayFinding Find(
        in Double3 foot, in Double3 direction, ConvexHull hull, HullPlanes planes, out RaySpan span)
    {
        span = RaySpan.Everything;
        double length = direction.LargestMagnitude, size = hull.BoundingRadius;
        bool isLeft = Clip(foot, direction, planes.Blocks, length, size, ref span, out int entry);
        if (entry == Along) return RayFinding.Unfit;
        if (!isLeft || !(span.Enter <= span.Exit) || entry < 0) return RayFinding.Missed;
        double[] blocks = planes.Blocks;
        span.Normal = new Double3(
            blocks[entry], blocks[entry + HullPlanes.Lanes], blocks[entry + 2 * HullPlanes.Lanes]);
        return RayFinding.Found;
    }

    private static bool Clip(
        in Double3 foot, in Double3 direction, double[] blocks, double length, double size, ref RaySpan span,
        out int entry)
    {
#if NET
        if (Vector256.IsHardwareAccelerated)
            return ClipLanes(foot, direction, blocks, length, size, ref span, out entry);
#endif
        entry = -1;
        bool isLeft = true, isAlong = false;
        for (int block = 0; block < blocks.Length; block += HullPlanes.BlockDoubles)
        {
            for (int i = block; i < block + HullPlanes.Lanes; i++)
            {
                double x = blocks[i], y = blocks[i + HullPlanes.Lanes], z = blocks[i + 2 * HullPlanes.Lanes];
                double below = blocks[i + 3 * HullPlanes.Lanes] - (x * foot.X + y * foot.Y + z * foot.Z);
                double slope = x * direction.X + y * direction.Y + z * direction.Z, t = below / slope;
                if (slope < 0 && t > span.Enter)
                {
                    span.Enter = t;
                    entry = i;
                }

                if (slope > 0 && t < span.Exit) span.Exit = t;
                if (slope == 0 && below < 0) isLeft = false;
                isAlong |= RayGraze.IsAlong(below, slope, length, size);
            }
        }

        if (isAlong) entry = Along;
        return isLeft;
    }

#if NET
    /// <summary>The same with four planes at a time.</summary>
    private static bool ClipLanes(
        in Double3 foot, in Double3 direction, double[] blocks, double length, double size, ref RaySpan span,
        out int entry)
    {
        Vector256<double> fx = Vector256.Create(foot.X), fy = Vector256.Create(foot.Y), fz = Vector256.Create(foot.Z);
        Vector256<double> dx = Vector256.Create(direction.X), dy = Vector256.Create(direction.Y);
        Vector256<double> dz = Vector256.Create(direction.Z), none = Vector256<double>.Zero;
        Vector256<double> enter = Vector256.Create(span.Enter), exit = Vector256.Create(span.Exit), above = none;
        Vector256<double> entries = Vector256.Create(-1.0), index = Vector256.Create(0.0, 1, 2, 3);
        Vector256<double> step = Vector256.Create((double)HullPlanes.BlockDoubles), along = none;
        Vector256<double> flattest = Vector256.Create(RayGraze.LeastSlope * length), twice = Vector256.Create(2.0);
        Vector256<double> lengths = Vector256.Create(length), sizes = Vector256.Create(size);
        Vector256<double> error = Vector256.Create(RayGraze.FootError * length);
        Debug.Assert(blocks.Length % HullPlanes.BlockDoubles == 0);
        ref double first = ref MemoryMarshal.GetArrayDataReference(blocks);
        for (nuint i = 0; i < (nuint)blocks.Length; i += HullPlanes.BlockDoubles)
        {
            var x = Vector256.LoadUnsafe(ref first, i);
            var y = Vector256.LoadUnsafe(ref first, i + HullPlanes.Lanes);
            var z = Vector256.LoadUnsafe(ref first, i + 2 * HullPlanes.Lanes);
            Vector256<double> below = Vector256.LoadUnsafe(ref first, i + 3 * HullPlanes.Lanes)
                - (x * fx + y * fy + z * fz);
            Vector256<double> slope = x * dx + y * dy + z * dz, t = below / slope;
            Vector256<double> isEntry = Vector256.LessThan(slope, none) & Vector256.GreaterThan(t, enter);
            Vector256<double> isExit = Vector256.GreaterThan(slope, none) & Vector256.LessThan(t, exit);
            Vector256<double> flat = Vector256.Abs(slope), isFlat = Vector256.LessThanOrEqual(flat, flattest);
            if (isFlat.ExtractMostSignificantBits() != 0)
            {
                above |= Vector256.Equals(slope, none) & Vector256.LessThan(below, none);
                along |= isFlat
                    & Vector256.LessThanOrEqual(Vector256.Abs(below) * lengths, (twice * flat + error) * sizes);
            }

            enter = Vector256.ConditionalSelect(isEntry, t, enter);
            entries = Vector256.ConditionalSelect(isEntry, index, entries);
            exit = Vector256.ConditionalSelect(isExit, t, exit);
            index += step;
        }

        // The latest entry, of several the first; the earliest exit.
        Vector256<double> latest = Vector256.Max(enter, Swapped(enter)), earliest = Vector256.Min(exit, Swapped(exit));
        span.Enter = Math.Max(latest.GetElement(0), latest.GetElement(2));
        span.Exit = Math.Min(earliest.GetElement(0), earliest.GetElement(2));
        index = Vector256.ConditionalSelect(
            Vector256.Equals(enter, Vector256.Create(span.Enter)), entries, Vector256.Create(double.MaxValue));
        index = Vector256.Min(index, Swapped(index));
        entry = along.ExtractMostSignificantBits() != 0
            ? Along
            : (int)Math.Min(index.GetElement(0), index.GetElement(2));
        return above.ExtractMostSignificantBits() == 0;
    }

    /// <summary>Each lane's neighbour.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector256<double> Swapped(Vector256<double> v) =>
        Vector256.Shuffle(v, Vector256.Create(1L, 0, 3, 2));
#endif
}
