namespace Gjk.Core.Tests.Support;

/// <summary>Compares every field of two results of casts; any two NaN are the same.</summary>
internal static class CastBits
{
    public static bool AreSame(in CastResult a, in CastResult b) =>
        a.Status == b.Status && a.Iterations == b.Iterations && Same(a.Fraction, b.Fraction) && Same(a.Point, b.Point)
        && Same(a.Normal, b.Normal) && Same(a.Depth, b.Depth);

    public static bool AreSame(in RayCastResult a, in RayCastResult b) =>
        a.Status == b.Status && a.Iterations == b.Iterations && Same(a.Distance, b.Distance) && Same(a.Point, b.Point)
        && Same(a.Normal, b.Normal) && Same(a.Depth, b.Depth);

    private static bool Same(Vector3 a, Vector3 b) => Same(a.X, b.X) && Same(a.Y, b.Y) && Same(a.Z, b.Z);

    private static bool Same(float a, float b) =>
        (float.IsNaN(a) && float.IsNaN(b)) || BitConverter.SingleToInt32Bits(a) == BitConverter.SingleToInt32Bits(b);
}
