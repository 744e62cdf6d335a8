using System.Runtime.CompilerServices;

namespace Gjk.Core;

/// <summary>
/// Unwraps two unscaled meshes or two boxes behind <see cref="ConvexShape"/>, so that supports need not switch on the
/// shape's kind. For all other types the answers are known to be false when the code is compiled.
/// </summary>
internal static class PairDispatch
{
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool AreMeshes<TA, TB>(ref TA a, ref TB b, out ConvexMesh meshA, out ConvexMesh meshB)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        meshA = default;
        meshB = default;
#if NET
        if (typeof(TA) == typeof(ConvexShape) && typeof(TB) == typeof(ConvexShape))
            return Unsafe.As<TA, ConvexShape>(ref a).TryGetMesh(out meshA)
                && Unsafe.As<TB, ConvexShape>(ref b).TryGetMesh(out meshB);
#endif
        return false;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool AreBoxes<TA, TB>(ref TA a, ref TB b, out BoxCore boxA, out BoxCore boxB)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        boxA = default;
        boxB = default;
#if NET
        if (typeof(TA) == typeof(ConvexShape) && typeof(TB) == typeof(ConvexShape))
            return Unsafe.As<TA, ConvexShape>(ref a).TryGetBox(out boxA)
                && Unsafe.As<TB, ConvexShape>(ref b).TryGetBox(out boxB);
#endif
        return false;
    }
}
