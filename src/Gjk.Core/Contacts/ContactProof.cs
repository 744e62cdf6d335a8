namespace Gjk.Core;

/// <summary>Asks the shapes whether a surface that was worked out from a face is theirs: a support in the direction in
/// which it looks may reach no further than it does.</summary>
/// <remarks>A face with its margin is part of the shape, so the shape reaches at least as far. It may reach further
/// beside the face: where a neighbour is nearly as level, where a disc's rim runs beyond the corners that it is shown
/// by, or where a face that rounding has bent is not flat.</remarks>
internal static class ContactProof
{
    /// <summary>Length, as a fraction of the pair's size: how far a surface may be off; what hulls join to one face
    /// differs by as much. Pinned by MarginContactTests.</summary>
    private const double MostError = 1e-6;

    /// <summary>Whether nothing of a shape reaches beyond its surface at a place.</summary>
    public static bool Holds<T>(
        ref T shape, bool isOfA, in ContactPlane plane, in SurfacePoint surface, double u, double v)
        where T : struct, ISupportMap
    {
        double up = isOfA ? surface.NormalHeight : -surface.NormalHeight;
        Double3 outward = plane.Direction(surface.NormalU, surface.NormalV, up);
        shape.Support(isOfA ? outward : plane.Frame.Rotation.InverseRotate(outward), out Double3 point);
        double reach = Double3.Dot(outward, plane.Of(point, isOfA)) + plane.MarginOf(isOfA);
        double shown = surface.NormalU * u + surface.NormalV * v + surface.NormalHeight * surface.Height;
        return reach - shown <= MostError * plane.Size;
    }
}
