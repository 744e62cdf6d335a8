using System.Runtime.CompilerServices;

namespace Gjk.Core;

/// <summary>
/// The support function of the Minkowski difference: the two shapes intersect exactly when A - B holds the origin, and
/// its point nearest the origin is the vector between the closest points (Gilbert, Johnson and Keerthi 1988).
/// </summary>
internal static class MinkowskiDifference
{
    /// <summary>
    /// The vertex of A - B that lies furthest against <paramref name="normal"/>, that is nearest the origin along it:
    /// A's furthest point against the normal less B's furthest point along it.
    /// </summary>
    /// <param name="a">The first shape.</param>
    /// <param name="b">The second shape.</param>
    /// <param name="frame">Where B is, seen from A.</param>
    /// <param name="normal">In A's frame, of any length.</param>
    /// <param name="idA">The id of A's support point; -1 where it has none.</param>
    /// <param name="idB">The same for B.</param>
    /// <param name="onA">The support point of A, from A's centre, in A's axes.</param>
    /// <param name="onB">The support point of B, from B's centre, in B's own axes.</param>
    /// <param name="w">The vertex: A's support point less B's, in A's frame.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Support<TA, TB>(
        ref TA a, ref TB b, in PairFrame frame, in Vector3D normal, out int idA, out int idB, out Vector3D onA,
        out Vector3D onB, out Vector3D w)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        idA = a.Support(-normal, out onA);
        idB = b.Support(frame.Rotation.InverseRotate(normal), out onB);
        w = VertexOf(frame, onA, onB);
    }

    /// <summary>The vertex made of a point of each shape, measured from its centre in its own axes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector3D VertexOf(in PairFrame frame, in Vector3D onA, in Vector3D onB) =>
        onA - (frame.Rotation.Rotate(onB) + frame.Translation);
}
