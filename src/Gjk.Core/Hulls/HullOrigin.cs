namespace Gjk.Core;

/// <summary>Chooses the point from which a hull counts its coordinates, so that no digit is spent on its distance from
/// the local origin.</summary>
/// <remarks>
/// A support compares dot products, and their rounding grows with the coordinates. For a mesh modelled far from its
/// local origin that rounding would exceed the differences between its vertices. Per axis there are two cases.
/// <list type="bullet">
/// <item>All coordinates have one sign, and the largest magnitude is at most twice the least. The origin is the float
/// nearest the middle. The difference of two floats that lie within a factor of two of each other is a float without
/// rounding (Sterbenz 1974). Adding the origin back gives the coordinate, bit for bit.</item>
/// <item>Otherwise the origin is 0. The extent then exceeds half the largest magnitude.</item>
/// </list>
/// In both cases a coordinate is at most twice the extent, that is four half extents.
/// </remarks>
internal static class HullOrigin
{
    public static Vector3 Of(in Aabb bounds) => new(
        Of(bounds.Min.X, bounds.Max.X),
        Of(bounds.Min.Y, bounds.Max.Y),
        Of(bounds.Min.Z, bounds.Max.Z));

    private static float Of(float min, float max)
    {
        bool oneSign = min > 0 || max < 0;
        float least = Math.Min(Math.Abs(min), Math.Abs(max)), largest = Math.Max(Math.Abs(min), Math.Abs(max));
        return oneSign && largest <= 2 * least ? (float)(((double)min + max) * 0.5) : 0;
    }
}
