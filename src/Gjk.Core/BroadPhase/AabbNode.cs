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

    /// <summary>Whether this box overlaps another one, whose upper corner is widened already, when one of the two is
    /// widened. The ends are added and rounded as <see cref="BoundsTable.Near"/> does it, so that what is near there is
    /// found here.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly bool IsNear(Vector3 min, Vector3 widenedMax, float margin) =>
        Min.X <= widenedMax.X && min.X <= (float)(Max.X + margin) &&
        Min.Y <= widenedMax.Y && min.Y <= (float)(Max.Y + margin) &&
        Min.Z <= widenedMax.Z && min.Z <= (float)(Max.Z + margin);

    /// <summary>Half the surface.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float Area(in AabbNode box) => Area(box.Max - box.Min);

    /// <summary>Half the surface of the box around both.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float UnionArea(in AabbNode a, in AabbNode b) =>
        Area(Vector3.Max(a.Max, b.Max) - Vector3.Min(a.Min, b.Min));

    /// <summary>By how much the sum of a box's three sides grows around another box.</summary>
    public static float LengthGrowth(in AabbNode box, in AabbNode other) =>
        Length(Vector3.Min(box.Min, other.Min), Vector3.Max(box.Max, other.Max)) - Length(box.Min, box.Max);

    /// <summary>The sum of the sides.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float Length(in Vector3 min, in Vector3 max) =>
        (float)(max.X - min.X) + (float)(max.Y - min.Y) + (float)(max.Z - min.Z);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static float Area(Vector3 d) => d.X * d.Y + d.Y * d.Z + d.Z * d.X;
}
