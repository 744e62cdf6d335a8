namespace Gjk.Core;

/// <summary>
/// Asks the shapes whether a surface that was worked out from a face is theirs: a support in the direction in which it
/// looks may reach no further than it does.
/// </summary>
/// <remarks>
/// A face with its margin is part of the shape, so the shape reaches at least as far. It may reach further beside the
/// face: where a neighbour is nearly as level, where a disc's rim runs beyond the corners that it is shown by, or where
/// a face that rounding has bent is not flat.
/// </remarks>
internal static class ContactProof
{
    /// <summary>
    /// Length, as a fraction of the pair's size: how far a surface may be off; what hulls join to one face differs by
    /// as much. Pinned by MarginContactTests.
    /// </summary>
    private const double MostError = 1e-6;

    /// <summary>Whether nothing of A reaches beyond its surface at a place.</summary>
    public static bool HoldsOnA<T>(ref T a, in ContactPlane plane, in SurfacePoint surface, double u, double v)
        where T : struct, ISupportMap
    {
        Vector3D outward = plane.Direction(surface.NormalU, surface.NormalV, surface.NormalHeight);
        a.Support(outward, out Vector3D point);
        double reach = Vector3D.Dot(outward, plane.OfA(point)) + plane.Frame.MarginA;
        return reach - Shown(surface, u, v) <= MostError * plane.Size;
    }

    /// <summary>The same for B, whose surface looks and reaches against the normal.</summary>
    public static bool HoldsOnB<T>(ref T b, in ContactPlane plane, in SurfacePoint surface, double u, double v)
        where T : struct, ISupportMap
    {
        Vector3D outward = plane.Direction(surface.NormalU, surface.NormalV, -surface.NormalHeight);
        b.Support(plane.Frame.Rotation.InverseRotate(outward), out Vector3D point);
        double reach = Vector3D.Dot(outward, plane.OfB(point)) + plane.Frame.MarginB;
        return reach - Shown(surface, u, v) <= MostError * plane.Size;
    }

    private static double Shown(in SurfacePoint surface, double u, double v) =>
        surface.NormalU * u + surface.NormalV * v + surface.NormalHeight * surface.Height;
}
