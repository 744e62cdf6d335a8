namespace Gjk.Core;

/// <summary>
/// What the forms of two shapes say about the shortest way out of each other before anything is searched: its
/// direction, or a plane that it lies in; the default says nothing. In A's axes.
/// </summary>
internal readonly struct WayOut
{
    /// <summary>
    /// Ratio, squared, of the offset's part across the axis to all of it: 2^-100, far below what rounding does to it.
    /// Shapes whose axes are so near each other may leave each other in any plane. Any amount below rounding will do.
    /// </summary>
    private const double Coaxial = 1.0 / (1L << 50) / (1L << 50);

    /// <summary>Of unit length: the direction, or the side of the plane's axis that the way out lies on.</summary>
    public readonly Vector3D Across;

    /// <summary>Of unit length: the plane's axis; 0 where the direction is known.</summary>
    public readonly Vector3D Axis;

    /// <summary>
    /// Length per radian: how much the shortest way out in such a plane may change as the plane turns about its axis; 0
    /// where the way out is in this one.
    /// </summary>
    public readonly double Slope;

    private WayOut(in Vector3D across, in Vector3D axis, double slope)
    {
        Across = across;
        Axis = axis;
        Slope = slope;
    }

    /// <summary>Whether anything is known.</summary>
    public bool IsKnown => Across != default;

    /// <summary>Whether all of it is known.</summary>
    public bool IsDirection => Axis == default;

    /// <summary>A direction of the plane.</summary>
    public Vector3D At(double across, double along) => Across * across + Axis * along;

    /// <summary>The direction is known.</summary>
    public static WayOut In(in Vector3D direction) => new(direction, default, 0);

    /// <summary>The way out is in a plane along an axis: the one towards B where the slope is 0, else in any.</summary>
    /// <param name="axis">Of unit length.</param>
    /// <param name="offset">From A's centre to B's.</param>
    /// <param name="slope">See <see cref="Slope"/>.</param>
    public static WayOut Along(in Vector3D axis, in Vector3D offset, double slope)
    {
        Vector3D across = offset - axis * Vector3D.Dot(axis, offset);
        return new WayOut(
            across.LengthSquared > Coaxial * offset.LengthSquared
                ? across * (1 / across.Length)
                : new PlaneBasis(axis).U,
            axis, slope);
    }

    /// <summary>The same plane, turned about its axis.</summary>
    public WayOut Turned(double angle)
    {
        SineCosine.Of(angle, out double sine, out double cosine);
        return new WayOut(Across * cosine + Vector3D.Cross(Axis, Across) * sine, Axis, Slope);
    }
}
