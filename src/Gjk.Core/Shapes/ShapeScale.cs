namespace Gjk.Core;

/// <summary>The scale of a <see cref="ConvexShape"/> that its own numbers cannot take. Immutable; few shapes have one,
/// so it is no part of all of them.</summary>
internal sealed class ShapeScale
{
    public readonly AxisScale Axes;

    /// <summary>The scaled centre, and what its rounding took away.</summary>
    public readonly Double3 Center, CenterError;

    public ShapeScale(in Double3 factors, in Double3 center)
    {
        Axes = new AxisScale(factors);
        Axes.ScaleCenter(center, out Center, out CenterError);
    }
}
