namespace Gjk.Core;

/// <summary>A line against a box: three slabs (Kay and Kajiya 1986; Ericson 2005, section 5.3.3).</summary>
internal static class RayBox
{
    /// <summary>Whether it is more than a line or a point.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool IsSolid(in Double3 half) => half.X * half.Y + half.Y * half.Z + half.Z * half.X > 0;

    /// <summary>Whether the line runs along a side.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool IsAlongSide(in LocalRay ray, in Double3 half)
    {
        double length = ray.Direction.LargestMagnitude, size = half.X + half.Y + half.Z;
        return RayGraze.IsAlongSlab(half.X, ray.Foot.X, ray.Direction.X, length, size)
            | RayGraze.IsAlongSlab(half.Y, ray.Foot.Y, ray.Direction.Y, length, size)
            | RayGraze.IsAlongSlab(half.Z, ray.Foot.Z, ray.Direction.Z, length, size);
    }

    /// <summary>The part of the line in the box. A choice between numbers is no branch: which slab the line enters last
    /// is not to be guessed.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool TryFind(in LocalRay ray, in Double3 half, out RaySpan span)
    {
        Double3 slope = ray.Direction, foot = ray.Foot;
        span = RaySpan.Everything;
        if (slope.X == 0 | slope.Y == 0 | slope.Z == 0)
        {
            return span.Clip(half.X, foot.X, slope.X, new Double3(1, 0, 0))
                && span.Clip(half.Y, foot.Y, slope.Y, new Double3(0, 1, 0))
                && span.Clip(half.Z, foot.Z, slope.Z, new Double3(0, 0, 1));
        }

        double ix = 1 / slope.X, iy = 1 / slope.Y, iz = 1 / slope.Z;
        double x = BranchFree.WithSign(half.X, slope.X), y = BranchFree.WithSign(half.Y, slope.Y);
        double z = BranchFree.WithSign(half.Z, slope.Z);
        double enterX = (-x - foot.X) * ix, enterY = (-y - foot.Y) * iy, enterZ = (-z - foot.Z) * iz;
        span.Enter = Math.Max(Math.Max(enterX, enterY), enterZ);
        span.Exit = Math.Min(Math.Min((x - foot.X) * ix, (y - foot.Y) * iy), (z - foot.Z) * iz);
        bool isX = enterX == span.Enter, isY = enterY == span.Enter;
        var axis = new Double3(isX ? 1 : 0, isY && !isX ? 1 : 0, isX || isY ? 0 : 1);
        span.Normal = (isX ? slope.X : isY ? slope.Y : slope.Z) > 0 ? -axis : axis;
        return span.Enter <= span.Exit;
    }
}
