using System.Runtime.CompilerServices;

namespace Gjk.Core;

/// <summary>
/// The support function of the Minkowski difference: the two shapes intersect exactly when A - B holds the origin, and its point
/// nearest the origin is the vector between the closest points (Gilbert, Johnson and Keerthi 1988).
/// </summary>
internal static class MinkowskiDifference
{
    /// <summary>
    /// The vertex of A - B that lies furthest against <paramref name="normal"/>, that is nearest the origin along it: A's furthest point against the
    /// normal less B's furthest point along it. The vertex's ids come in as hints and go out as ids.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Support<TA, TB>(ref TA a, ref TB b, in RelativePose bInA, in Vector3D normal, ref MinkowskiVertex vertex)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        vertex.IdA = a.Support(-normal, vertex.IdA, out Vector3D onA);
        vertex.IdB = b.Support(bInA.Rotation.InverseRotate(normal), vertex.IdB, out Vector3D onB);
        Place(bInA, onA, onB, ref vertex);
    }

    /// <summary>Sets the vertex's coordinates from a point of each shape in its own frame.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Place(in RelativePose bInA, in Vector3D onA, in Vector3D onB, ref MinkowskiVertex vertex)
    {
        vertex.OnA = onA - bInA.CenterA;
        vertex.W = vertex.OnA - (bInA.Rotation.Rotate(onB - bInA.CenterB) + bInA.Translation);
    }
}
