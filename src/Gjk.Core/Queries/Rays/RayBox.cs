using System.Runtime.CompilerServices;

namespace Gjk.Core;

/// <summary>A line against a box: three slabs (Kay and Kajiya 1986; Ericson 2005, section 5.3.3).</summary>
internal static class RayBox
{
    /// <summary>Whether the line runs along a side.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool IsAlongSide(in LocalRay ray, in Vector3D half)
    {
        double length = RayGraze.LengthOf(ray.Direction), size = half.X + half.Y + half.Z;
        return RayGraze.IsAlongSlab(half.X, ray.Foot.X, ray.Direction.X, length, size)
            | RayGraze.IsAlongSlab(half.Y, ray.Foot.Y, ray.Direction.Y, length, size)
            | RayGraze.IsAlongSlab(half.Z, ray.Foot.Z, ray.Direction.Z, length, size);
    }

    /// <summary>The part of the line in the box.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool TryFind(in LocalRay ray, in Vector3D half, out RaySpan span)
    {
        span = RaySpan.Everything;
        return span.Clip(half.X, ray.Foot.X, ray.Direction.X, new Vector3D(1, 0, 0))
            && span.Clip(half.Y, ray.Foot.Y, ray.Direction.Y, new Vector3D(0, 1, 0))
            && span.Clip(half.Z, ray.Foot.Z, ray.Direction.Z, new Vector3D(0, 0, 1));
    }
}
