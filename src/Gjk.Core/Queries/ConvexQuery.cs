using System.Runtime.CompilerServices;

namespace Gjk.Core;

/// <summary>The verbs: do two convex shapes overlap, how far apart are they, where are the closest points.</summary>
/// <remarks>
/// Every method is thread-safe, allocates nothing, never throws (exceptions of a shape of your own pass through) and ends on any input.
/// </remarks>
public static partial class ConvexQuery
{
    /// <summary>A reference to a readonly argument, so that calls on it make no copies; nothing writes through it but a shape's own mistakes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static ref T Inward<T>(in T shape, ref T copy)
        where T : struct
    {
#if NET
        return ref Unsafe.AsRef(in shape);
#else
        copy = shape;
        return ref copy;
#endif
    }

    /// <summary>Whether both are unscaled meshes held in a <see cref="ConvexShape"/>; known when the code is compiled to be false for all other types.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static bool AreMeshes<TA, TB>(ref TA a, ref TB b, out ConvexMesh meshA, out ConvexMesh meshB)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        meshA = default;
        meshB = default;
#if NET
        if (typeof(TA) == typeof(ConvexShape) && typeof(TB) == typeof(ConvexShape))
            return Unsafe.As<TA, ConvexShape>(ref a).TryGetMesh(out meshA) && Unsafe.As<TB, ConvexShape>(ref b).TryGetMesh(out meshB);
#endif
        return false;
    }

    /// <summary>The same for two boxes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static bool AreBoxes<TA, TB>(ref TA a, ref TB b, out BoxCore boxA, out BoxCore boxB)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        boxA = default;
        boxB = default;
#if NET
        if (typeof(TA) == typeof(ConvexShape) && typeof(TB) == typeof(ConvexShape))
            return Unsafe.As<TA, ConvexShape>(ref a).TryGetBox(out boxA) && Unsafe.As<TB, ConvexShape>(ref b).TryGetBox(out boxB);
#endif
        return false;
    }

    /// <summary>Neither is negative, NaN or infinite.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static bool AreMargins(double a, double b) => a >= 0 && b >= 0 && a + b <= double.MaxValue;

    /// <summary>The first normal: from B's centre to A's, or any where they coincide.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector3D FirstNormal(in RelativePose bInA)
    {
        Vector3D normal = -bInA.Translation;
        return normal.LengthSquared > 0 ? normal : new Vector3D(1, 0, 0);
    }

    /// <summary>Cold solve of the cores; what double cannot prove goes to extended precision.</summary>
    private static void SolveCores<TA, TB, TTrace>(
        ref TA a, ref TB b, in RelativePose bInA, double maxCoreDistance, ref GjkOutcome outcome, ref TTrace trace)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
        where TTrace : struct, IGjkTrace
    {
        outcome.Feature.Normal = FirstNormal(bInA);
        GjkDistance.Solve(ref a, ref b, bInA, maxCoreDistance, ref outcome, ref trace);
        if (outcome.Status == GjkStatus.IterationLimit)
            GjkExtendedPrecision.Solve(ref a, ref b, bInA, FirstNormal(bInA), maxCoreDistance, ref outcome, ref trace);
    }

    /// <summary>The same from a warm start's simplex or, for shapes without vertices, its normal.</summary>
    private static void SolveCoresWarm<TA, TB>(
        ref TA a, ref TB b, in RelativePose bInA, double maxCoreDistance, ref WarmStart warmStart, ref GjkOutcome outcome)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        warmStart.Restore(ref a, ref b, bInA, ref outcome.Simplex);
        Vector3D normal = warmStart.Normal;
        NoTrace trace = default;
        outcome.Feature.Normal = normal.LengthSquared > 0 ? normal : FirstNormal(bInA);
        GjkDistance.Solve(ref a, ref b, bInA, maxCoreDistance, ref outcome, ref trace);
        if (outcome.Status == GjkStatus.IterationLimit)
            GjkExtendedPrecision.Solve(ref a, ref b, bInA, FirstNormal(bInA), maxCoreDistance, ref outcome, ref trace);
        if (outcome.Status < GjkStatus.InvalidInput) warmStart.Store(outcome.Simplex, outcome.Feature.Normal);
    }

    /// <summary>The largest float that is not above x: a bound may be rounded in one direction only.</summary>
    internal static float RoundDown(double x)
    {
        float f = (float)x;
        if (f <= x) return f;
        if (float.IsInfinity(f)) return float.MaxValue;
        int bits = FloatBits(f);
        return BitsFloat(f > 0 ? bits - 1 : f < 0 ? bits + 1 : unchecked((int)0x80000001));
    }

    private static unsafe int FloatBits(float f) => *(int*)&f;

    private static unsafe float BitsFloat(int bits) => *(float*)&bits;
}
