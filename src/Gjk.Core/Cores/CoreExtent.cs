using System;

namespace Gjk.Core;

/// <summary>Measures a shape's core by its supports along the axes.</summary>
internal static class CoreExtent
{
    /// <summary>Ratio: 8 u, more than the squares, their sum and the root can lose (proofs/core-extent.g).</summary>
    private const double RoundingUp = 8.0 / (1L << 53);

    /// <summary>
    /// The furthest that the core's local bounding box reaches from the shape's centre: half its diagonal when the
    /// centre is its middle. Rounded up.
    /// </summary>
    public static double Radius<T>(ref T shape)
        where T : struct, ISupportMap
    {
        Box(ref shape, out Vector3D min, out Vector3D max);
        var reach = new Vector3D(Math.Max(max.X, -min.X), Math.Max(max.Y, -min.Y), Math.Max(max.Z, -min.Z));
        return reach.Length * (1 + RoundingUp);
    }

    /// <summary>The core's local bounding box, measured from its centre.</summary>
    public static void Box<T>(ref T shape, out Vector3D min, out Vector3D max)
        where T : struct, ISupportMap
    {
        shape.Support(new Vector3D(1, 0, 0), out Vector3D right);
        shape.Support(new Vector3D(-1, 0, 0), out Vector3D left);
        shape.Support(new Vector3D(0, 1, 0), out Vector3D top);
        shape.Support(new Vector3D(0, -1, 0), out Vector3D bottom);
        shape.Support(new Vector3D(0, 0, 1), out Vector3D front);
        shape.Support(new Vector3D(0, 0, -1), out Vector3D back);
        min = new Vector3D(left.X, bottom.Y, back.Z);
        max = new Vector3D(right.X, top.Y, front.Z);
    }
}
