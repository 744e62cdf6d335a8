using System;
using System.Numerics;

namespace Gjk.Core.Tests.Support;

/// <summary>Compares every field of two results; any two NaN are the same.</summary>
internal static class ResultBits
{
    public static bool AreSame(in DistanceResult a, in DistanceResult b) =>
        a.Status == b.Status && a.Iterations == b.Iterations && Same(a.Distance, b.Distance)
        && Same(a.LowerBound, b.LowerBound) && Same(a.PointA, b.PointA) && Same(a.PointB, b.PointB)
        && Same(a.Normal, b.Normal) && Same(a.LocalPointA, b.LocalPointA) && Same(a.LocalPointB, b.LocalPointB);

    private static bool Same(Vector3 a, Vector3 b) => Same(a.X, b.X) && Same(a.Y, b.Y) && Same(a.Z, b.Z);

    private static bool Same(float a, float b) =>
        (float.IsNaN(a) && float.IsNaN(b)) || BitConverter.SingleToInt32Bits(a) == BitConverter.SingleToInt32Bits(b);
}
