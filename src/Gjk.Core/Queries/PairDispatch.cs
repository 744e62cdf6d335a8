#if NET
using System.Runtime.CompilerServices;

namespace Gjk.Core;

/// <summary>
/// Unwraps boxes and meshes, so that supports need not switch on the shape's kind. For all other types the answers are
/// known when the code is compiled.
/// </summary>
internal static class PairDispatch
{
    /// <summary>What a shape can be unwrapped to.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static CoreKind KindOf<T>(ref T shape)
        where T : struct, ISupportMap
    {
        if (typeof(T) == typeof(ConvexShape)) return Unsafe.As<T, ConvexShape>(ref shape).Core;
        if (typeof(T) == typeof(BoxShape)) return CoreKind.Box;
        return typeof(T) == typeof(ConvexMesh) ? Unsafe.As<T, ConvexMesh>(ref shape).Core : CoreKind.Other;
    }

    /// <summary>The box that a shape is.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Get<T>(ref T shape, out BoxCore box)
        where T : struct, ISupportMap
    {
        if (typeof(T) == typeof(ConvexShape)) Unsafe.As<T, ConvexShape>(ref shape).Get(out box);
        else if (typeof(T) == typeof(ConvexMesh)) Unsafe.As<T, ConvexMesh>(ref shape).Get(out box);
        else Unsafe.As<T, BoxShape>(ref shape).Get(out box);
    }

    /// <summary>The mesh that a shape is.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Get<T>(ref T shape, out HullCore hull)
        where T : struct, ISupportMap
    {
        if (typeof(T) == typeof(ConvexShape)) Unsafe.As<T, ConvexShape>(ref shape).Get(out hull);
        else Unsafe.As<T, ConvexMesh>(ref shape).Get(out hull);
    }
}
#endif
