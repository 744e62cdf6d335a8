using System.Numerics;
using System.Runtime.CompilerServices;

namespace Gjk.Core;

/// <summary>A box of a tree, and the children of an inner one; 32 bytes, so that two share a cache line.</summary>
internal struct AabbNode
{
    public Vector3 Min;
    public int Left;
    public Vector3 Max;
    public int Right;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly bool Meets(Vector3 min, Vector3 max) =>
        Min.X <= max.X && min.X <= Max.X && Min.Y <= max.Y && min.Y <= Max.Y && Min.Z <= max.Z && min.Z <= Max.Z;

    /// <summary>Half the surface.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float Area(in AabbNode box) => Area(box.Max - box.Min);

    /// <summary>Half the surface of the box around both.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float UnionArea(in AabbNode a, in AabbNode b) => Area(Vector3.Max(a.Max, b.Max) - Vector3.Min(a.Min, b.Min));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static float Area(Vector3 d) => d.X * d.Y + d.Y * d.Z + d.Z * d.X;
}
