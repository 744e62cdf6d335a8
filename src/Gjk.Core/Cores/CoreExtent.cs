namespace Gjk.Core;

/// <summary>Measures a shape's core by its supports along the axes.</summary>
internal static class CoreExtent
{
    /// <summary>Ratio: 8 u, more than the squares, their sum and the root can lose (proofs/core-extent.g).</summary>
    private const double RoundingUp = 8.0 / (1L << 53);

    /// <summary>The furthest that the core's local bounding box reaches from the shape's centre: half its diagonal when
    /// the centre is its middle. Rounded up.</summary>
    public static double Radius<T>(ref T shape)
        where T : struct, ISupportMap
    {
        Box(ref shape, out Double3 min, out Double3 max);
        var reach = new Double3(Math.Max(max.X, -min.X), Math.Max(max.Y, -min.Y), Math.Max(max.Z, -min.Z));
        return reach.Length * (1 + RoundingUp);
    }

    /// <summary>The core's local bounding box, measured from its centre.</summary>
    public static void Box<T>(ref T shape, out Double3 min, out Double3 max)
        where T : struct, ISupportMap
    {
        shape.Support(new Double3(1, 0, 0), out Double3 right);
        shape.Support(new Double3(-1, 0, 0), out Double3 left);
        shape.Support(new Double3(0, 1, 0), out Double3 top);
        shape.Support(new Double3(0, -1, 0), out Double3 bottom);
        shape.Support(new Double3(0, 0, 1), out Double3 front);
        shape.Support(new Double3(0, 0, -1), out Double3 back);
        min = new Double3(left.X, bottom.Y, back.Z);
        max = new Double3(right.X, top.Y, front.Z);
    }
}
