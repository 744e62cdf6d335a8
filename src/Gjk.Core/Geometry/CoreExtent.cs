using System;

namespace Gjk.Core;

/// <summary>Measures a shape's core by its supports along the axes.</summary>
internal static class CoreExtent
{
    /// <summary>Ratio: 8 u, more than the differences, the squares, their sum and the root can lose.</summary>
    private const double RoundingUp = 8.0 / (1L << 53);

    /// <summary>The furthest that the core's local bounding box reaches from a point: half its diagonal when the point is its middle. Rounded up.</summary>
    public static double RadiusAbout<T>(in Vector3D center, ref T shape)
        where T : struct, ISupportMap
    {
        shape.Support(new Vector3D(1, 0, 0), -1, out Vector3D right);
        shape.Support(new Vector3D(-1, 0, 0), -1, out Vector3D left);
        shape.Support(new Vector3D(0, 1, 0), -1, out Vector3D top);
        shape.Support(new Vector3D(0, -1, 0), -1, out Vector3D bottom);
        shape.Support(new Vector3D(0, 0, 1), -1, out Vector3D front);
        shape.Support(new Vector3D(0, 0, -1), -1, out Vector3D back);
        var reach = new Vector3D(
            Math.Max(right.X - center.X, center.X - left.X),
            Math.Max(top.Y - center.Y, center.Y - bottom.Y),
            Math.Max(front.Z - center.Z, center.Z - back.Z));
        return reach.Length * (1 + RoundingUp);
    }
}
